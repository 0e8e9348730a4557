//! Noise, patterns, pigments and maps as numbers: povray and povista read the same generated scene,
//! which writes what its functions give at many points to a file.
//!
//! Each test prints a table of the largest difference of every body (`--nocapture` shows it).
//! `slope`, `aoi` and `facets` need a surface; the pictures of `tests/render` and the probe tables of
//! `docs/spec/patterns-textures.md` judge those.

mod noise;
mod patterns;
mod pigments;
mod probe;
