//! The compiled scene: immutable, `Sync`, no names, no spans; nothing here fails at render time.

pub mod accel;
pub mod camera;
mod csg;
pub mod extent;
pub mod function;
pub mod hit;
pub mod image;
pub mod interior;
pub mod light;
pub mod object;
pub mod parts;
pub mod pattern;
pub mod ray;
pub mod sample;
mod scratch;
pub mod shape;
pub mod surface;
pub mod texture;
pub mod warp;

pub use camera::Camera;
pub use function::Function;
pub use hit::{Geometry, Hit};
pub use interior::Interior;
pub use light::Light;
pub use object::{Leaf, Member, RayKind};
pub use ray::{Range, Ray};
pub use sample::{Colors, Field, Inside, Sample};
pub use shape::{Crossing, Shape};
pub use surface::Intersection;
