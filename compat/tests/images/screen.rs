//! Formats for screens: PNG, GIF, TGA, BMP.

use png::{BitDepth, ColorType, Encoder, ScaledFloat, SrgbRenderingIntent};

use super::{Cases, HEIGHT, Noise, WIDTH};

/// Encodes a PNG; `data` is packed as it will be in the file.
fn png(
    color: ColorType,
    depth: BitDepth,
    data: &[u8],
    set: impl FnOnce(&mut Encoder<'_, &mut Vec<u8>>),
) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, WIDTH as u32, HEIGHT as u32);
    encoder.set_color(color);
    encoder.set_depth(depth);
    set(&mut encoder);
    encoder.write_header().unwrap().write_image_data(data).unwrap();
    bytes
}

#[test]
fn pngs_of_every_kind_have_povrays_numbers() {
    use BitDepth::{Eight, Four, One, Sixteen, Two};
    use ColorType::{Grayscale, GrayscaleAlpha, Rgb, Rgba};
    let mut noise = Noise(1);
    let mut cases = Cases::at_pixels();
    for (color, depth) in [
        (Grayscale, One),
        (Grayscale, Two),
        (Grayscale, Four),
        (Grayscale, Eight),
        (Grayscale, Sixteen),
        (Rgb, Eight),
        (Rgb, Sixteen),
        (GrayscaleAlpha, Eight),
        (GrayscaleAlpha, Sixteen),
        (Rgba, Eight),
        (Rgba, Sixteen),
    ] {
        let data = noise.bytes(WIDTH * color.samples() * depth as usize / 8 * HEIGHT);
        cases.usual(&format!("{color:?} {depth:?}"), "png", &png(color, depth, &data, |_| {}));
        let about = format!("{color:?} {depth:?} with sRGB");
        cases.usual(
            &about,
            "png",
            &png(color, depth, &data, |e| e.set_source_srgb(SrgbRenderingIntent::Perceptual)),
        );
        for gamma in [30000, 100_000] {
            let bytes = png(color, depth, &data, |e| e.set_source_gamma(ScaledFloat::from_scaled(gamma)));
            cases.usual(&format!("{color:?} {depth:?} with gAMA {gamma}"), "png", &bytes);
        }
    }
    // One transparent colour is not heeded.
    let data = noise.bytes(WIDTH * HEIGHT * 3);
    let clear = data[3..6].iter().flat_map(|&v| [0, v]).collect::<Vec<u8>>();
    cases.usual("RGB with tRNS", "png", &png(Rgb, Eight, &data, |e| e.set_trns(clear)));
    cases.compare(2e-16);
}

#[test]
fn palettes_of_pngs_have_povrays_numbers() {
    let mut noise = Noise(2);
    let mut cases = Cases::at_pixels();
    for depth in [BitDepth::One, BitDepth::Two, BitDepth::Four, BitDepth::Eight] {
        let colors = 1 << depth as usize;
        let data = noise.bytes(WIDTH * depth as usize / 8 * HEIGHT);
        let palette = noise.bytes(3 * colors);
        let plain = png(ColorType::Indexed, depth, &data, |e| e.set_palette(palette.clone()));
        cases.usual(&format!("palette of {colors}"), "png", &plain);
        let alpha = noise.bytes(colors.div_ceil(2));
        let clear = png(ColorType::Indexed, depth, &data, |encoder| {
            encoder.set_palette(palette);
            encoder.set_trns(alpha);
        });
        cases.usual(&format!("palette of {colors} with alpha"), "png", &clear);
        let name = cases.file("png", &clear);
        for after in [
            "filter 1, .3 transmit 0, .5",
            "transmit all .2 filter all .4 interpolate 2",
            "filter 0, 1 filter all .1",
        ] {
            cases.colors(&format!("palette of {colors}, {after}"), &format!("png \"{name}\" {after}"));
        }
        cases.values("index", &format!("png \"{name}\" use_index"));
    }
    cases.compare(2e-16);
}

#[test]
fn gifs_have_povrays_numbers() {
    let mut noise = Noise(3);
    let mut cases = Cases::at_pixels();
    for transparent in [None, Some(5)] {
        let palette = noise.bytes(37 * 3);
        let mut bytes = Vec::new();
        let mut encoder = gif::Encoder::new(&mut bytes, WIDTH as u16, HEIGHT as u16, &palette).unwrap();
        let indices = noise.below(37, WIDTH * HEIGHT);
        let frame = gif::Frame::from_indexed_pixels(WIDTH as u16, HEIGHT as u16, indices, transparent);
        encoder.write_frame(&frame).unwrap();
        drop(encoder);
        cases.usual(&format!("GIF, transparent {transparent:?}"), "gif", &bytes);
        let name = cases.file("gif", &bytes);
        cases.colors("settings", &format!("gif \"{name}\" filter 3, .4 transmit 5, .2 filter 4, 1"));
    }
    cases.compare(2e-16);
}

