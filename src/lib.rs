//! povista renders POV-Ray scene files.
//!
//! A module imports only from those listed before it.

pub mod cli;
pub mod compile;
pub mod diag;
pub mod interp;
pub mod math;
pub mod options;
pub mod render;
pub mod scene;
pub mod source;
pub mod syntax;
pub mod world;

pub use interp::check::{Checked, check};
