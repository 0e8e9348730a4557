//! Puts a world together.

use std::sync::Arc;

use super::flatten::{Filling, Flat, Flattener, InteriorUse, TextureUse};
use super::probe::{self, Known};
use super::texture::TextureCompiler;
use super::{Unsupported, atmosphere, camera, interior, light, needs, settings};
use crate::math::Transform;
use crate::options::RenderOptions;
use crate::scene::{self, Object, Scene};
use crate::source::Span;
use crate::world::object::LeafFlags;
use crate::world::parts::Parts;
use crate::world::{Geometry, Interior, LightSet, Member, Texture, World};

/// A world, and what of the scene is not in it.
#[derive(Debug)]
pub struct Compiled {
    /// Ready to be rendered.
    pub world: World,
    /// Where the object of each leaf's `origin` was written.
    pub spans: Vec<Span>,
    /// What had to be left out. Unless that is accepted, the world is not the scene.
    pub unsupported: Vec<Unsupported>,
}

/// Compiles a scene.
pub fn compile(scene: Scene, options: &RenderOptions) -> Compiled {
    compile_knowing(scene, options, Known::default())
}

/// The same, given what was compiled while it was read.
pub fn compile_knowing(mut scene: Scene, options: &RenderOptions, mut known: Known) -> Compiled {
    let objects = std::mem::take(&mut scene.objects);
    let mut flattener = Flattener::new(&scene.settings, options.accelerator, options.split_unions);
    flattener.shapes = known.take(&scene.settings);
    flattener.expect(objects.len());
    // Each is freed once it is taken apart.
    for object in objects {
        flattener.add(&object);
    }
    let mut flat = flattener.finish();
    let mut lacking = std::mem::take(&mut flat.unsupported);
    lack_of_settings(&scene, &mut lacking);
    let inside_of = |object: &Arc<Object>| probe::inside_of(object, &scene.settings);
    let mut textures = TextureCompiler::new(&scene.settings)
        .with_quick_colors(options.quality <= 5)
        .with_objects(&inside_of);
    let camera = camera::camera(&scene.camera, &mut textures, &mut lacking);
    let atmosphere = atmosphere::atmosphere(&scene, &mut textures, &mut lacking);
    let surfaces = surfaces(&mut flat, &mut textures, &mut lacking);
    let interiors = interiors(&mut flat, &mut textures, &mut lacking);
    // Without the setting a finish with `subsurface` is shaded as any other.
    if let Some(subsurface) = &scene.settings.subsurface
        && textures.uses_subsurface
        && options.quality >= 9
    {
        lacking.push(Unsupported::new(subsurface.span, "subsurface"));
    }
    let needs = needs::needs(&flat, &textures, &interiors);
    let lights =
        flat.lights.iter().map(|used| light::light(&used.light, &used.transform, used.projected_through));
    let lights: Vec<_> = lights.collect();
    mark_opaque(&mut flat, &surfaces);
    let sets = flat.light_sets.into_iter().map(|numbers| LightSet::new(numbers, &lights));
    let world = World {
        geometry: Geometry::new(flat.parts, options.accelerator),
        textures: surfaces,
        interiors,
        light_sets: sets.collect(),
        lights,
        camera,
        atmosphere,
        settings: settings::settings(&scene.settings),
        needs,
    };
    Compiled { world, spans: flat.spans, unsupported: lacking }
}

/// Light that travels in ways povista doesn't follow yet.
fn lack_of_settings(scene: &Scene, lacking: &mut Vec<Unsupported>) {
    if let Some(radiosity) = &scene.settings.radiosity {
        lacking.push(Unsupported::new(radiosity.span, "radiosity"));
    }
    if let Some(photons) = &scene.settings.photons {
        lacking.push(Unsupported::new(photons.span, "photons"));
    }
}

