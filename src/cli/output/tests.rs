//! Encoded pictures, against what POV-Ray itself writes and against the decoders of the `image` crate.

use super::*;
use crate::render::film::Image;

/// The background of most probes.
const PROBE: [f32; 4] = [0.5, 0.25, 0.7, 1.0];

fn encoding(format: Format) -> Encoding {
    Encoding {
        format,
        bits: 8,
        grey: false,
        alpha: false,
        dither: None,
        quality: 85,
        file_gamma: Gamma::Srgb,
        display_gamma: Gamma::Srgb,
    }
}

fn flat(pixel: [f32; 4], width: u32, height: u32) -> Image {
    Image { pixels: vec![pixel; (width * height) as usize], ..Image::new(width, height) }
}

/// A picture in which every pixel differs from its neighbours.
fn busy(width: u32, height: u32) -> Image {
    let mut image = Image::new(width, height);
    for (index, pixel) in image.pixels.iter_mut().enumerate() {
        let part = |step: usize| (index * step % 256) as f32 / 255.0;
        *pixel = if index % 5 < 2 { PROBE } else { [part(7), part(31), part(113), 1.0] };
    }
    image
}

fn encoded(image: &Image, encoding: &Encoding) -> Vec<u8> {
    encode(image, Some(Gamma::LINEAR), encoding).expect("the format holds the picture")
}

/// The first pixel of a PNG, and its header.
fn first_pixel(bytes: &[u8]) -> (Vec<u16>, ::png::Info<'static>) {
    let decoder = ::png::Decoder::new(std::io::Cursor::new(bytes));
    let mut reader = decoder.read_info().expect("a PNG");
    let mut data = vec![0; reader.output_buffer_size().expect("a small picture")];
    reader.next_frame(&mut data).expect("pixels");
    let info = reader.info().clone();
    let channels = info.color_type.samples();
    let values = match info.bit_depth {
        ::png::BitDepth::Sixteen => {
            data.chunks(2).take(channels).map(|pair| u16::from_be_bytes([pair[0], pair[1]])).collect()
        }
        _ => data.iter().take(channels).map(|byte| u16::from(*byte)).collect(),
    };
    (values, info)
}

/// The PNG rows of docs/spec/camera-image.md 12.
#[test]
fn png_samples_are_those_of_povray() {
    let rows: &[(u8, bool, &[u16], u8)] = &[
        (8, false, &[188, 137, 218], 8),
        (5, false, &[189, 140, 214], 8),
        (12, false, &[48187, 35192, 55981], 16),
        (16, false, &[48192, 35199, 55987], 16),
        (8, true, &[42369], 16),
    ];
    for (bits, grey, expected, depth) in rows {
        let encoding = Encoding { bits: *bits, grey: *grey, ..encoding(Format::Png) };
        let (pixel, info) = first_pixel(&encoded(&flat(PROBE, 2, 2), &encoding));
        assert_eq!(pixel, *expected, "{bits} bits");
        assert_eq!(info.bit_depth as u8, *depth);
    }
}

/// The metadata rows of docs/spec/camera-image.md 11.
#[test]
fn png_metadata_say_which_curve_the_numbers_follow() {
    let rows = [
        (Some(Gamma::LINEAR), Gamma::Srgb, Gamma::Srgb, [188, 137, 218], 45455, true),
        (Some(Gamma::LINEAR), Gamma::LINEAR, Gamma::Srgb, [128, 64, 179], 100_000, false),
        (Some(Gamma::LINEAR), Gamma::Power(2.2), Gamma::Srgb, [186, 136, 217], 45455, false),
        (Some(Gamma::LINEAR), Gamma::Power(1.005), Gamma::Srgb, [128, 64, 179], 100_000, false),
        (None, Gamma::Srgb, Gamma::Srgb, [128, 64, 179], 45455, true),
        (None, Gamma::Srgb, Gamma::LINEAR, [128, 64, 179], 100_000, false),
        (None, Gamma::LINEAR, Gamma::Srgb, [128, 64, 179], 45455, true),
    ];
    for (working, file_gamma, display_gamma, expected, gamma, srgb) in rows {
        let encoding = Encoding { file_gamma, display_gamma, ..encoding(Format::Png) };
        let bytes = encode(&flat(PROBE, 1, 1), working, &encoding).expect("a PNG");
        let (pixel, info) = first_pixel(&bytes);
        assert_eq!(pixel, expected);
        assert_eq!(info.gamma().map(::png::ScaledFloat::into_scaled), Some(gamma));
        assert_eq!(info.srgb.is_some(), srgb);
    }
}

