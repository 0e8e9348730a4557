//! Cameras and lights that are shut into objects.

use crate::compile;
use crate::diag::{Code, Diagnostic, Severity};
use crate::math::DVec3;
use crate::options::RenderOptions;
use crate::scene::camera::Projection;
use crate::scene::light::LightKind;
use crate::scene::{Scene, Shape};
use crate::source::Span;
use crate::world::object::LeafFlags;
use crate::world::parts::Parts;
use crate::world::{Leaf, Member, RayKind, World};

/// A light with its place in the world.
struct Lamp {
    span: Span,
    location: DVec3,
}

/// What is to be said about where the camera and the lights of a scene are.
///
/// Only objects count that no light passes, and that cast shadows. A camera may well be in a room together with a
/// light, and a light in a lamp that is open.
pub fn geometry(scene: Scene) -> Vec<Diagnostic> {
    let lamps: Vec<Lamp> = scene.objects.iter().filter_map(|object| lamp(object)).collect();
    let camera = (scene.camera.span, scene.camera.location);
    // The rays of a mesh's faces start anywhere.
    let has_place = !matches!(scene.camera.projection, Projection::Mesh(_));
    // How big the picture would be doesn't matter.
    let compiled = compile::compile(scene, &RenderOptions::new(64, 64));
    let (world, spans) = (&compiled.world, &compiled.spans);
    let around = |point: DVec3| prisons(world, point);
    let mut found = Vec::new();
    let lit: Vec<Vec<u32>> = lamps.iter().map(|lamp| around(lamp.location)).collect();
    let seen = around(camera.1);
    let is_dark = |object: &&u32| !lit.is_empty() && lit.iter().all(|lit| !lit.contains(object));
    if let Some(&object) = seen.iter().find(is_dark).filter(|_| has_place) {
        found.push(
            Diagnostic::new(
                Severity::Warning,
                camera.0,
                "the camera is inside of an object, where no light is",
            )
            .code(Code::CameraInside)
            .see(span(world, spans, object), "this one, which is opaque")
            .help("move the camera, or say `hollow` if that is meant"),
        );
    }
    for (lamp, objects) in lamps.iter().zip(&lit) {
        if let Some(&object) = objects.iter().find(|object| !seen.contains(object)) {
            found.push(
                Diagnostic::new(Severity::Warning, lamp.span, "this light is shut into an object")
                    .code(Code::LightInside)
                    .see(span(world, spans, object), "this one, which is opaque")
                    .help(
                        "move the light, say `no_shadow` for the object, or make it the light's `looks_like`",
                    ),
            );
        }
    }
    found
}

/// A light that stands for itself in the scene and casts shadows.
fn lamp(object: &crate::scene::Object) -> Option<Lamp> {
    let Shape::Light(light) = &object.shape else { return None };
    let location =
        object.transform.as_ref().map_or(light.location, |transform| transform.point(light.location));
    (light.kind != LightKind::Shadowless && !light.parallel).then_some(Lamp { span: object.span, location })
}

/// The objects around a point that no light leaves.
fn prisons(world: &World, point: DVec3) -> Vec<u32> {
    let parts = world.geometry.parts();
    let is_prison = |number: &u32| {
        let object = &parts.objects[*number as usize];
        let bounded = parts.extent(object.member).bounds.is_finite();
        let leaf = first_leaf(parts, object.member);
        let shuts = |leaf: &Leaf| {
            !leaf.hidden.intersects(RayKind::SHADOW | RayKind::IMAGE)
                && !leaf.flags.contains(LeafFlags::INVERTED)
        };
        let hollow = world.interiors.get(object.interior as usize).is_some_and(|interior| interior.hollow);
        bounded && object.opaque && !hollow && leaf.is_some_and(|leaf| !leaf.is_limited() && shuts(leaf))
    };
    world.geometry.containers(point).into_iter().filter(is_prison).collect()
}

/// The first leaf of a tree: it has the traits of all, but for what its members were given themselves.
fn first_leaf(parts: &Parts, member: Member) -> Option<&Leaf> {
    match member {
        Member::Leaf(leaf) => Some(parts.leaf(leaf)),
        Member::Group(group) => {
            parts.group(group).members.first().and_then(|&member| first_leaf(parts, member))
        }
    }
}

/// Where an object was written, or its first member.
fn span(world: &World, spans: &[Span], object: u32) -> Span {
    let parts = world.geometry.parts();
    let leaf = first_leaf(parts, parts.objects[object as usize].member);
    leaf.and_then(|leaf| spans.get(leaf.origin as usize)).copied().unwrap_or_default()
}
