//! POV-Ray's own command line: switches, options, INI files.

mod ini;
mod lookup;
mod switch;
mod words;

pub use lookup::Environment;
pub use words::{is_povray, read};
