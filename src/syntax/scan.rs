//! What is read without pest: plain numbers and vectors of them, most of what long files are made of.
//!
//! The grammar says what they are, and a test that both ways give the same nodes. [`stretch`] finds the text
//! between them, which is pest's.

/// Pieces are not longer than this where they can be cut.
const LONGEST: usize = 1 << 16;
/// Up to this the integers and powers of ten that make a number are exact, so their quotient is its
/// nearest double.
const EXACT: u64 = 1 << 53;
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18,
    1e19, 1e20, 1e21, 1e22,
];

/// Whether a byte counts as a blank.
pub(super) fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t'..=b'\r' | 0 | 0x1a)
}

/// The first byte from `at` on that is no blank.
pub(super) fn skip_blanks(bytes: &[u8], mut at: usize) -> usize {
    while bytes.get(at).is_some_and(|&byte| is_blank(byte)) {
        at += 1;
    }
    at
}

/// Whether a number starts here.
pub(super) fn at_number(bytes: &[u8], at: usize) -> bool {
    match bytes.get(at) {
        Some(b'0'..=b'9') => true,
        Some(b'.') => bytes.get(at + 1).is_some_and(u8::is_ascii_digit),
        _ => false,
    }
}

/// The number that starts here, and where it ends; none before a second decimal point.
pub(super) fn number(bytes: &[u8], start: usize) -> Option<(f64, usize)> {
    let (mut at, mut digits, mut scale) = (start, 0_u64, 0_i32);
    let mut exact = true;
    let mut take = |at: &mut usize| {
        let first = *at;
        while let Some(&byte @ b'0'..=b'9') = bytes.get(*at) {
            exact &= digits < EXACT / 16;
            digits = digits.wrapping_mul(10).wrapping_add(u64::from(byte - b'0'));
            *at += 1;
        }
        *at - first
    };
    take(&mut at);
    if bytes.get(at) == Some(&b'.') {
        at += 1;
        scale = -(take(&mut at) as i32);
    }
    // `1e` and `1e+` are numbers in a scene but not in Rust.
    let mut end = at;
    if let Some(b'e' | b'E') = bytes.get(at) {
        at += 1;
        let minus = bytes.get(at) == Some(&b'-');
        at += usize::from(matches!(bytes.get(at), Some(b'+' | b'-')));
        let mut exponent = 0_i32;
        while let Some(&byte @ b'0'..=b'9') = bytes.get(at) {
            exponent = exponent.saturating_mul(10).saturating_add(i32::from(byte - b'0'));
            at += 1;
            end = at;
        }
        scale = scale.saturating_add(if minus { -exponent } else { exponent });
    }
    if bytes.get(at) == Some(&b'.') {
        return None;
    }
    let value = match POWERS.get(scale.unsigned_abs() as usize) {
        Some(power) if exact && scale < 0 => digits as f64 / power,
        Some(power) if exact => digits as f64 * power,
        _ => std::str::from_utf8(&bytes[start..end]).ok()?.parse().ok()?,
    };
    Some((value, at))
}

/// The vector of plain numbers that starts here: its numbers go to `numbers`. Gives how many there are, and
/// where it ends.
pub(super) fn vector(bytes: &[u8], start: usize, numbers: &mut Vec<f64>) -> Option<(u8, usize)> {
    let first = numbers.len();
    let found = components(bytes, start + 1, numbers);
    if found.is_none() {
        numbers.truncate(first);
    }
    found
}