/// Rows of docs/spec/camera-image.md 14; pixels are premultiplied, and rendered with `File_Gamma=1.0 +UA`.
#[test]
fn alpha_is_straight_and_grows_with_brightness() {
    let premultiplied =
        |color: [f32; 3], alpha: f32| [color[0] * alpha, color[1] * alpha, color[2] * alpha, alpha];
    let rows = [
        ([0.0, 0.0, 0.0, 0.0], [0, 0, 0, 0]),
        (premultiplied([0.5, 0.25, 0.7], 0.7), [128, 64, 179, 179]),
        (premultiplied([0.8, 0.4, 0.2], 0.4), [204, 102, 51, 102]),
        ([0.96, 0.48, 0.24, 0.4], [255, 206, 103, 152]),
    ];
    for (pixel, expected) in rows {
        let encoding = Encoding { alpha: true, file_gamma: Gamma::LINEAR, ..encoding(Format::Png) };
        assert_eq!(first_pixel(&encoded(&flat(pixel, 1, 1), &encoding)).0, expected, "{pixel:?}");
    }
    let grey = Encoding { alpha: true, grey: true, file_gamma: Gamma::LINEAR, ..encoding(Format::Png) };
    assert_eq!(first_pixel(&encoded(&flat([0.96, 0.48, 0.24, 0.4], 1, 1), &grey)).0, [65535, 39006]);
}

/// The PPM rows of docs/spec/camera-image.md 12.
#[test]
fn ppm_headers_and_samples_are_those_of_povray() {
    let rows: &[(u8, bool, &str)] = &[
        (8, false, "P6\n1 1\n255\n bc 89 da"),
        (16, false, "P6\n1 1\n65535\n bc 40 89 7f da b3"),
        (8, true, "P5\n1 1\n255\n 00 60"),
        (16, true, "P5\n1 1\n65535\n 60 24"),
    ];
    for (bits, grey, expected) in rows {
        let bytes =
            encoded(&flat(PROBE, 1, 1), &Encoding { bits: *bits, grey: *grey, ..encoding(Format::Ppm) });
        let header =
            bytes.iter().enumerate().filter(|(_, byte)| **byte == b'\n').nth(2).map_or(0, |(end, _)| end + 1);
        let samples: String = bytes[header..].iter().map(|byte| format!(" {byte:02x}")).collect();
        assert_eq!(format!("{}{samples}", String::from_utf8_lossy(&bytes[..header])), *expected);
    }
}

#[test]
fn every_format_of_eight_bits_is_read_back_as_it_was() {
    use image::ImageFormat::{Bmp, Png, Pnm, Tga};
    let image = busy(301, 7);
    let rows = [
        (Format::Png, Png),
        (Format::Ppm, Pnm),
        (Format::Targa, Tga),
        (Format::CompressedTarga, Tga),
        (Format::Bmp, Bmp),
    ];
    let expected = Samples::new(&image, Some(Gamma::LINEAR), &encoding(Format::Png)).bytes();
    for (format, decoder) in rows {
        let bytes = encoded(&image, &encoding(format));
        let decoded = image::load_from_memory_with_format(&bytes, decoder).expect("a picture").to_rgb8();
        assert_eq!((decoded.width(), decoded.height()), (301, 7));
        assert!(decoded.into_raw() == expected, "{format:?}");
    }
}

#[test]
fn alpha_survives_in_every_format_that_holds_it() {
    use image::ImageFormat::{Bmp, Png, Tga};
    for (format, decoder) in
        [(Format::Png, Png), (Format::Targa, Tga), (Format::CompressedTarga, Tga), (Format::Bmp, Bmp)]
    {
        let encoding = Encoding { alpha: true, file_gamma: Gamma::LINEAR, ..encoding(format) };
        let bytes = encoded(&flat([0.32, 0.16, 0.08, 0.4], 3, 2), &encoding);
        let decoded = image::load_from_memory_with_format(&bytes, decoder).expect("a picture").to_rgba8();
        assert_eq!(decoded.get_pixel(2, 1).0, [204, 102, 51, 102], "{format:?}");
    }
}

#[test]
fn jpeg_comes_close() {
    let bytes = encoded(&flat(PROBE, 16, 16), &encoding(Format::Jpeg));
    let decoded =
        image::load_from_memory_with_format(&bytes, image::ImageFormat::Jpeg).expect("a JPEG").to_rgb8();
    for (stored, expected) in decoded.get_pixel(8, 8).0.into_iter().zip([188_u8, 137, 218]) {
        assert!(stored.abs_diff(expected) <= 2, "{stored} for {expected}");
    }
}

