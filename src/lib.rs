//! povista renders POV-Ray scene files.
//!
//! A module imports only from those listed before it.

pub mod math;
pub mod source;
pub mod diag;
pub mod options;
pub mod syntax;
pub mod scene;
pub mod world;
pub mod compile;
pub mod interp;
pub mod render;
pub mod cli;