fn components(bytes: &[u8], mut at: usize, numbers: &mut Vec<f64>) -> Option<(u8, usize)> {
    let mut len = 0;
    loop {
        at = skip_blanks(bytes, at);
        if bytes.get(at) == Some(&b'>') && len >= 2 {
            break;
        }
        let minus = bytes.get(at) == Some(&b'-');
        at += usize::from(matches!(bytes.get(at), Some(b'-' | b'+')));
        if len == 5 || !at_number(bytes, at) {
            return None;
        }
        let (value, end) = number(bytes, at)?;
        numbers.push(if minus { -value } else { value });
        len += 1;
        at = skip_blanks(bytes, end);
        match bytes.get(at)? {
            b',' => at += 1,
            b'>' if len >= 2 => break,
            _ => return None,
        }
    }
    // `>=` is one mark.
    (bytes.get(at + 1) != Some(&b'=')).then_some((len, at + 1))
}

/// Whether a vector of plain numbers may start here.
pub(super) fn at_vector(bytes: &[u8], at: usize) -> bool {
    if bytes.get(at) != Some(&b'<') {
        return false;
    }
    let at = skip_blanks(bytes, at + 1);
    at_number(bytes, at + usize::from(matches!(bytes.get(at), Some(b'-' | b'+'))))
}

/// The end of the text that starts here and is no plain number: where one starts, or a vector of them.
pub(super) fn stretch(bytes: &[u8], start: usize) -> usize {
    let mut at = start;
    if at_number(bytes, at) {
        // A number with two points, and whatever may belong to it.
        while bytes.get(at).is_some_and(|b| b.is_ascii_alphanumeric() || b"_.+-".contains(b)) {
            at += 1;
        }
    }
    // The word of a directive has to be read with its `#`.
    let mut after_hash = false;
    while let Some(&byte) = bytes.get(at) {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'_' => {
                at += 1;
                while bytes.get(at).is_some_and(|b| b.is_ascii_alphanumeric() || *b == b'_') {
                    at += 1;
                }
                after_hash = false;
            }
            b'"' => {
                at = string_end(bytes, at);
                after_hash = false;
            }
            b'/' if bytes.get(at + 1) == Some(&b'/') => {
                at += bytes[at..].iter().position(|&b| b == b'\n').unwrap_or(bytes.len() - at);
            }
            b'/' if bytes.get(at + 1) == Some(&b'*') => at = comment_end(bytes, at),
            _ if is_blank(byte) => {
                at += 1;
                if at - start >= LONGEST && !after_hash {
                    return at;
                }
            }
            _ if at_number(bytes, at) || at_vector(bytes, at) => return at,
            _ => {
                after_hash = byte == b'#';
                at += 1;
            }
        }
    }
    at
}

/// How many comments are inside each other at most, or a little more: those in strings count.
pub(super) fn depth_of_comments(bytes: &[u8]) -> usize {
    let (mut at, mut depth, mut deepest) = (0, 0, 0);
    while at + 1 < bytes.len() {
        match [bytes[at], bytes[at + 1]] {
            [b'/', b'*'] => {
                (at, depth) = (at + 2, depth + 1);
                deepest = deepest.max(depth);
            }
            [b'*', b'/'] if depth > 0 => (at, depth) = (at + 2, depth - 1),
            _ => at += 1,
        }
    }
    deepest
}

/// The end of the string that starts here.
fn string_end(bytes: &[u8], start: usize) -> usize {
    let mut at = start + 1;
    loop {
        match bytes.get(at) {
            Some(b'"') => return at + 1,
            // A backslash at the end of a line leaves the string without an end.
            Some(b'\\') if matches!(bytes.get(at + 1), Some(b'\n' | b'\r')) => return bytes.len(),
            Some(b'\\') => at += 2,
            Some(_) => at += 1,
            None => return bytes.len(),
        }
    }
}

/// The end of the comment that starts here, with those in it.
fn comment_end(bytes: &[u8], start: usize) -> usize {
    let (mut at, mut depth) = (start + 2, 1);
    while depth > 0 {
        match bytes.get(at..at + 2) {
            Some(b"/*") => (at, depth) = (at + 2, depth + 1),
            Some(b"*/") => (at, depth) = (at + 2, depth - 1),
            Some(_) => at += 1,
            None => return bytes.len(),
        }
    }
    at
}
