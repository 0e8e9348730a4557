//! `ppm` and `pgm` images: the portable formats, in text or in bytes.

use super::bytes::Bytes;
use super::file::{Decoded, Fault, Native, Raw, room};

/// Decodes a PPM or PGM, whichever the file says it is.
pub(super) fn read(bytes: &[u8]) -> Result<Decoded, Fault> {
    let mut file = Bytes(bytes);
    let (channels, text) = match file.take(2)? {
        b"P2" => (1, true),
        b"P3" => (3, true),
        b"P5" => (1, false),
        b"P6" => (3, false),
        _ => return Err("it is neither a PPM nor a PGM".into()),
    };
    let size = [number(&mut file)?, number(&mut file)?];
    let white = number(&mut file)?;
    let (Ok(white), true) = (u16::try_from(white), white > 0) else {
        return Err(format!("its brightest number is {white}, not 1 to 65535").into());
    };
    let wide = white > 255;
    let count = room(size, channels * if wide { 2 } else { 1 })? * channels;
    let mut words: Vec<u16> = Vec::with_capacity(count);
    if text {
        for _ in 0..count {
            words.push(u16::try_from(number(&mut file)?)?);
        }
    } else {
        // One blank ends the header.
        file.byte()?;
        let stored = file.take(if wide { 2 * count } else { count })?;
        if wide {
            words.resize(count, 0);
            for (word, stored) in words.iter_mut().zip(stored.as_chunks().0) {
                *word = u16::from_be_bytes(*stored);
            }
        } else {
            words.extend(stored.iter().copied().map(u16::from));
        }
    }
    let most = words.iter().fold(0, |most, word| most.max(*word));
    if most > white {
        return Err(format!("{most} is more than its brightest, {white}").into());
    }
    let raw = if wide {
        Raw::Words { channels, data: words }
    } else {
        Raw::Bytes { channels, data: words.into_iter().map(|word| word as u8).collect() }
    };
    let full = if wide { u16::MAX } else { 255 };
    let white = (white != full).then_some(white);
    Ok(Decoded { white, ..Decoded::new(size, raw, Native::Untouched) })
}

/// The next number in text, after blanks and comments.
fn number(file: &mut Bytes<'_>) -> Result<usize, Fault> {
    while let Some(&byte) = file.0.first() {
        match byte {
            b'#' => drop(file.line(b'\n')?),
            byte if byte.is_ascii_whitespace() => drop(file.byte()?),
            _ => break,
        }
    }
    let digits = file.0.iter().take_while(|byte| byte.is_ascii_digit()).count();
    let digits = file.take(digits)?;
    if digits.is_empty() {
        return Err(if file.0.is_empty() { "the file ends too early" } else { "there is no number" }.into());
    }
    Ok(std::str::from_utf8(digits)?.parse()?)
}
