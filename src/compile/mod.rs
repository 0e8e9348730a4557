//! From the description of a scene to the compiled world.

pub mod atmosphere;
mod bounds;
pub mod camera;
mod csg;
mod extent;
pub mod flatten;
pub mod function;
pub mod image;
pub mod interior;
pub mod light;
pub mod media;
mod needs;
pub mod normal;
mod object;
pub mod pattern;
pub mod pigment;
pub mod probe;
pub mod settings;
pub mod shape;
mod tape;
pub mod texture;
mod world;

pub use world::{Compiled, compile, compile_knowing};

use std::fmt;

use crate::source::Span;

/// Part of a scene that can't be compiled, and where it was written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unsupported {
    /// The place.
    pub span: Span,
    /// What it is: a feature, or for [`Reason::Broken`] the whole message.
    pub feature: String,
    /// Why not.
    pub reason: Reason,
}

/// Why something is [`Unsupported`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// povista lacks it.
    NotYet,
    /// A file the scene names can't be used.
    Broken,
}

impl Unsupported {
    /// A feature that povista lacks.
    pub fn new(span: Span, feature: impl Into<String>) -> Self {
        Self { span, feature: feature.into(), reason: Reason::NotYet }
    }

    /// A file or value that can't be used, with a message that says why.
    pub fn broken(span: Span, message: impl Into<String>) -> Self {
        Self { span, feature: message.into(), reason: Reason::Broken }
    }
}

impl fmt::Display for Unsupported {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.reason {
            Reason::NotYet => write!(f, "not supported yet: {}", self.feature),
            Reason::Broken => f.write_str(&self.feature),
        }
    }
}

#[cfg(test)]
mod tests;
