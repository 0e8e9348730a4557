//! Patterns, warps and images.

use super::block::Block;
use super::value::{self, number, switch, transform, vec2, vec3};
use super::{function, object, texture};
use crate::scene::image::{ImageMap, ImageOrigin, ImageSource, PaletteSetting};
use crate::scene::pattern::{BlackHole, Fractal, FractalKind, Slope, Warp, Wave};
use crate::scene::{Field, Pattern};

/// A pattern, its parameters and what shapes its value.
pub(super) fn dump(field: &Field) -> Block {
    pattern(&field.pattern).extend(modifiers(field))
}

fn pattern(pattern: &Pattern) -> Block {
    let block = Block::new("");
    match pattern {
        Pattern::Agate { turbulence } => block.line("agate").field("agate_turb", number(*turbulence)),
        Pattern::Brick { size, mortar } => {
            block.line("brick").field("brick_size", vec3(*size)).field("mortar", number(*mortar))
        }
        Pattern::Crackle { form, metric, offset, solid } => block
            .line("crackle")
            .field("form", vec3(*form))
            .field("metric", number(*metric))
            .field("offset", number(*offset))
            .field("solid", switch(*solid)),
        Pattern::DensityFile { file, interpolate } => {
            let [x, y, z] = file.size;
            block
                .line(format!("density_file df3 {:?} of {x} × {y} × {z}", file.name))
                .field("interpolate", interpolate)
        }
        Pattern::Facets { size, coords, metric } => block
            .line("facets")
            .field("size", number(*size))
            .field("coords", number(*coords))
            .field("metric", number(*metric)),
        Pattern::Fractal(inner) => fractal(inner),
        Pattern::Function(inner) => block.block(function::dump(inner)),
        Pattern::Gradient(direction) => block.field("gradient", vec3(*direction)),
        Pattern::Image(map) => block.block(image_map("image_pattern", map)),
        Pattern::Object(inner) => block.block(Block::new("object").block(object::dump(inner))),
        Pattern::Pavement(p) => block.line(format!(
            "pavement number_of_sides {} number_of_tiles {} pattern {} exterior {} interior {} form {}",
            p.sides, p.tiles, p.pattern, p.exterior, p.interior, p.form
        )),
        Pattern::Pigment(inner) => block.block(texture::pigment("pigment_pattern", inner)),
        Pattern::Quilted { control0, control1 } => {
            block.line("quilted").field("control0", number(*control0)).field("control1", number(*control1))
        }
        Pattern::Slope(inner) => slope(inner),
        Pattern::Spiral1(arms) => block.field("spiral1", arms),
        Pattern::Spiral2(arms) => block.field("spiral2", arms),
        Pattern::Tiling(kind) => block.field("tiling", kind),
        Pattern::Aoi => block.line("aoi"),
        Pattern::Average => block.line("average"),
        Pattern::Boxed => block.line("boxed"),
        Pattern::Bozo => block.line("bozo"),
        Pattern::Bumps => block.line("bumps"),
        Pattern::Cells => block.line("cells"),
        Pattern::Checker => block.line("checker"),
        Pattern::Cubic => block.line("cubic"),
        Pattern::Cylindrical => block.line("cylindrical"),
        Pattern::Dents => block.line("dents"),
        Pattern::Granite => block.line("granite"),
        Pattern::Hexagon => block.line("hexagon"),
        Pattern::Leopard => block.line("leopard"),
        Pattern::Marble => block.line("marble"),
        Pattern::Onion => block.line("onion"),
        Pattern::Planar => block.line("planar"),
        Pattern::Radial => block.line("radial"),
        Pattern::Ripples => block.line("ripples"),
        Pattern::Spherical => block.line("spherical"),
        Pattern::Spotted => block.line("spotted"),
        Pattern::Square => block.line("square"),
        Pattern::Triangular => block.line("triangular"),
        Pattern::Waves => block.line("waves"),
        Pattern::Wood => block.line("wood"),
        Pattern::Wrinkles => block.line("wrinkles"),
    }
}

fn fractal(f: &Fractal) -> Block {
    let prefix = match f.kind {
        FractalKind::Mandel => "",
        FractalKind::Magnet1 => "magnet 1 ",
        FractalKind::Magnet2 => "magnet 2 ",
    };
    let set = match f.julia {
        Some(constant) => format!("{prefix}julia {}, {}", vec2(constant), f.iterations),
        None => format!("{prefix}mandel {}", f.iterations),
    };
    Block::new("")
        .line(set)
        .field("exponent", f.exponent)
        .line(format!("interior {}, {}", f.interior.0, number(f.interior.1)))
        .line(format!("exterior {}, {}", f.exterior.0, number(f.exterior.1)))
}

