//! From a compiled scene to a picture.

pub mod film;
pub mod jitter;
pub mod sampling;
