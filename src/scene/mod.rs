//! The description of a scene: what the language said, and nothing of how it said it.
//!
//! A reader of a [`Scene`] never has to worry about these again:
//! - identifiers, macros, loops and files are gone; every value is here, with its default where none was written;
//! - expressions are evaluated; user functions stay, as expression trees;
//! - transforms are composed into [`Transform`](crate::math::Transform)s from the inner to the outer space;
//! - colours have five components, linear in the scene's working space;
//! - angles are in degrees, as the user wrote them;
//! - it is plain data: no trait objects, no caches. Big parts are shared behind [`Arc`].
//!
//! Spans remain, so that later stages can point at the text.

pub mod atmosphere;
pub mod camera;
pub mod depth;
mod dump;
pub mod function;
pub mod image;
pub mod interior;
pub mod light;
pub mod object;
pub mod pattern;
pub mod pigment;
pub mod settings;
pub mod shape;
pub mod spline;
pub mod texture;

use std::sync::Arc;

pub use atmosphere::{Fog, Rainbow, SkySphere};
pub use camera::Camera;
pub use function::Function;
pub use interior::{Interior, Media};
pub use light::Light;
pub use object::Object;
pub use pattern::{Field, Pattern};
pub use pigment::{Density, Pigment};
pub use settings::Settings;
pub use shape::Shape;
pub use spline::Spline;
pub use texture::{Finish, Normal, Texture};

use crate::math::Rgbft;

/// Everything a scene file says.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The eye; the last `camera` statement, or POV-Ray's default camera.
    pub camera: Camera,
    /// Top-level objects, lights among them, in the order they were written.
    pub objects: Vec<Arc<Object>>,
    /// What a ray sees that hits nothing, under `sky_sphere`; black by default.
    pub background: Rgbft,
    /// The last `sky_sphere`.
    pub sky_sphere: Option<SkySphere>,
    /// All fogs; their effects add.
    pub fogs: Vec<Fog>,
    /// All rainbows.
    pub rainbows: Vec<Rainbow>,
    /// Media that fills all of space.
    pub atmosphere: Vec<Media>,
    /// `global_settings` and the language version.
    pub settings: Settings,
}
