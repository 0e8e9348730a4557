//! What the statements of a scene have said so far, and the scene they make.

use std::sync::Arc;

use super::camera::Draft;
use super::normal::Bumps;
use crate::diag::Severity;
use crate::interp::Vm;
use crate::math::Rgbft;
use crate::scene::object::ObjectFlags;
use crate::scene::shape::CsgOperation;
use crate::scene::texture::{Layer, Paint, TextureBody};
use crate::scene::{
    Camera, Finish, Fog, Media, Normal, Object, Pigment, Rainbow, Scene, Settings, Shape, SkySphere, Texture,
};
use crate::source::Span;

/// What the statements of a scene have said so far.
#[derive(Debug)]
pub struct State {
    /// A pigment that nothing was said about: black.
    pub(super) unset: Arc<Pigment>,
    /// The default texture: always a single layer.
    pub(super) texture: Texture,
    /// What a normal starts from where the default texture has none.
    pub(super) bumps: Bumps,
    /// What a camera starts from.
    pub(super) camera: Draft,
    /// `#default { radiosity { importance } }`.
    pub(super) importance: Option<f64>,
    /// `global_settings`.
    pub(super) settings: Settings,
    /// `noise_generator` was written.
    pub(super) has_noise_generator: bool,
    pub(super) scene_camera: Option<Camera>,
    pub(super) background: Option<Rgbft>,
    pub(super) sky_sphere: Option<SkySphere>,
    pub(super) fogs: Vec<Fog>,
    pub(super) rainbows: Vec<Rainbow>,
    pub(super) atmosphere: Vec<Media>,
    /// The last finish: others alike share it.
    pub(super) last_finish: Option<Arc<Finish>>,
    objects: Vec<Arc<Object>>,
}

impl Default for State {
    fn default() -> Self {
        let unset = Arc::new(Pigment::color(Rgbft::BLACK));
        let layer = Layer {
            span: Span::default(),
            paint: Paint::Pigment(Arc::clone(&unset)),
            normal: None,
            finish: Arc::default(),
        };
        Self {
            unset,
            texture: layer.into(),
            bumps: Bumps::default(),
            camera: Draft::default(),
            importance: None,
            settings: Settings::default(),
            has_noise_generator: false,
            scene_camera: None,
            background: None,
            sky_sphere: None,
            fogs: Vec::new(),
            rainbows: Vec::new(),
            atmosphere: Vec::new(),
            last_finish: None,
            objects: Vec::new(),
        }
    }
}

impl State {
    /// A pigment that nothing was said about.
    pub(super) fn empty(&self) -> Arc<Pigment> {
        Arc::clone(&self.unset)
    }

    /// The settings as they are now, in a language version (times 100) that was `written` or not.
    pub fn settings_in(&self, version: i32, written: bool) -> Settings {
        let mut settings = self.settings.clone();
        settings.version = written.then_some(version.unsigned_abs());
        if version < 350 && !self.has_noise_generator {
            settings.noise_generator = 1;
        }
        settings
    }

    /// The default texture's only layer, to be changed.
    pub(super) fn layer(&mut self) -> &mut Layer {
        let body = Arc::make_mut(&mut self.texture.body);
        if !matches!(body, TextureBody::Layered(layers) if layers.len() == 1) {
            *body = Arc::unwrap_or_clone(Texture::default().body);
        }
        match body {
            TextureBody::Layered(layers) => &mut layers[0],
            _ => unreachable!("the default texture is a single layer"),
        }
    }

    fn top(&self) -> Option<&Layer> {
        match &*self.texture.body {
            TextureBody::Layered(layers) => layers.last(),
            _ => None,
        }
    }

    /// The default pigment.
    pub(super) fn pigment(&self) -> Arc<Pigment> {
        self.top().map_or_else(|| self.empty(), |layer| layer.paint.pigment())
    }