#[test]
fn hdr_holds_light_and_ignores_the_curve_of_the_file() {
    let narrow = encoded(&flat(PROBE, 2, 1), &encoding(Format::Hdr));
    assert!(narrow.ends_with(&[0x80, 0x40, 0xb3, 0x80]));
    // POV-Ray's own bytes for `rgb <0.45, 0.26, 0.7>`, nine pixels wide.
    let wide = encoded(&flat([0.45, 0.26, 0.7, 1.0], 9, 1), &encoding(Format::Hdr));
    assert!(wide.ends_with(&[2, 2, 0, 9, 0x89, 0x73, 0x89, 0x42, 0x89, 0xb3, 0x89, 0x80]));

    // An old scene's `rgb <0.5, 0.25, 0.7>` is light as the display makes it.
    let old = encode(&flat(PROBE, 9, 1), None, &encoding(Format::Hdr)).expect("an HDR");
    assert!(old.ends_with(&[2, 2, 0, 9, 0x89, 0x6d, 0x89, 0x1a, 0x89, 0xe5, 0x89, 0x7f]));

    let image = busy(40, 3);
    let bytes = encoded(&image, &encoding(Format::Hdr));
    let decoded =
        image::load_from_memory_with_format(&bytes, image::ImageFormat::Hdr).expect("an HDR").to_rgb32f();
    for (pixel, original) in decoded.pixels().zip(&image.pixels) {
        let brightest = original[..3].iter().copied().fold(0.0, f32::max);
        for (stored, light) in pixel.0.into_iter().zip(original) {
            assert!((stored - light).abs() <= brightest / 64.0, "{stored} for {light}");
        }
    }
}

#[test]
fn exr_holds_premultiplied_light() {
    let encoding = Encoding { alpha: true, ..encoding(Format::Exr) };
    let bytes = encoded(&flat([0.25, 2.5, 0.125, 0.5], 3, 2), &encoding);
    let decoded = image::load_from_memory_with_format(&bytes, image::ImageFormat::OpenExr)
        .expect("an EXR")
        .to_rgba32f();
    assert_eq!(decoded.get_pixel(1, 1).0, [0.25, 2.5, 0.125, 0.5]);
}

/// POV-Ray's own samples: `+W6 +H4 +FP5 +TH…` over `background { rgb <0.435, 0.28, 0.71> }`, red channel.
#[test]
fn dithering_spreads_as_povray_spreads() {
    let rows = [
        ("B2", Gamma::LINEAR, "131413141314 141314131413 131413141314 141314131413"),
        ("B3", Gamma::LINEAR, "131413131413 141314141314 131414131414 131413131413"),
        ("B4", Gamma::LINEAR, "131413141314 141314131413 131413141314 141314131413"),
        ("B4", Gamma::Srgb, "212221222122 212122212121 212221222122 222122212221"),
        ("D1", Gamma::LINEAR, "131413141314 131413141314 131413141314 131413141314"),
        ("D2", Gamma::LINEAR, "131413141314 131413141314 141314131413 141314131413"),
        ("D2", Gamma::Srgb, "212221222121 212221212221 222121222122 222122212221"),
        ("FS", Gamma::LINEAR, "131413141314 131413141314 141314131413 141314131413"),
        ("FS", Gamma::Srgb, "212221222121 212221212221 212221222122 212221212221"),
    ];
    for (method, file_gamma, expected) in rows {
        let encoding =
            Encoding { bits: 5, dither: Dither::of_name(method), file_gamma, ..encoding(Format::Ppm) };
        let samples = Samples::new(&flat([0.435, 0.28, 0.71, 1.0], 6, 4), Some(Gamma::LINEAR), &encoding);
        let rows: Vec<String> = samples
            .values
            .chunks(18)
            .map(|row| row.iter().step_by(3).map(u16::to_string).collect())
            .collect();
        assert_eq!(rows.join(" "), expected, "{method} {file_gamma:?}");
    }
}

/// POV-Ray writes bitmaps from the last row to the first and spreads errors that way; its Bayer patterns stay.
#[test]
fn errors_rise_in_a_bitmap() {
    let image = busy(6, 5);
    let flipped = |rows: usize, pixels: &[[f32; 4]]| -> Vec<[f32; 4]> {
        pixels.chunks(pixels.len() / rows).rev().flatten().copied().collect()
    };
    let values = |image: &Image, format: Format, method: &str| {
        let encoding = Encoding { dither: Dither::of_name(method), ..encoding(format) };
        Samples::new(image, Some(Gamma::LINEAR), &encoding).values
    };
    let upside_down = Image { pixels: flipped(5, &image.pixels), ..image.clone() };
    for method in ["D1", "D2", "FS"] {
        let risen: Vec<u16> =
            values(&upside_down, Format::Png, method).chunks(6 * 3).rev().flatten().copied().collect();
        assert_eq!(values(&image, Format::Bmp, method), risen, "{method}");
    }
    assert_eq!(values(&image, Format::Bmp, "B3"), values(&image, Format::Png, "B3"));
}

#[test]
fn numbers_outside_the_range_and_no_numbers_at_all_are_stored_as_something() {
    for format in
        [Format::Png, Format::Ppm, Format::Bmp, Format::Jpeg, Format::Targa, Format::Hdr, Format::Exr]
    {
        for pixel in [[f32::NAN; 4], [f32::INFINITY; 4], [-1.0, 5.0, f32::NEG_INFINITY, 2.0]] {
            for dither in [None, Some(Dither::FloydSteinberg)] {
                let encoding = Encoding { alpha: format.has_alpha(), dither, ..encoding(format) };
                assert!(encode(&flat(pixel, 9, 2), Some(Gamma::LINEAR), &encoding).is_ok(), "{format:?}");
            }
        }
    }
}
