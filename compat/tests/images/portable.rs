//! Formats of numbers: PPM, PGM, TIFF, HDR, EXR.

use super::{Cases, HEIGHT, Noise, WIDTH};

#[test]
fn portable_maps_have_povrays_numbers() {
    let mut noise = Noise(6);
    let mut cases = Cases::at_pixels();
    for white in [1_u32, 3, 15, 100, 255, 256, 1000, 65535] {
        for (keyword, text, bytes, channels) in [("pgm", "P2", "P5", 1), ("ppm", "P3", "P6", 3)] {
            let mut number = || (u32::from(noise.byte()) << 8 | u32::from(noise.byte())) % (white + 1);
            let numbers: Vec<u32> = (0..WIDTH * HEIGHT * channels).map(|_| number()).collect();
            let words: Vec<_> = numbers.iter().map(u32::to_string).collect();
            let head = |magic| format!("{magic}\n# numbers\n{WIDTH} {HEIGHT}\n{white}\n");
            let whole = head(text) + &words.chunks(12).map(|line| line.join(" ") + "\n").collect::<String>();
            cases.usual(&format!("{text} {white}"), keyword, whole.as_bytes());
            let wide = if white > 255 { 2 } else { 4 - 1 };
            let stored = numbers.iter().flat_map(|n| n.to_be_bytes()[wide..].to_vec());
            let whole: Vec<u8> = head(bytes).into_bytes().into_iter().chain(stored).collect();
            cases.usual(&format!("{bytes} {white}"), keyword, &whole);
        }
    }
    cases.compare(2e-16);
}

/// A TIFF that is not compressed.
struct Tiff {
    bits: u16,
    channels: u16,
    /// What the numbers mean: 0 and 1 are grey, 2 is RGB, 3 a palette.
    meaning: u16,
    /// What a channel after the colours is: 1 for alpha that colours are multiplied by, 2 for other alpha.
    extra: Option<u16>,
    palette: Vec<u16>,
    data: Vec<u8>,
}

impl Tiff {
    fn bytes(&self) -> Vec<u8> {
        let mut after = Vec::new();
        let start = 8 + 2 + 12 * (9 + self.extra.iter().len() + usize::from(!self.palette.is_empty())) + 4;
        let mut entries: Vec<u8> = Vec::new();
        let mut entry = |tag: u16, kind: u16, values: &[u32]| {
            let stored: Vec<u8> = match kind {
                3 => values.iter().flat_map(|&v| (v as u16).to_le_bytes()).collect(),
                _ => values.iter().flat_map(|v| v.to_le_bytes()).collect(),
            };
            entries.extend([tag, kind].into_iter().flat_map(u16::to_le_bytes));
            entries.extend((values.len() as u32).to_le_bytes());
            if stored.len() > 4 {
                entries.extend(((start + after.len()) as u32).to_le_bytes());
                after.extend(stored);
            } else {
                entries.extend(stored.iter().copied().chain([0; 4]).take(4));
            }
        };
        entry(256, 4, &[WIDTH as u32]);
        entry(257, 4, &[HEIGHT as u32]);
        entry(258, 3, &vec![u32::from(self.bits); usize::from(self.channels)]);
        entry(259, 3, &[1]);
        entry(262, 3, &[u32::from(self.meaning)]);
        // The pixels come after everything else, at an even place that is known beforehand.
        let pixels = start + 8 * 4 + self.palette.len() * 2;
        entry(273, 4, &[pixels as u32]);
        entry(277, 3, &[u32::from(self.channels)]);
        entry(278, 4, &[HEIGHT as u32]);
        entry(279, 4, &[self.data.len() as u32]);
        if !self.palette.is_empty() {
            entry(320, 3, &self.palette.iter().map(|&v| u32::from(v)).collect::<Vec<_>>());
        }
        if let Some(extra) = self.extra {
            entry(338, 3, &[u32::from(extra)]);
        }
        let count = (entries.len() / 12) as u16;
        let mut bytes = b"II*\0\x08\0\0\0".to_vec();
        bytes.extend(count.to_le_bytes());
        bytes.extend(entries);
        bytes.extend([0; 4]);
        bytes.extend(after);
        bytes.resize(pixels, 0);
        bytes.extend(&self.data);
        bytes
    }
}

#[test]
fn tiffs_have_povrays_numbers() {
    let mut noise = Noise(7);
    let mut cases = Cases::at_pixels();
    for (about, bits, channels, meaning, extra) in [
        ("grey", 8, 1, 1, None),
        ("grey from white", 8, 1, 0, None),
        ("grey of 16 bits", 16, 1, 1, None),
        ("grey with alpha", 8, 2, 1, Some(2)),
        ("RGB", 8, 3, 2, None),
        ("RGB of 16 bits", 16, 3, 2, None),
        ("RGB with alpha", 8, 4, 2, Some(2)),
        ("RGB multiplied by alpha", 8, 4, 2, Some(1)),
        ("RGB of 16 bits with alpha", 16, 4, 2, Some(2)),
        ("palette", 8, 1, 3, None),
    ] {
        let colors = if meaning == 3 { 3 << bits } else { 0 };
        let palette = (0..colors).map(|_| u16::from_be_bytes([noise.byte(), noise.byte()])).collect();
        let data = noise.bytes(WIDTH * HEIGHT * usize::from(channels * bits) / 8);
        cases.usual(about, "tiff", &Tiff { bits, channels, meaning, extra, palette, data }.bytes());
    }
    cases.compare(2e-16);
}

