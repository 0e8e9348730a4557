//! Lights.

use super::block::Block;
use super::object;
use super::value::{number, rgb, switch, vec3};
use crate::scene::Light;
use crate::scene::light::LightKind;

/// The content of a `light_source`.
pub(super) fn dump(light: &Light) -> Block {
    let mut block = Block::new("").field("location", vec3(light.location)).line(rgb(light.color));
    let cone = |block: Block, word: &str, radius: f64, falloff: f64, tightness: f64| {
        block
            .line(word)
            .field("radius", number(radius))
            .field("falloff", number(falloff))
            .field("tightness", number(tightness))
    };
    block = match light.kind {
        LightKind::Point => block,
        LightKind::Shadowless => block.flag("shadowless", true),
        LightKind::Spot { radius, falloff, tightness } => {
            cone(block, "spotlight", radius, falloff, tightness)
        }
        LightKind::Cylinder { radius, falloff, tightness } => {
            cone(block, "cylinder", radius, falloff, tightness)
        }
    };
    if light.parallel || !matches!(light.kind, LightKind::Point | LightKind::Shadowless) {
        block = block.flag("parallel", light.parallel).field("point_at", vec3(light.point_at));
    }
    block = block
        .field("fade_distance", number(light.fade_distance))
        .field("fade_power", number(light.fade_power))
        .field("media_interaction", switch(light.media_interaction))
        .field("media_attenuation", switch(light.media_attenuation));
    if let Some(area) = &light.area {
        let [a, b] = area.axes.map(vec3);
        block = block
            .line(format!("area_light {a}, {b}, {}, {}", area.size[0], area.size[1]))
            .field("adaptive", area.adaptive)
            .flag("jitter", area.jitter)
            .flag("circular", area.circular)
            .flag("orient", area.orient)
            .field("area_illumination", switch(area.area_illumination));
    }
    if let Some(photons) = &light.photons {
        block = block.block(
            Block::new("photons")
                .optional("reflection", photons.reflection.map(switch))
                .optional("refraction", photons.refraction.map(switch))
                .flag("area_light", photons.area_light),
        );
    }
    block
        .blocks(light.looks_like.as_deref().map(|inner| Block::new("looks_like").block(object::dump(inner))))
        .blocks(
            light
                .projected_through
                .as_deref()
                .map(|inner| Block::new("projected_through").block(object::dump(inner))),
        )
}
