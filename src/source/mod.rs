//! Text and where it stands.

pub mod span;

pub use span::{FileId, Span};