#[test]
fn hdrs_have_povrays_numbers() {
    let mut noise = Noise(8);
    let mut cases = Cases::at_pixels();
    for (about, bits) in [("HDR", 0x80), ("HDR with short mantissas", 0)] {
        let mut pixels: Vec<[u8; 4]> = Vec::new();
        for _ in 0..WIDTH * HEIGHT {
            let exponent = [120, 127, 128, 129, 130, 140, 0, 133][usize::from(noise.byte()) % 8];
            pixels.push([noise.byte() | bits, noise.byte(), noise.byte(), exponent]);
        }
        let head = format!("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=2.0\n\n-Y {HEIGHT} +X {WIDTH}\n");
        let flat = [head.as_bytes(), pixels.as_flattened()].concat();
        cases.usual(&format!("{about}, flat"), "hdr", &flat);
        let mut packed = head.into_bytes();
        for row in pixels.chunks_mut(WIDTH) {
            let first = row[0];
            row[..5].fill(first);
            packed.extend([2, 2, 0, WIDTH as u8]);
            for channel in 0..4 {
                packed.extend([128 + 5, first[channel], (WIDTH - 5) as u8]);
                packed.extend(row[5..].iter().map(|pixel| pixel[channel]));
            }
        }
        cases.usual(&format!("{about}, packed"), "hdr", &packed);
    }
    cases.compare(2e-16);
}

/// An EXR that is not compressed, of 32 or 16 bits; the data window may start anywhere.
fn exr(channels: &str, half: bool, start: i32, value: &mut impl FnMut() -> f32) -> Vec<u8> {
    let attribute = |name: &str, kind: &str, data: &[u8]| {
        [name.as_bytes(), b"\0", kind.as_bytes(), b"\0", &(data.len() as u32).to_le_bytes(), data].concat()
    };
    let window = |start: i32| {
        let end = [start + WIDTH as i32 - 1, start + HEIGHT as i32 - 1];
        [start, start, end[0], end[1]].into_iter().flat_map(i32::to_le_bytes).collect::<Vec<_>>()
    };
    let kind: u32 = if half { 1 } else { 2 };
    let list = channels.bytes().flat_map(|name| {
        let numbers = [kind, 0, 1, 1].into_iter().flat_map(u32::to_le_bytes);
        [name, 0].into_iter().chain(numbers).collect::<Vec<_>>()
    });
    let list: Vec<u8> = list.chain([0]).collect();
    let mut bytes = [20_000_630_u32, 2].into_iter().flat_map(u32::to_le_bytes).collect::<Vec<_>>();
    bytes.extend(attribute("channels", "chlist", &list));
    bytes.extend(attribute("compression", "compression", &[0]));
    bytes.extend(attribute("dataWindow", "box2i", &window(start)));
    bytes.extend(attribute("displayWindow", "box2i", &window(0)));
    bytes.extend(attribute("lineOrder", "lineOrder", &[0]));
    bytes.extend(attribute("pixelAspectRatio", "float", &1_f32.to_le_bytes()));
    bytes.extend(attribute("screenWindowCenter", "v2f", &[0; 8]));
    bytes.extend(attribute("screenWindowWidth", "float", &1_f32.to_le_bytes()));
    bytes.push(0);
    let line = WIDTH * channels.len() * if half { 2 } else { 4 };
    let first = bytes.len() + 8 * HEIGHT;
    bytes.extend((0..HEIGHT).flat_map(|y| ((first + y * (8 + line)) as u64).to_le_bytes()));
    for y in 0..HEIGHT {
        bytes.extend((start + y as i32).to_le_bytes());
        bytes.extend((line as u32).to_le_bytes());
        for _ in 0..WIDTH * channels.len() {
            let bits = value().to_bits();
            // The values have no more digits than 16 bits hold.
            let short = (bits >> 16 & 0x8000) | (bits >> 13).wrapping_sub(112 << 10) & 0x7fff;
            bytes.extend(&if half { short.to_le_bytes()[..2].to_vec() } else { bits.to_le_bytes().to_vec() });
        }
    }
    bytes
}

/// POV-Ray keeps 16 bits of each number, povista all: the numbers here have no more.
#[test]
fn exrs_have_povrays_numbers() {
    let mut noise = Noise(9);
    let mut value = || (f32::from(noise.byte()) + 64.0) / 128.0;
    let mut cases = Cases::at_pixels();
    for half in [true, false] {
        for channels in ["BGR", "ABGR", "Y", "AY", "GR"] {
            cases.usual(&format!("{channels}, half {half}"), "exr", &exr(channels, half, 0, &mut value));
        }
    }
    cases.usual("window elsewhere", "exr", &exr("BGR", true, 3, &mut value));
    cases.compare(2e-16);
}
