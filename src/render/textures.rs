//! Which textures show at a hit (docs/spec/shading.md 6).

use smallvec::SmallVec;

use crate::math::{DVec2, DVec3};
use crate::world::hit::Hit;
use crate::world::object::LeafFlags;
use crate::world::sample::Sample;
use crate::world::shape::{OWN_TEXTURE, Shape};
use crate::world::texture::Layer;
use crate::world::warp::Warps;
use crate::world::{Intersection, Leaf, Member, Ray, World};

/// Textures that show together, by number, with their shares.
type Shares = SmallVec<[(u32, f32); 4]>;

/// The layers that alone show at a hit of a leaf, where it has one texture without patterns.
#[inline]
pub(super) fn layers<'w>(world: &'w World, leaf: &Leaf, surface: &Intersection) -> Option<&'w [Layer]> {
    let number = whole(leaf, surface).filter(|_| leaf.own_textures().is_empty())?;
    world.textures[number as usize].layers_in_place().filter(|_| world.settings.adc_bailout <= 1.0)
}

/// The layers that alone show at a hit of a leaf, where it has one texture without patterns, and the way to the space
/// that they are in, if that is not the world.
#[inline]
pub(super) fn placed_layers<'w>(
    world: &'w World,
    leaf: &Leaf,
    surface: &Intersection,
) -> Option<(&'w [Layer], Option<&'w Warps>)> {
    let number = whole(leaf, surface).filter(|_| leaf.own_textures().is_empty())?;
    let texture = &world.textures[number as usize];
    let layers = texture.layers().filter(|_| world.settings.adc_bailout <= 1.0)?;
    Some((layers, texture.placement()))
}

/// What textures may know of a hit of `ray`.
#[inline]
pub(super) fn sample<'a>(world: &World, ray: &Ray, hit: &Hit, surface: &Intersection) -> Sample<'a> {
    let leaf = world.geometry.parts().leaf(hit.leaf);
    let uv = if world.needs.uv { world.geometry.uv(hit, surface.textured) } else { DVec2::ZERO };
    let mut sample = Sample::on_surface(surface.textured, surface.normal, ray.direction, uv);
    if leaf.flags.contains(LeafFlags::UV_MAPPING) {
        sample.point = uv.extend(0.0);
    }
    sample
}

/// Calls `shade` with the layers of every plain texture at a hit of `ray`, and its share.
pub(super) fn resolve(
    world: &World,
    ray: &Ray,
    hit: &Hit,
    surface: &Intersection,
    shade: &mut dyn FnMut(f32, &[Layer], &mut Sample),
) {
    let leaf = world.geometry.parts().leaf(hit.leaf);
    let mut sample = sample(world, ray, hit, surface);
    let bailout = world.settings.adc_bailout;
    if let (Some(number), true) = (whole(leaf, surface), leaf.own_textures().is_empty()) {
        // Most leaves show one texture.
        if bailout <= 1.0 {
            world.textures[number as usize].resolve(&mut sample, shade);
        }
        return;
    }
    for (number, share) in shares(world, leaf, hit, surface) {
        if share >= bailout {
            let texture = &world.textures[number as usize];
            let mut sample = sample;
            texture.resolve(&mut sample, &mut |weight, layers, sample| shade(share * weight, layers, sample));
        }
    }
}

/// The texture of a leaf as a whole.
#[inline]
fn whole(leaf: &Leaf, surface: &Intersection) -> Option<u32> {
    leaf.interior_texture().filter(|_| surface.inside).or(leaf.texture.get())
}

/// The textures at a hit of a leaf that brings its own, or has none.
fn shares(world: &World, leaf: &Leaf, hit: &Hit, surface: &Intersection) -> Shares {
    let mut shares = Shares::new();
    let whole = whole(leaf, surface);
    leaf.primitive.textures(leaf.inner_point(surface.textured), &hit.crossing, &mut |number, share| {
        let own = || leaf.own_textures().nth(number as usize);
        let texture = if number == OWN_TEXTURE { whole } else { own() };
        shares.extend(texture.map(|texture| (texture, share as f32)));
    });
    if !shares.is_empty() {
        return shares;
    }
    match whole {
        Some(number) => shares.push((number, 1.0)),
        None => cutaway(world, leaf, hit, surface.point, &mut shares),
    }
    let even = 1.0 / shares.len().max(1) as f32;
    shares.iter_mut().for_each(|(_, share)| *share = even);
    shares
}

/// The textures of the solids that a texture-less member of a compound cuts.
fn cutaway(world: &World, leaf: &Leaf, hit: &Hit, point: DVec3, found: &mut Shares) {
    let parts = world.geometry.parts();
    let mut cutter = Member::Leaf(hit.leaf);
    let mut around = leaf.parent();
    while let (true, Some(number)) = (found.is_empty(), around) {
        let group = parts.group(number);
        // What is cut out of a difference is its first member.
        let cut = if group.difference { &group.members[..1] } else { &group.members[..] };
        for &member in cut.iter().filter(|&&member| member != cutter) {
            textures_around(world, member, point, found);
        }
        cutter = Member::Group(number);
        around = group.parent;
    }
}

/// The textures of the leaves of `member` that contain a point.
fn textures_around(world: &World, member: Member, point: DVec3, found: &mut Shares) {
    let parts = world.geometry.parts();
    if !parts.inside(member, point) {
        return;
    }
    match member {
        Member::Leaf(number) => found.extend(parts.leaf(number).texture.get().map(|texture| (texture, 1.0))),
        Member::Group(number) => {
            for &member in &parts.group(number).members {
                textures_around(world, member, point, found);
            }
        }
    }
}
