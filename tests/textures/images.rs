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
    close(&middle(folder.path(), "png \"a.png\""), &[1.0, 1.0, 1.0, 0.0, 0.498039186]);
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
        let mut sample = Sample::on_surface(DVec3::new(0.5, 0.5, 0.0), -DVec3::Z, DVec3::Z, DVec2::ZERO);
        let mut found = Vec::new();
        texture(text, folder.path()).unwrap().resolve(&mut sample, &mut |weight, layers, sample| {
            found.push((weight, layers[0].paint.color(sample).unwrap().rgb.x));
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
        // The encoder would choose a kind that POV-Ray doesn't know.
        ImageFormat::Pnm => return [b"P6\n16 8\n255\n".to_vec(), colors.into_raw()].concat(),
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

/// An ILBM of 4 by 2 pixels in two planes, packed.
fn iff(mode: u32, planes: u8) -> Vec<u8> {
    let chunk = |name: &[u8], data: &[u8]| [name, &(data.len() as u32).to_be_bytes(), data].concat();
    let header = [0, 4, 0, 2, 0, 0, 0, 0, planes, 0, 1, 0, 0, 0, 1, 1, 0, 4, 0, 2];
    let palette = [10, 20, 30, 40, 50, 60, 70, 80, 90, 200, 210, 220];
    // Each row: 0 1 2 3, then planes of zeros.
    let row =
        [&[1, 0b0101_0000, 0, 1, 0b0011_0000, 0][..], &[255, 0].repeat(usize::from(planes) - 2)].concat();
    let inside = [
        b"ILBM".to_vec(),
        chunk(b"BMHD", &header),
        chunk(b"CMAP", &palette),
        chunk(b"CAMG", &mode.to_be_bytes()),
        chunk(b"BODY", &row.repeat(2)),
    ];
    chunk(b"FORM", &inside.concat())
}

#[test]
fn pictures_of_the_amiga_are_read() {
    let folder = folder();
    let colors = |mode, planes| {
        fs::write(folder.path().join("a.iff"), iff(mode, planes)).unwrap();
        let function = pigment("image_map{iff \"a.iff\"}", folder.path()).unwrap();
        [0.1, 0.4, 0.6, 0.9].map(|x| {
            let mut color = [0.0; 5];
            function.call_vector(&[x, 0.5, 0.0], &mut color);
            [color[0], color[1], color[2]].map(|v| (v * 255.0).round())
        })
    };
    let palette = [[10.0, 20.0, 30.0], [40.0, 50.0, 60.0], [70.0, 80.0, 90.0], [200.0, 210.0, 220.0]];
    for (mode, planes) in [(0, 2), (0x80, 6), (0x800, 6)] {
        assert_eq!(colors(mode, planes), palette, "mode {mode:x}");
    }
}

/// A GIF of 4 by 1 pixels is two heights.
#[test]
fn heights_have_sixteen_bits() {
    let folder = folder();
    let mut bytes = Vec::new();
    let mut encoder = gif::Encoder::new(&mut bytes, 4, 2, &[0; 768]).unwrap();
    let frame = gif::Frame::from_indexed_pixels(4, 2, [0x80, 0x40, 0, 0x12, 0x80, 0x40, 0, 0x12], None);
    encoder.write_frame(&frame).unwrap();
    drop(encoder);
    fs::write(folder.path().join("a.pot"), bytes).unwrap();
    let text = "#declare Field = height_field{pot \"a.pot\"} \
        sphere{0,1 pigment{rgb <trace(Field,<.001,2,.5>,-y).y, trace(Field,<.999,2,.5>,-y).y, 0>}}";
    let mut sample = Sample::on_surface(DVec3::X, -DVec3::Z, DVec3::Z, DVec2::ZERO);
    let mut heights = DVec2::ZERO;
    texture(text, folder.path()).unwrap().resolve(&mut sample, &mut |_, layers, sample| {
        let color = layers[0].paint.color(sample).unwrap().rgb;
        heights = DVec2::new(f64::from(color.x), f64::from(color.y));
    });
    let expected = DVec2::new(f64::from(0x8000), f64::from(0x4012)) / 65536.0;
    assert!(heights.abs_diff_eq(expected, 5e-4), "{heights} is not {expected}");
}

#[test]
fn max_extent_tells_the_size_of_an_image() {
    let folder = folder();
    let size = |pigment: &str| {
        let text = format!(
            "#declare P = pigment{{{pigment}}} #declare S = max_extent(P);
             sphere{{0,1 pigment{{rgb <S.x,S.y,S.z>}}}}"
        );
        let mut sample = Sample::on_surface(DVec3::X, -DVec3::Z, DVec3::Z, DVec2::ZERO);
        let mut size = Default::default();
        texture(&text, folder.path())?.resolve(&mut sample, &mut |_, layers, sample| {
            size = layers[0].paint.color(sample).unwrap().rgb.to_array();
        });
        Ok::<_, String>(size)
    };
    assert_eq!(size("image_map{ppm \"probe.ppm\"}"), Ok([3.0, 2.0, 0.0]));
    assert_eq!(size("image_map{ppm \"probe.ppm\" map_type 1 repeat <2,3>} scale 3"), Ok([3.0, 2.0, 0.0]));
    assert_eq!(size("image_map{function 7,5{x}}"), Ok([7.0, 5.0, 0.0]));
    assert!(size("bozo").unwrap_err().contains("this pigment has no size"));
    fs::write(folder.path().join("a.ppm"), "P6").unwrap();
    assert!(size("image_map{ppm \"a.ppm\"}").unwrap_err().contains("a.ppm"));
}

/// Headers of pictures that would take far more memory than there is.
#[test]
fn pictures_that_claim_to_be_huge_are_refused() {
    let folder = folder();
    let mut huge_png = Vec::new();
    drop(png::Encoder::new(&mut huge_png, 0x7fff_ffff, 0x7fff_ffff).write_header().unwrap());
    let mut huge_gif = Vec::new();
    drop(gif::Encoder::new(&mut huge_gif, 65535, 65535, &[0; 6]).unwrap());
    let tga = [&[0, 0, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0, 255, 255, 255, 255, 32, 0][..], &[255; 64]].concat();
    let mut bmp = picture(ImageFormat::Bmp);
    bmp[18..26].copy_from_slice(&[0, 0, 1, 0, 0, 0, 1, 0]);
    let mut tiff = picture(ImageFormat::Tiff);
    let width = tiff.windows(4).position(|w| w == [0, 1, 4, 0]).unwrap() + 8;
    tiff[width..width + 4].copy_from_slice(&0x7fff_ffff_u32.to_le_bytes());
    tiff[width + 12..width + 16].copy_from_slice(&0x7fff_ffff_u32.to_le_bytes());
    let text = |text: &str| text.as_bytes().to_vec();
    for (keyword, bytes) in [
        ("png", huge_png),
        ("gif", huge_gif),
        ("tga", tga),
        ("bmp", bmp),
        ("tiff", tiff),
        ("ppm", text("P6 900000 900000 255 ")),
        ("pgm", text("P2 900000 900000 65535 0 0 0")),
        ("ppm", text("P3 99999999999999999999999 1 255 ")),
        ("hdr", text("#?RADIANCE\n\n-Y 900000 +X 900000\n")),
    ] {
        fs::write(folder.path().join("a.img"), bytes).unwrap();
        let error = pigment(&format!("image_map{{{keyword} \"a.img\"}}"), folder.path()).map(drop);
        assert!(error.is_err_and(|error| error.contains("a.img")), "{keyword}");
    }
}

#[test]
fn files_that_are_missing_or_folders_are_named() {
    let folder = folder();
    fs::create_dir(folder.path().join("a.png")).unwrap();
    for name in ["a.png", "b.png"] {
        let error = pigment(&format!("image_map{{png \"{name}\"}}"), folder.path()).map(drop).unwrap_err();
        assert!(error.contains(name), "{error}");
    }
    let mut df3 = fs::read(folder.path().join("probe.df3")).unwrap();
    df3.truncate(20);
    fs::write(folder.path().join("a.df3"), df3).unwrap();
    let error = pigment("density_file df3 \"a.df3\"", folder.path()).map(drop).unwrap_err();
    assert!(error.contains("a.df3"), "{error}");
}

/// A file that nothing shows may be broken: it is never decoded.
#[test]
fn images_that_nothing_shows_are_not_decoded() {
    let folder = folder();
    fs::write(folder.path().join("a.png"), "no picture").unwrap();
    let broken = "#declare Broken = pigment{image_map{png \"a.png\"}}";
    assert!(texture(&format!("{broken} sphere{{0,1 pigment{{rgb 1}}}}"), folder.path()).is_ok());
    assert!(texture(&format!("{broken} sphere{{0,1 pigment{{Broken}}}}"), folder.path()).is_err());
}

#[test]
fn broken_files_are_errors_with_the_files_name() {
    let folder = folder();
    let read = |keyword: &str| pigment(&format!("image_map{{{keyword} \"a.img\"}}"), folder.path());
    let pictures = FORMATS.map(|(keyword, format)| (keyword, picture(format)));
    for (keyword, whole) in pictures.into_iter().chain([("iff", iff(0x800, 6))]) {
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