/// A TGA; `packed` packs each row.
fn tga(kind: u8, bits: u8, descriptor: u8, map: (&[u8], usize, u8), pixels: &[u8], packed: bool) -> Vec<u8> {
    let mut bytes = vec![3, u8::from(!map.0.is_empty()), kind | u8::from(packed) << 3];
    bytes.extend([[0, 0], (map.1 as u16).to_le_bytes()].concat());
    bytes.extend([map.2, 0, 0, 0, 0, WIDTH as u8, 0, HEIGHT as u8, 0, bits, descriptor]);
    bytes.extend(b"abc");
    bytes.extend(map.0);
    let size = usize::from(bits).div_ceil(8);
    if !packed {
        bytes.extend(pixels);
        return bytes;
    }
    for row in pixels.chunks(WIDTH * size) {
        let mut row: Vec<_> = row.chunks(size).collect();
        while let Some(&first) = row.first() {
            let run = row.iter().take_while(|&&pixel| pixel == first).count();
            if run > 1 {
                bytes.push(0x80 | (run - 1) as u8);
                bytes.extend(first);
            } else {
                bytes.push(0);
                bytes.extend(first);
            }
            row.drain(..run);
        }
    }
    bytes
}

/// Pixels of some bytes each, of which some rows are of one colour.
fn partly_even(noise: &mut Noise, size: usize) -> Vec<u8> {
    let mut pixels = noise.bytes(WIDTH * HEIGHT * size);
    for row in pixels.chunks_mut(WIDTH * size).step_by(3) {
        let first = row[..size].to_vec();
        row[size..].chunks_mut(size).for_each(|pixel| pixel.copy_from_slice(&first));
    }
    pixels
}

#[test]
fn tgas_have_povrays_numbers() {
    let mut noise = Noise(4);
    let mut cases = Cases::at_pixels();
    for packed in [false, true] {
        for descriptor in [0, 0x20, 0x10, 8, 0x28] {
            for bits in [15, 16, 24, 32] {
                let pixels = partly_even(&mut noise, usize::from(bits).div_ceil(8));
                let bytes = tga(2, bits, descriptor, (&[], 0, 0), &pixels, packed);
                cases.usual(&format!("TGA {bits} bits, {descriptor:x}, packed {packed}"), "tga", &bytes);
            }
            let pixels = partly_even(&mut noise, 1);
            let bytes = tga(3, 8, descriptor, (&[], 0, 0), &pixels, packed);
            cases.usual(&format!("grey TGA, {descriptor:x}, packed {packed}"), "tga", &bytes);
        }
        for bits in [15, 16, 24, 32] {
            let map = noise.bytes(20 * usize::from(bits).div_ceil(8));
            let mut pixels = partly_even(&mut noise, 1);
            pixels.iter_mut().for_each(|index| *index %= 20);
            let bytes = tga(1, 8, 0, (&map, 20, bits), &pixels, packed);
            cases.usual(&format!("TGA palette of {bits} bits, packed {packed}"), "tga", &bytes);
            let name = cases.file("tga", &bytes);
            cases.colors("settings", &format!("tga \"{name}\" filter 3, .4 transmit 5, .2"));
        }
    }
    cases.compare(2e-16);
}

/// A BMP of Windows, or of OS/2 where `old`.
fn bmp(bits: u16, compression: u32, used: u32, palette: &[u8], data: &[u8], old: bool) -> Vec<u8> {
    let mut header: Vec<u8> = Vec::new();
    if old {
        header.extend(12_u32.to_le_bytes());
        header.extend([WIDTH as u16, HEIGHT as u16, 1, bits].into_iter().flat_map(u16::to_le_bytes));
    } else {
        header.extend([40, WIDTH as u32, HEIGHT as u32].into_iter().flat_map(u32::to_le_bytes));
        header.extend([1, bits].into_iter().flat_map(u16::to_le_bytes));
        header.extend(
            [compression, data.len() as u32, 2835, 2835, used, 0].into_iter().flat_map(u32::to_le_bytes),
        );
    }
    let start = 14 + header.len() + palette.len();
    let sizes = [(start + data.len()) as u32, 0, start as u32];
    let mut bytes = b"BM".to_vec();
    bytes.extend(sizes.into_iter().flat_map(u32::to_le_bytes));
    [bytes, header, palette.to_vec(), data.to_vec()].concat()
}

#[test]
fn bmps_have_povrays_numbers() {
    let mut noise = Noise(5);
    let mut cases = Cases::at_pixels();
    for bits in [4, 8] {
        let colors = 1 << bits;
        let data = noise.bytes(WIDTH * bits / 8 * HEIGHT);
        for (old, size) in [(false, 4), (true, 3)] {
            let palette = noise.bytes(colors * size);
            let bytes = bmp(bits as u16, 0, 0, &palette, &data, old);
            cases.usual(&format!("BMP of {bits} bits, old {old}"), "bmp", &bytes);
            let name = cases.file("bmp", &bytes);
            cases.colors("settings", &format!("bmp \"{name}\" filter 3, .4 transmit 5, .2"));
        }
    }
    for bytes in [3, 4] {
        let data = noise.bytes(WIDTH * bytes * HEIGHT);
        cases.usual(&format!("BMP of {bytes} bytes"), "bmp", &bmp(bytes as u16 * 8, 0, 0, &[], &data, false));
    }
    // A run, numbers as they are (an odd count of them), and a run that fills the row.
    for (compression, bits) in [(1, 8), (2, 4)] {
        let mut data = Vec::new();
        for _ in 0..HEIGHT {
            let counted = if bits == 8 { 5 } else { 3 };
            let run = noise.bytes(counted);
            data.extend([3, noise.byte(), 0, 5]);
            data.extend(run);
            data.push(0);
            data.extend([8, noise.byte(), 0, 0]);
        }
        data.extend([0, 1]);
        let palette = noise.bytes(4 << bits);
        let bytes = bmp(bits, compression, 0, &palette, &data, false);
        cases.usual(&format!("packed BMP of {bits} bits"), "bmp", &bytes);
    }
    cases.compare(2e-16);
}