    /// The default normal.
    pub(super) fn normal(&self) -> Option<Arc<Normal>> {
        self.top().and_then(|layer| layer.normal.clone())
    }

    /// The default finish.
    pub(super) fn finish(&self) -> Arc<Finish> {
        self.top().map(|layer| Arc::clone(&layer.finish)).unwrap_or_default()
    }

    /// Replaces the default texture; the error says why another cannot be one.
    pub(super) fn set_texture(&mut self, texture: Texture) -> Result<(), &'static str> {
        match &*texture.body {
            TextureBody::Layered(layers) if layers.len() == 1 => {
                self.texture = texture;
                Ok(())
            }
            TextureBody::Layered(_) => Err("the default texture cannot have layers"),
            _ => Err("the default texture cannot have a pattern"),
        }
    }

    /// Takes an object of the top level: what has no texture by now gets the default one.
    pub(super) fn add(&mut self, mut object: Arc<Object>) {
        if needs_texture(&object) {
            dress(Arc::make_mut(&mut object), &self.texture);
        }
        if let Some(importance) = self.importance
            && object.extra.as_ref().is_none_or(|extra| extra.radiosity_importance.is_none())
        {
            super::modifier::extra(Arc::make_mut(&mut object)).radiosity_importance = Some(importance);
        }
        self.objects.push(object);
    }
}

/// Whether an object, or a member of it, waits for the default texture.
fn needs_texture(object: &Object) -> bool {
    match &object.shape {
        Shape::Light(light) => light.looks_like.as_ref().is_some_and(|looks| needs_texture(looks)),
        Shape::LightGroup(group) => group.objects.iter().any(|object| needs_texture(object)),
        _ => object.texture.is_none(),
    }
}

/// Gives the default texture to an object, or to those members that have none
/// (docs/spec/primitives.md 7.3).
fn dress(object: &mut Object, default: &Texture) {
    if object.texture.is_some() {
        return;
    }
    match &mut object.shape {
        Shape::Light(light) => {
            if let Some(looks) = &mut Arc::make_mut(light).looks_like {
                dress(Arc::make_mut(looks.inside_mut()), default);
            }
        }
        Shape::LightGroup(group) => dress_all(Arc::make_mut(group).objects.inside_mut(), default),
        Shape::Csg(csg) if object.flags.contains(ObjectFlags::TEXTURED) => {
            let cut = object.flags.contains(ObjectFlags::CUTAWAY_TEXTURES)
                && matches!(csg.operation, CsgOperation::Intersection | CsgOperation::Difference);
            if !cut {
                dress_all(Arc::make_mut(csg).children.inside_mut(), default);
            }
        }
        _ => object.texture = Some(default.clone()),
    }
}

fn dress_all(objects: &mut [Arc<Object>], default: &Texture) {
    for object in objects {
        if needs_texture(object) {
            dress(Arc::make_mut(object), default);
        }
    }
}

/// The scene that was read, without error.
pub fn finish(mut vm: Vm) -> Option<Scene> {
    let camera = match vm.state.scene_camera.take() {
        Some(camera) => camera,
        None => {
            let draft = vm.state.camera.clone();
            let span = vm.last;
            draft.finish(&mut vm, span).ok()?
        }
    };
    if vm.state.objects.is_empty() {
        vm.remark(Severity::Warning, "the scene has no objects", "only the background will be seen");
    }
    let written = vm.version_written;
    let version = vm.version;
    let settings = vm.state.settings_in(version, written);
    let state = std::mem::take(&mut vm.state);
    Some(Scene {
        camera,
        objects: state.objects,
        // Without a statement the background is black and lets everything through.
        background: state.background.unwrap_or(Rgbft { transmit: 1.0, ..Rgbft::BLACK }),
        sky_sphere: state.sky_sphere,
        fogs: state.fogs,
        rainbows: state.rainbows,
        atmosphere: state.atmosphere,
        settings,
    })
}
