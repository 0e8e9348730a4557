//! The compiled scene: immutable, `Sync`, no names, no spans; nothing here fails at render time.

pub mod camera;
pub mod interior;
pub mod light;
pub mod ray;
pub mod shape;

pub use camera::Camera;
pub use interior::Interior;
pub use light::Light;
pub use ray::{Range, Ray};
pub use shape::{Crossing, Shape};
