//! Interiors, media, fog, rainbows and skies.

use super::block::Block;
use super::texture;
use super::value::{color, number, rgb, switch, vec3};
use crate::scene::{Fog, Interior, Media, Rainbow, SkySphere};

pub(super) fn interior(interior: &Interior) -> Block {
    Block::new("interior")
        .field("ior", interior.ior.map_or("unset".to_owned(), number))
        .field("dispersion", number(interior.dispersion))
        .field("dispersion_samples", interior.dispersion_samples)
        .field("caustics", number(interior.caustics))
        .field("fade_color", rgb(interior.fade_color))
        .field("fade_distance", number(interior.fade_distance))
        .field("fade_power", number(interior.fade_power))
        .optional("refraction", interior.refraction.map(number))
        .blocks(interior.media.iter().map(media))
}

pub(super) fn media(media: &Media) -> Block {
    let mut block = Block::new("media")
        .field("method", media.method)
        .field("intervals", media.intervals)
        .line(format!("samples {}, {}", media.samples[0], media.samples[1]))
        .field("aa_threshold", number(media.aa_threshold))
        .field("aa_level", media.aa_level)
        .field("jitter", number(media.jitter))
        .field("ratio", number(media.ratio))
        .field("confidence", number(media.confidence))
        .field("variance", number(media.variance))
        .field("absorption", rgb(media.absorption))
        .field("emission", rgb(media.emission))
        .field("collect", switch(media.collect));
    if let Some(scattering) = &media.scattering {
        block = block.block(
            Block::new("scattering")
                .line(format!("{}, {}", scattering.kind, rgb(scattering.color)))
                .field("eccentricity", number(scattering.eccentricity))
                .field("extinction", number(scattering.extinction)),
        );
    }
    block.blocks(media.densities.iter().map(|density| texture::pigment("density", density)))
}

pub(super) fn fog(fog: &Fog) -> Block {
    let mut block = Block::new("fog")
        .field("fog_type", fog.kind)
        .field("distance", number(fog.distance))
        .line(color(fog.color))
        .field("fog_alt", number(fog.altitude))
        .field("fog_offset", number(fog.offset))
        .field("up", vec3(fog.up));
    if let Some(turbulence) = &fog.turbulence {
        block = block.line(texture::turbulence(turbulence));
    }
    block.field("turb_depth", number(fog.turb_depth))
}

pub(super) fn rainbow(rainbow: &Rainbow) -> Block {
    Block::new("rainbow")
        .field("direction", vec3(rainbow.direction))
        .field("up", vec3(rainbow.up))
        .field("angle", number(rainbow.angle))
        .field("width", number(rainbow.width))
        .field("distance", number(rainbow.distance))
        .field("jitter", number(rainbow.jitter))
        .field("arc_angle", number(rainbow.arc_angle))
        .field("falloff_angle", number(rainbow.falloff_angle))
        .blocks(rainbow.colors.as_deref().map(texture::color_map))
}

pub(super) fn sky_sphere(sky: &SkySphere) -> Block {
    Block::new("sky_sphere")
        .field("emission", rgb(sky.emission))
        .blocks(sky.pigments.iter().map(|pigment| texture::pigment("pigment", pigment)))
}
