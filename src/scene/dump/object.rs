//! Objects and their modifiers.

use super::block::Block;
use super::value::{number, switch, transform};
use super::{environment, light, shape, texture};
use crate::scene::object::{ObjectExtra, ObjectFlags, PhotonFlags};
use crate::scene::shape::CsgOperation;
use crate::scene::{Object, Shape};

pub(super) fn dump(object: &Object) -> Block {
    let mut block = match &object.shape {
        Shape::Csg(csg) => {
            let word = match csg.operation {
                CsgOperation::Union => "union",
                CsgOperation::Merge => "merge",
                CsgOperation::Intersection => "intersection",
                CsgOperation::Difference => "difference",
            };
            let children = csg.children.iter().map(|child| dump(child));
            let block = Block::new(word).blocks(children);
            if csg.operation == CsgOperation::Union {
                block.field("split_union", switch(csg.split_union))
            } else {
                block
            }
        }
        Shape::LightGroup(group) => Block::new("light_group")
            .blocks(group.objects.iter().map(|object| dump(object)))
            .field("global_lights", switch(group.global_lights)),
        Shape::Light(inner) => Block::new("light_source").extend(light::dump(inner)),
        other => shape::dump(other),
    };
    if let Some(by) = &object.transform {
        block = block.line(transform(by));
    }
    for word in flags(object.flags) {
        block = block.line(word);
    }
    if let Some(surface) = &object.texture {
        block = block.block(texture::dump("texture", surface));
    }
    match &object.extra {
        Some(extra) => extras(block, extra, object.flags),
        None => block,
    }
}

fn flags(flags: ObjectFlags) -> impl Iterator<Item = String> {
    const WORDS: [(ObjectFlags, &str); 10] = [
        (ObjectFlags::UV_MAPPING, "uv_mapping"),
        (ObjectFlags::INVERSE, "inverse"),
        (ObjectFlags::NO_SHADOW, "no_shadow"),
        (ObjectFlags::NO_IMAGE, "no_image"),
        (ObjectFlags::NO_REFLECTION, "no_reflection"),
        (ObjectFlags::NO_RADIOSITY, "no_radiosity"),
        (ObjectFlags::STURM, "sturm"),
        (ObjectFlags::HIERARCHY, "hierarchy"),
        (ObjectFlags::CUTAWAY_TEXTURES, "cutaway_textures"),
        (ObjectFlags::BOUNDS_ARE_CLIPS, "bounded_by { clipped_by }"),
    ];
    let known = |set, on, word: &'static str| {
        flags.contains(set).then(|| format!("{word} {}", switch(flags.contains(on))))
    };
    [
        known(ObjectFlags::HOLLOW_SET, ObjectFlags::HOLLOW, "hollow"),
        known(ObjectFlags::DOUBLE_ILLUMINATE_SET, ObjectFlags::DOUBLE_ILLUMINATE, "double_illuminate"),
    ]
    .into_iter()
    .flatten()
    .chain(WORDS.into_iter().filter(move |&(flag, _)| flags.contains(flag)).map(|(_, word)| word.to_owned()))
}

fn extras(mut block: Block, extra: &ObjectExtra, flags: ObjectFlags) -> Block {
    if let Some(surface) = &extra.interior_texture {
        block = block.block(texture::dump("interior_texture", surface));
    }
    block = block.blocks(extra.interior.as_deref().map(environment::interior));
    for (word, objects, shown) in [
        ("clipped_by", &extra.clipped_by, true),
        ("bounded_by", &extra.bounded_by, !flags.contains(ObjectFlags::BOUNDS_ARE_CLIPS)),
    ] {
        if shown && !objects.is_empty() {
            block = block.block(Block::new(word).blocks(objects.iter().map(|object| dump(object))));
        }
    }
    block = block.blocks(extra.photons.as_ref().map(photons));
    block.optional("radiosity_importance", extra.radiosity_importance.map(number))
}

fn photons(photons: &PhotonFlags) -> Block {
    Block::new("photons")
        .optional("target", photons.target.map(number))
        .optional("reflection", photons.reflection.map(switch))
        .optional("refraction", photons.refraction.map(switch))
        .field("pass_through", switch(photons.pass_through))
        .field("collect", switch(!photons.ignore_photons))
}
