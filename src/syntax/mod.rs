//! Text in, nodes out.
//!
//! - The grammar is in `grammar/lexical.pest` and `grammar/sdl.pest`; pest reads each file once,
//!   or rather what is not plain numbers: `scan` takes those.
//! - A [`Tree`] is the file as tokens, with the directives of a block linked to each other.
//! - Nothing is run here, and no word but those of directives has a meaning yet.
//! - Reading never fails: what is no token becomes a node that holds the error.

mod link;
mod read;
mod scan;
mod symbol;
mod tree;

pub use read::{parse, parse_marks};
pub use symbol::{Symbol, Symbols};
pub use tree::{DIRECTIVES, Directive, NO_LINK, Node, NodeKind, Punct, Tree};
