//! The compiled scene: immutable, `Sync`, no names, no spans; nothing here fails at render time.

pub mod camera;
pub mod function;
pub mod image;
pub mod interior;
pub mod light;
pub mod pattern;
pub mod ray;
pub mod sample;
pub mod shape;
pub mod texture;
pub mod warp;

pub use camera::Camera;
pub use function::Function;
pub use interior::Interior;
pub use light::Light;
pub use ray::{Range, Ray};
pub use sample::{Colors, Field, Inside, Sample};
pub use shape::{Crossing, Shape};