/// The textures in use, which the leaves then number; what can't be compiled is replaced by
/// POV-Ray's default texture.
fn surfaces(flat: &mut Flat, textures: &mut TextureCompiler, lacking: &mut Vec<Unsupported>) -> Vec<Texture> {
    let used = needs::textures(flat);
    let identity = Transform::IDENTITY;
    let compile = |wanted: TextureUse| {
        let outer = wanted.outer.as_deref().unwrap_or(&identity);
        let compiled = textures.texture(&wanted.texture, outer).or_else(|unsupported| {
            lacking.push(unsupported);
            textures.texture(&scene::Texture::default(), outer)
        });
        // The default texture has nothing that could be unsupported.
        compiled.ok()
    };
    let compiled = used.made_into(std::mem::take(&mut flat.textures), compile);
    for leaf in &mut flat.parts.leaves {
        leaf.texture = leaf.texture.get().map(|number| used.renumbered(number)).into();
        if leaf.flags.contains(LeafFlags::SEVERAL) {
            let inner = leaf.interior_texture().map(|number| used.renumbered(number));
            let own = leaf.own_textures();
            let first = used.renumbered(own.start);
            leaf.set_textures(inner.into(), first..first + own.len() as u32);
        }
    }
    compiled
}

/// The interiors in use, which leaves and objects then number.
fn interiors(
    flat: &mut Flat,
    textures: &mut TextureCompiler,
    lacking: &mut Vec<Unsupported>,
) -> Vec<Arc<Interior>> {
    let used = needs::interiors(flat);
    // What is filled with air alone is alike, solid or hollow.
    let mut airs = [None, None];
    let air = Filling { interior: None, outer: None, legacy: None };
    let mut compile = |InteriorUse { filling, hollow }| {
        let filling = filling.get().map(|number| &flat.fillings[number as usize]);
        let Filling { interior, outer, legacy } = filling.unwrap_or(&air);
        let outer = outer.as_deref().unwrap_or(&Transform::IDENTITY);
        let mut compile = || {
            Arc::new(interior::interior(
                interior.as_deref(),
                legacy.as_ref(),
                hollow,
                outer,
                textures,
                lacking,
            ))
        };
        match (interior, legacy) {
            (None, None) => airs[usize::from(hollow)].get_or_insert_with(compile).clone(),
            _ => compile(),
        }
    };
    let compiled = used.made_into(std::mem::take(&mut flat.interiors), |interior| Some(compile(interior)));
    for leaf in &mut flat.parts.leaves {
        leaf.interior = used.renumbered(leaf.interior);
    }
    for object in &mut flat.parts.objects {
        object.interior = used.renumbered(object.interior);
    }
    compiled
}

/// Notes which leaves and objects no light passes, so that shadow rays ask no further, and which
/// leaves all light passes.
fn mark_opaque(flat: &mut Flat, textures: &[Texture]) {
    let opaque = |number: u32| textures[number as usize].is_opaque();
    for leaf in &mut flat.parts.leaves {
        let all = leaf.own_textures().all(opaque)
            && leaf.texture.get().is_some_and(opaque)
            && leaf.interior_texture().is_none_or(opaque);
        leaf.flags.set(LeafFlags::OPAQUE, all);
        let everywhere = |holds: fn(&Texture) -> bool| {
            let single = |number: u32| holds(&textures[number as usize]);
            leaf.own_textures().is_empty()
                && leaf.texture.get().is_some_and(single)
                && leaf.interior_texture().is_none_or(single)
        };
        let (clear, invisible) = (everywhere(Texture::passes_light), everywhere(Texture::is_invisible));
        leaf.flags.set(LeafFlags::CLEAR, clear);
        leaf.flags.set(LeafFlags::INVISIBLE, invisible);
    }
    let objects = flat.parts.objects.iter().map(|object| is_opaque(&flat.parts, object.member));
    let opaque: Vec<bool> = objects.collect();
    for (object, opaque) in flat.parts.objects.iter_mut().zip(opaque) {
        object.opaque = opaque;
    }
}

fn is_opaque(parts: &Parts, member: Member) -> bool {
    match member {
        Member::Leaf(number) => parts.leaf(number).flags.contains(LeafFlags::OPAQUE),
        Member::Group(number) => parts.group(number).members.iter().all(|&member| is_opaque(parts, member)),
    }
}