fn slope(s: &Slope) -> Block {
    let range = |[low, high]: [f64; 2]| format!("{}, {}", number(low), number(high));
    let block = Block::new("slope").flag("point_at", s.point_at);
    let block = block.line(format!("{}, {}", vec3(s.direction), range(s.range)));
    let altitude = s.altitude.map(|(direction, bounds)| format!("{}, {}", vec3(direction), range(bounds)));
    Block::new("").block(block.optional("altitude", altitude))
}

/// What shapes the value of a pattern.
pub(super) fn modifiers(field: &Field) -> Block {
    let wave = match field.wave {
        Wave::Ramp => "ramp_wave".to_owned(),
        Wave::Triangle => "triangle_wave".to_owned(),
        Wave::Sine => "sine_wave".to_owned(),
        Wave::Scallop => "scallop_wave".to_owned(),
        Wave::Cubic => "cubic_wave".to_owned(),
        Wave::Poly(exponent) => format!("poly_wave {}", number(exponent)),
    };
    let mut block = Block::new("").line(format!(
        "frequency {} phase {} {wave}",
        number(field.frequency),
        number(field.phase)
    ));
    if let Some(turbulence) = &field.turbulence {
        block = block.line(texture::turbulence(turbulence));
    }
    block = block.optional("noise_generator", field.noise_generator);
    for step in &field.warps {
        block = match step {
            Warp::Transform(by) => block.line(transform(by)),
            other => block.block(warp(other)),
        };
    }
    block
}

fn warp(warp: &Warp) -> Block {
    let block = Block::new("warp");
    match warp {
        Warp::Transform(by) => block.line(transform(by)),
        Warp::Turbulence(inner) => block.line(texture::turbulence(inner)),
        Warp::Repeat { width, offset, flip } => {
            block.field("repeat", vec3(*width)).field("offset", vec3(*offset)).field("flip", vec3(*flip))
        }
        Warp::BlackHole(hole) => black_hole(block, hole),
        Warp::Spherical { orientation, dist_exp } => block
            .line("spherical")
            .field("orientation", vec3(*orientation))
            .field("dist_exp", number(*dist_exp)),
        Warp::Cylindrical { orientation, dist_exp } => block
            .line("cylindrical")
            .field("orientation", vec3(*orientation))
            .field("dist_exp", number(*dist_exp)),
        Warp::Toroidal { orientation, dist_exp, major_radius } => block
            .line("toroidal")
            .field("orientation", vec3(*orientation))
            .field("dist_exp", number(*dist_exp))
            .field("major_radius", number(*major_radius)),
        Warp::Planar { orientation, distance } => {
            block.line(format!("planar {}, {}", vec3(*orientation), number(*distance)))
        }
        Warp::Cubic => block.line("cubic"),
    }
}

fn black_hole(block: Block, hole: &BlackHole) -> Block {
    block
        .line(format!("black_hole {}, {}", vec3(hole.center), number(hole.radius)))
        .field("strength", number(hole.strength))
        .field("falloff", number(hole.falloff))
        .flag("inverse", hole.inverse)
        .field("type", hole.kind)
        .optional("repeat", hole.repeat.map(vec3))
        .field("turbulence", vec3(hole.turbulence))
}

/// The inside of `image_map` and its kin.
pub(super) fn image_map(word: &str, map: &ImageMap) -> Block {
    let mut block = Block::new(word)
        .block(image_source(&map.source))
        .field("map_type", map.map_type)
        .field("interpolate", map.interpolate)
        .flag("once", map.once)
        .field("repeat", vec2(map.repeat))
        .field("offset", vec2(map.offset));
    for (word, settings) in [("filter", &map.filter), ("transmit", &map.transmit)] {
        for PaletteSetting { index, amount } in settings {
            let index = index.map_or("all".to_owned(), |index| format!("{index},"));
            block = block.line(format!("{word} {index} {}", number(*amount)));
        }
    }
    block.flag("use_index", map.use_index).flag("use_alpha", map.use_alpha)
}

/// Where pixels come from. The path depends on the machine, so it is not shown.
pub(super) fn image_source(source: &ImageSource) -> Block {
    let block = match &source.origin {
        ImageOrigin::File { format, name, .. } => {
            Block::new("image").line(format!("{} {name:?}", format!("{format:?}").to_lowercase()))
        }
        ImageOrigin::Function { width, height, function } => {
            Block::new("image").line(format!("{width}, {height}")).block(function::dump(function))
        }
    };
    let gamma = source.gamma.map(value::gamma);
    block.optional("gamma", gamma).optional("premultiplied", source.premultiplied.map(switch))
}
