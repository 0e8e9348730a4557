//! The command lines, POV-Ray's and povista's own, and the files they leave behind.

pub mod animation;
pub mod job;
pub mod output;
pub mod picture;
pub mod povray;
mod problem;
pub mod settings;

pub use problem::Problem;
