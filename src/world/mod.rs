//! The compiled scene: immutable, `Sync`, no names, no spans; nothing here fails at render time.

pub mod accel;
pub mod atmosphere;
pub mod camera;
mod csg;
pub mod extent;
pub mod facets;
pub mod function;
pub mod hit;
pub mod image;
pub mod interior;
pub mod light;
pub mod media;
pub mod narrow;
pub mod needs;
pub mod object;
pub mod outline;
pub mod parts;
pub mod pattern;
pub mod ray;
pub mod sample;
pub mod screen;
pub mod settings;
pub mod shape;
pub mod surface;
pub mod texture;
pub mod together;
pub mod umbra;
pub mod warp;

pub use atmosphere::Atmosphere;
pub use camera::Camera;
pub use function::Function;
pub use hit::{Geometry, Hit};
pub use interior::Interior;
pub use light::{Light, LightSet};
pub use media::Media;
pub use needs::Needs;
pub use object::{Leaf, Member, RayKind};
pub use ray::{Range, Ray, Rays};
pub use sample::{Colors, Field, Inside, Sample};
pub use settings::Settings;
pub use shape::{Crossing, Shape};
pub use surface::Intersection;
pub use texture::Texture;

use std::sync::Arc;

use crate::math::DVec3;

/// Everything a picture is made of.
#[derive(Debug)]
pub struct World {
    /// What rays meet.
    pub geometry: Geometry,
    /// Surfaces, by the numbers that leaves have.
    pub textures: Vec<Texture>,
    /// Fillings, by the numbers that leaves and objects have.
    pub interiors: Vec<Arc<Interior>>,
    /// Lights in the order of the text.
    pub lights: Vec<Light>,
    /// The light sets, by the numbers that leaves have.
    pub light_sets: Vec<LightSet>,
    /// The eye.
    pub camera: Camera,
    /// What is around the objects.
    pub atmosphere: Atmosphere,
    /// What holds everywhere.
    pub settings: Settings,
    /// What can't be left out.
    pub needs: Needs,
}

impl World {
    /// The numbers of the interiors around a point, in the order of the text.
    pub fn interiors_around(&self, point: DVec3) -> impl Iterator<Item = u32> {
        let objects = &self.geometry.parts().objects;
        self.geometry.surroundings(point).into_iter().map(|number| objects[number as usize].interior)
    }
}
