//! Image files of every format, whole and broken (docs/spec/patterns-textures.md 6).

use std::fs;
use std::path::Path;

use image::{DynamicImage, ImageFormat, Rgb, RgbImage};
use povista::math::{DVec2, DVec3};
use povista::world::texture::Sample;

use super::{folder, pigment, texture};

/// The colour that an `image_map` has in the middle of the unit square.
fn middle(folder: &Path, map: &str) -> [f64; 5] {
    let mut color = [0.0; 5];
    let function = pigment(&format!("image_map{{{map}}}"), folder).unwrap();
    function.call_vector(&[0.5, 0.5, 0.0], &mut color);
    color
}

fn close(found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len());
    for (f, e) in found.iter().zip(expected) {
        assert!((f - e).abs() < 6e-10, "{found:?} is not {expected:?}");
    }
}

/// Writes a PNG of one pixel, prepared by `set`.
fn png(path: &Path, color: png::ColorType, pixel: &[u8], set: impl FnOnce(&mut png::Encoder<'_, fs::File>)) {
    let mut encoder = png::Encoder::new(fs::File::create(path).unwrap(), 1, 1);
    encoder.set_color(color);
    encoder.set_depth(png::BitDepth::Eight);
    set(&mut encoder);
    encoder.write_header().unwrap().write_image_data(pixel).unwrap();
}

#[test]
fn pngs_are_decoded_by_the_curve_they_name() {
    let folder = folder();
    let file = folder.path().join("a.png");
    let rgb = [122, 174, 183];
    let color = || middle(folder.path(), "png \"a.png\"")[..3].to_vec();
    png(&file, png::ColorType::Rgb, &rgb, |_| {});
    close(&color(), &[0.194617808, 0.423267752, 0.473531544]);
    png(&file, png::ColorType::Rgb, &rgb, |e| e.set_source_srgb(png::SrgbRenderingIntent::Perceptual));
    close(&color(), &[0.194617808, 0.423267752, 0.473531544]);
    png(&file, png::ColorType::Rgb, &rgb, |e| e.set_source_gamma(png::ScaledFloat::from_scaled(45455)));
    close(&color(), &[0.197519615, 0.431343853, 0.481955767]);
    png(&file, png::ColorType::Rgb, &rgb, |e| e.set_source_gamma(png::ScaledFloat::from_scaled(100000)));
    close(&color(), &[0.478431374, 0.682352960, 0.717647076]);
}

#[test]
fn grey_pngs_lose_what_they_lose_in_povray() {
    let folder = folder();
    let file = folder.path().join("a.png");
    let rows = [(1, 0, 1), (3, 0, 2), (12, 0, 11), (13, 1, 13), (22, 2, 22), (64, 13, 64), (200, 147, 199)];
    for (stored, decoded, untouched) in rows {
        png(&file, png::ColorType::Grayscale, &[stored], |_| {});
        close(&middle(folder.path(), "png \"a.png\"")[..1], &[f64::from(decoded as f32 / 255.0)]);
        close(&middle(folder.path(), "png \"a.png\" gamma 1.0")[..1], &[f64::from(untouched as f32 / 255.0)]);
    }
}

#[test]
fn palettes_keep_their_transparency_and_take_settings() {
    let folder = folder();
    let file = folder.path().join("a.png");
    png(&file, png::ColorType::Indexed, &[1], |encoder| {
        encoder.set_palette(vec![0, 0, 0, 255, 255, 255]);
        encoder.set_trns(vec![255, 128]);
    });
    close(&middle(folder.path(), "png \"a.png\""), &[1.0, 1.0, 1.0, 0.0, 0.498039216]);
    let set = middle(folder.path(), "png \"a.png\" filter 1, 0.25 transmit all 0.5 filter 0, 1");
    close(&set, &[1.0, 1.0, 1.0, 0.25, 0.5]);
    png(&file, png::ColorType::Rgb, &[9, 9, 9], |_| {});
    assert!(pigment("image_map{png \"a.png\" filter 1, 0.25}", folder.path()).is_err());
}

#[test]
fn material_maps_select_by_index_or_by_red() {
    let folder = folder();
    let file = folder.path().join("a.png");
    let selected = || {
        let text = "plane{z,0 texture{material_map{png \"a.png\" \
            texture{pigment{rgb 0}} texture{pigment{rgb 1}} texture{pigment{rgb 2}}}}}";
        let sample = Sample::on_surface(DVec3::new(0.5, 0.5, 0.0), -DVec3::Z, DVec3::Z, DVec2::ZERO);
        let mut found = Vec::new();
        texture(text, folder.path()).unwrap().resolve(&sample, &mut |weight, layers, sample| {
            found.push((weight, layers[0].pigment.color(sample).unwrap().rgb.x));
        });
        let [(1.0, red)] = found[..] else { panic!("{found:?}") };
        red
    };
    for (index, expected) in [(0, 0.0), (1, 1.0), (2, 2.0), (3, 2.0), (5, 2.0), (6, 0.0)] {
        let set = |e: &mut png::Encoder<'_, fs::File>| e.set_palette(vec![7; 8 * 3]);
        png(&file, png::ColorType::Indexed, &[index], set);
        assert_eq!(selected(), expected, "index {index}");
    }
    for (red, expected) in [(122, 2.0), (197, 2.0), (253, 1.0)] {
        png(&file, png::ColorType::Rgb, &[red, 0, 0], |_| {});
        assert_eq!(selected(), expected, "red {red}");
    }
}

/// The keyword and the encoder of each format that both povista and the `image` crate know.
const FORMATS: [(&str, ImageFormat); 8] = [
    ("png", ImageFormat::Png),
    ("gif", ImageFormat::Gif),
    ("bmp", ImageFormat::Bmp),
    ("jpeg", ImageFormat::Jpeg),
    ("tga", ImageFormat::Tga),
    ("ppm", ImageFormat::Pnm),
    ("tiff", ImageFormat::Tiff),
    ("hdr", ImageFormat::Hdr),
];

fn picture(format: ImageFormat) -> Vec<u8> {
    let colors = RgbImage::from_fn(16, 8, |x, y| {
        Rgb(if x < 8 { [200, 100, 50] } else { [10, 20 + 5 * y as u8, 240] })
    });
    let mut bytes = std::io::Cursor::new(Vec::new());
    let picture = match format {
        ImageFormat::Hdr => DynamicImage::ImageRgb32F(DynamicImage::ImageRgb8(colors).into_rgb32f()),
        _ => DynamicImage::ImageRgb8(colors),
    };
    picture.write_to(&mut bytes, format).unwrap();
    bytes.into_inner()
}

#[test]
fn every_format_gives_its_colours() {
    let folder = folder();
    for (keyword, format) in FORMATS {
        fs::write(folder.path().join("a.img"), picture(format)).unwrap();
        let function = pigment(&format!("image_map{{{keyword} \"a.img\" gamma 1}}"), folder.path()).unwrap();
        let mut color = [0.0; 5];
        function.call_vector(&[0.25, 0.5, 0.0], &mut color);
        let expected = [200.0, 100.0, 50.0].map(|c| c / 255.0);
        for (found, expected) in color.iter().zip(expected) {
            // JPEG and HDR lose a little.
            assert!((found - expected).abs() < 0.02, "{keyword}: {color:?}");
        }
    }
}

#[test]
fn broken_files_are_errors_with_the_files_name() {
    let folder = folder();
    let read = |keyword: &str| pigment(&format!("image_map{{{keyword} \"a.img\"}}"), folder.path());
    for (keyword, format) in FORMATS {
        let whole = picture(format);
        for length in [0, 1, 4, 12, whole.len() / 3] {
            fs::write(folder.path().join("a.img"), &whole[..length]).unwrap();
            let error = read(keyword).map(drop).unwrap_err();
            assert!(error.contains("a.img"), "{keyword} cut at {length}: {error}");
        }
        // Damage may go unnoticed, but never ends the program.
        for at in (0..whole.len().min(400)).step_by(5) {
            let mut damaged = whole.clone();
            damaged[at] ^= 0x5a;
            fs::write(folder.path().join("a.img"), damaged).unwrap();
            drop(read(keyword));
        }
    }
}
