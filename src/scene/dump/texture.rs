//! Textures and their parts.

use super::block::Block;
use super::pattern;
use super::value::{color, number, rgb, switch, transform, vec2, vec3};
use crate::math::Rgbft;
use crate::scene::pattern::Turbulence;
use crate::scene::pigment::{BlendMap, PigmentKind};
use crate::scene::texture::{Layer, LegacyFinish, NormalKind, Reflection, TextureBody};
use crate::scene::{Finish, Normal, Pigment, Texture};

/// A texture under the word that introduces it.
pub(super) fn dump(word: &str, texture: &Texture) -> Block {
    let block = match &*texture.body {
        TextureBody::Layered(layers) => match &layers[..] {
            [single] => Block::new(word).extend(layer(single)),
            layers => Block::new(word).blocks(layers.iter().map(|l| Block::new("layer").extend(layer(l)))),
        },
        TextureBody::Patterned { field, map, no_bump_scale } => Block::new(word)
            .extend(pattern::dump(field))
            .flag("no_bump_scale", *no_bump_scale)
            .block(blend_map("texture_map", map, |head, texture| dump(&head, texture))),
        TextureBody::MaterialMap { field, image, textures } => Block::new(word)
            .block(pattern::image_map("material_map", image))
            .extend(pattern::modifiers(field))
            .blocks(textures.iter().map(|texture| dump("texture", texture))),
        TextureBody::UvMapped(inner) => Block::new(word).line("uv_mapping").block(dump("texture", inner)),
    };
    match &texture.transform {
        Some(by) => block.line(transform(by)),
        None => block,
    }
}

fn layer(layer: &Layer) -> Block {
    Block::new("")
        .block(pigment("pigment", &layer.paint.pigment()))
        .blocks(layer.normal.as_deref().map(normal))
        .block(finish(&layer.finish))
}

/// A map whose entries are blocks: `[position] word { … }`.
fn blend_map<T>(word: &str, map: &BlendMap<T>, entry: impl Fn(String, &T) -> Block) -> Block {
    Block::new(word).blocks(map.entries.iter().map(|(at, value)| entry(format!("[{}]", number(*at)), value)))
}

/// A map of colours.
pub(super) fn color_map(map: &BlendMap<Rgbft>) -> Block {
    map.entries.iter().fold(Block::new("color_map"), |block, (at, value)| {
        block.line(format!("[{} {}]", number(*at), color(*value)))
    })
}

/// A pigment or density under the word that introduces it.
pub(super) fn pigment(word: &str, pigment: &Pigment) -> Block {
    let block = Block::new(word);
    let block = match &pigment.kind {
        PigmentKind::Color(value) => block.line(color(*value)),
        PigmentKind::Colors { field, map } => {
            let block = block.extend(pattern::dump(field));
            match map {
                Some(map) => block.block(color_map(map)),
                None => block.block(color_map(&field.pattern.default_colors())),
            }
        }
        PigmentKind::Pigments { field, map } => {
            let entry = |head: String, value: &_| self::pigment(&head, value);
            block
                .extend(pattern::dump(field))
                .block(blend_map("pigment_map", map, |head, value| entry(head, value)))
        }
        PigmentKind::Image { field, map } => {
            block.block(pattern::image_map("image_map", map)).extend(pattern::modifiers(field))
        }
        PigmentKind::UvMapped(inner) => block.line("uv_mapping").extend(self::pigment("", inner)),
    };
    block.optional("quick_color", pigment.quick_color.as_deref().copied().map(color))
}

/// A normal.
pub(super) fn normal(normal: &Normal) -> Block {
    normal_as("normal", normal)
}

fn normal_as(word: &str, normal: &Normal) -> Block {
    let block = Block::new(word);
    let block = match &normal.kind {
        NormalKind::Pattern { field, slopes } => {
            let block = block.extend(pattern::dump(field));
            match slopes {
                Some(map) => {
                    block.block(map.entries.iter().fold(Block::new("slope_map"), |block, (at, value)| {
                        block.line(format!("[{} {}]", number(*at), vec2(*value)))
                    }))
                }
                None => block,
            }
        }
        NormalKind::Normals { field, map } => {
            block
                .extend(pattern::dump(field))
                .block(blend_map("normal_map", map, |head, value| normal_as(&head, value)))
        }
        NormalKind::Bumps { field, map } => {
            block.block(pattern::image_map("bump_map", map)).extend(pattern::modifiers(field))
        }
        NormalKind::UvMapped(inner) => return block.line("uv_mapping").extend(normal_as("", inner)),
    };
    block
        .field("bump_size", number(normal.amount))
        .field("accuracy", number(normal.accuracy))
        .flag("no_bump_scale", normal.no_bump_scale)
}

fn finish(finish: &Finish) -> Block {
    let diffuse = |[front, back]: [f32; 2]| format!("{}, {}", number(front), number(back));
    let scattered = [finish.diffuse, finish.diffuse_back];
    let mut block = Block::new("finish").line(format!(
        "ambient {} emission {} diffuse {} brilliance {}",
        rgb(finish.ambient),
        rgb(finish.emission),
        diffuse(scattered),
        number(finish.brilliance)
    ));
    if finish.raw_diffuse != scattered {
        block = block.field("raw_diffuse", diffuse(finish.raw_diffuse));
    }
    block = block
        .line(format!(
            "phong {} phong_size {} specular {} roughness {} metallic {} crand {} conserve_energy {}",
            number(finish.phong),
            number(finish.phong_size),
            number(finish.specular),
            number(finish.roughness),
            number(finish.metallic),
            number(finish.crand),
            switch(finish.conserve_energy)
        ))
        .block(reflection(&finish.reflection));
    if let Some(irid) = &finish.irid {
        block = block.block(
            Block::new("irid")
                .line(number(irid.amount))
                .field("thickness", number(irid.thickness))
                .field("turbulence", number(irid.turbulence)),
        );
    }
    if let Some(subsurface) = &finish.subsurface {
        block = block.block(
            Block::new("subsurface")
                .field("translucency", rgb(subsurface.translucency))
                .field("anisotropy", rgb(subsurface.anisotropy)),
        );
    }
    legacy(block, &finish.legacy)
}

fn reflection(reflection: &Reflection) -> Block {
    Block::new("reflection")
        .line(format!("{}, {}", rgb(reflection.min), rgb(reflection.max)))
        .field("fresnel", switch(reflection.fresnel))
        .field("falloff", number(reflection.falloff))
        .field("exponent", number(reflection.exponent))
        .field("metallic", number(reflection.metallic))
}

fn legacy(block: Block, legacy: &LegacyFinish) -> Block {
    block
        .optional("ior", legacy.ior.map(number))
        .optional("refraction", legacy.refraction.map(number))
        .optional("caustics", legacy.caustics.map(number))
}

/// `turbulence` and its settings.
pub(super) fn turbulence(turbulence: &Turbulence) -> String {
    format!(
        "turbulence {} octaves {} omega {} lambda {}",
        vec3(turbulence.amount),
        turbulence.octaves,
        number(turbulence.omega),
        number(turbulence.lambda)
    )
}
