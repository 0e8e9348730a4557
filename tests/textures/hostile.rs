//! Patterns, maps and normals with numbers and entries nobody means: a clear error or a value, never a panic.

use povista::math::{DVec2, DVec3};
use povista::world::texture::Sample;

use super::{folder, pigment, texture};

/// Bodies that are read; what they show is only promised not to stop the program.
const BODIES: [&str; 55] = [
    "function { sqrt(-1) }",
    "function { ln(-1) } sine_wave",
    "function { exp(1000) }",
    "function { -exp(1000) } triangle_wave",
    "bozo turbulence 1e300",
    "bozo turbulence 1e300 octaves 10 omega 1e30 lambda 1e30",
    "gradient x turbulence 1e300",
    "marble turbulence 1e300",
    "wood turbulence 1e300",
    "agate agate_turb 1e300 turbulence 1e300",
    "spiral1 1000000000 turbulence 1e300",
    "bozo warp { turbulence 1e300 }",
    "bozo frequency 1e300",
    "bozo frequency 1e300 phase 1e300 sine_wave",
    "gradient x poly_wave 1e300",
    "gradient x poly_wave -1e300",
    "gradient x color_map { [0 rgb 0] [1e300 rgb 1] }",
    "gradient x color_map { [-1e300 rgb 0] [1e300 rgb 1e300] }",
    "bozo noise_generator 1 scale 1e-30",
    "bozo noise_generator 2 scale 1e30",
    "bozo noise_generator 3 scale 1e-30",
    "cells scale 1e-30",
    "crackle scale 1e-30",
    "crackle metric 0",
    "crackle metric -3",
    "crackle metric 1e300 form 1e300",
    "crackle metric 4 offset 1e200",
    "crackle solid scale 1e-30",
    "checker scale 1e-30",
    "hexagon scale 1e-30",
    "square scale 1e-30",
    "triangular scale 1e-30",
    "brick brick_size 0",
    "brick brick_size <-1, 2, 3> mortar -1",
    "brick mortar 1e300 scale 1e-30",
    "quilted control0 1e300",
    "onion scale 1e-300",
    "radial frequency 1e300",
    "ripples frequency 1e300 scale 1e-30",
    "waves frequency 1e300 scale 1e-30",
    "mandel 0",
    "mandel -5 exponent 33",
    "mandel 30 exterior 6, 1e300 interior 1, -1e300",
    "mandel 30 exterior 7, 0.5",
    "mandel 30 exterior 8, -3",
    "mandel 30 exterior 8, 1e300",
    "magnet 2 julia <1, 0>, 5 scale 1e-300",
    "tiling 9 scale 1e-30",
    "tiling 12 scale 1e30",
    "tiling 25 scale 1e-30",
    "tiling 26 scale 1e-300",
    "pavement scale 1e-30",
    "pavement number_of_sides 4 number_of_tiles 6 pattern 33 form 1000000 interior -1 scale 1e-30",
    "density_file df3 \"probe.df3\" interpolate 4000000 scale 1e-30",
    "slope { y, 0.5, 0.5 }",
];

const POINTS: [DVec3; 8] = [
    DVec3::ZERO,
    DVec3::new(0.3, -0.7, 1.9),
    DVec3::new(-1.0, 1.0, 1.0),
    DVec3::splat(1e17),
    DVec3::new(-2_147_483_648.5, 4e9, -1e300),
    DVec3::splat(f64::INFINITY),
    DVec3::new(f64::NAN, 0.0, 1.0),
    DVec3::splat(5e-324),
];

#[test]
fn any_number_is_survived_by_pigments_and_normals() {
    let folder = folder();
    for body in BODIES {
        // A map of one colour, so that the pigment's value is known where the pattern's isn't.
        let map = if body.contains("color_map") { "" } else { "color_map { [0 rgb 0.25] }" };
        let list = ["checker", "hexagon", "square", "triangular", "brick"];
        let map = if list.iter().any(|word| body.starts_with(word)) { "" } else { map };
        let normal = if body.contains("color_map") { "bumps" } else { body };
        let text = format!("sphere {{ 0, 1 pigment {{ {body} {map} }} normal {{ {normal} }} }}");
        let texture = texture(&text, folder.path()).unwrap_or_else(|error| panic!("{body}: {error}"));
        for point in POINTS {
            let mut sample = Sample::on_surface(point, DVec3::X, DVec3::Z, DVec2::ZERO);
            let layer = &texture.layers().unwrap()[0];
            layer.bend(&mut sample);
            let color = layer.paint.color(&sample).unwrap();
            assert!(map.is_empty() || color.rgb.x == 0.25, "{body}: {color:?}");
        }
    }
}

/// Statements that mean nothing, and a part of what is said of them.
const CONTRADICTIONS: [(&str, &str); 26] = [
    ("gradient x color_map { }", "expected `[`"),
    ("gradient x pigment_map { }", "expected `[`"),
    ("gradient x color_map { [0 rgb 0] [1 bozo] }", "expected"),
    ("gradient x color_map { [rgb 0] [rgb 1] }", "expected"),
    ("gradient x color_map { [0 <1, 0, 0>] }", "a color is needed here"),
    ("gradient x color_map { [0 rgb 0] rgb 1 }", "does not belong here"),
    ("gradient x texture_map { [0 pigment { rgb 0 }] }", "does not belong here"),
    ("checker color_map { [0 rgb 0] [1 rgb 1] }", "this pattern takes a list"),
    ("brick pigment_map { [0 rgb 0] [1 rgb 1] }", "this pattern takes a list"),
    ("rgb 1 color_map { [0 rgb 0] [1 rgb 1] }", "has no pattern to go by"),
    ("average color_map { [1 rgb 0] [1 rgb 1] }", "mixes pigments, not colors"),
    ("average", "needs a map"),
    ("average pigment_map { [1 bozo] [rgb 1] }", "expected"),
    ("density_file df3 \"none.df3\"", "none.df3"),
    ("density_file df3 \"probe.ppm\"", "is no density file"),
    ("image_pattern { ppm \"none.ppm\" }", "none.ppm"),
    ("tiling 28", "there is no tiling 28"),
    ("pavement number_of_sides 5", "don't pave a plane"),
    ("pavement number_of_tiles 7", "`number_of_tiles` is 1 to 6"),
    ("pavement number_of_tiles 4 pattern 4", "`pattern` is 1 to 3"),
    ("bozo number_of_sides 4", "means nothing to this pattern"),
    ("magnet 3 mandel 10", "there is no `magnet 3`"),
    ("mandel 10 interior 7, 1", "the types of `interior` are 0 to 6"),
    ("bozo noise_generator 4", "there is no noise generator 4"),
    ("slope 0", "has no length"),
    ("slope { point_at y altitude y }", "cannot be used with `point_at`"),
];

#[test]
fn contradictions_are_told() {
    let folder = folder();
    let told = |(body, expected): &(&str, &str)| match pigment(body, folder.path()) {
        Ok(_) => Some(format!("`{body}` is accepted\n")),
        Err(error) => (!error.contains(expected)).then(|| format!("`{body}`: {error}\n")),
    };
    let wrong: String = CONTRADICTIONS.iter().filter_map(told).collect();
    assert!(wrong.is_empty(), "{wrong}");
}
