//! From a compiled scene to a picture.

pub mod film;
