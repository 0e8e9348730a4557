//! The compiled scene: immutable, `Sync`, no names, no spans; nothing here fails at render time.

pub mod ray;
pub mod shape;

pub use ray::{Range, Ray};
pub use shape::{Crossing, Shape};
