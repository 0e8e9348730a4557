//! A scene as text: what a person would write, with every default shown.
//!
//! The text is the same on every machine, made for snapshots and for reading, not for reading back:
//! transforms are composed, identifiers and macros are gone, long lists are cut.

mod block;
mod camera;
mod environment;
mod function;
mod light;
mod object;
mod pattern;
mod settings;
mod shape;
mod texture;
mod value;

use super::Scene;
use block::Block;

impl Scene {
    /// The scene as text, the same on every machine.
    pub fn dump(&self) -> String {
        let scene = self;
        let mut text = String::new();
        settings::dump(&scene.settings).write(&mut text);
        camera::dump(&scene.camera).write(&mut text);
        Block::new("background").line(value::color(scene.background)).write(&mut text);
        if let Some(sky) = &scene.sky_sphere {
            environment::sky_sphere(sky).write(&mut text);
        }
        for fog in &scene.fogs {
            environment::fog(fog).write(&mut text);
        }
        for rainbow in &scene.rainbows {
            environment::rainbow(rainbow).write(&mut text);
        }
        for media in &scene.atmosphere {
            environment::media(media).write(&mut text);
        }
        for object in &scene.objects {
            object::dump(object).write(&mut text);
        }
        text
    }
}
