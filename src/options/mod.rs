//! What the outside world chooses about a run, as plain data.
//!
//! Every value here is valid: switches, INI words and defaults were read, clipped and checked
//! by `cli`. [`LanguageOptions`] is what the interpreter may see, [`RenderOptions`] what the
//! compiler and the renderer obey.

mod language;
mod render;

pub use language::{Clock, Declared, Frames, LanguageOptions};
pub use render::{Accelerator, Antialias, AntialiasMethod, Filter, Region, RenderOptions, Sampling};
