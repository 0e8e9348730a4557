//! Files a scene opens itself, docs/spec/language.md 2.13.

use crate::syntax::Tree;
use std::cell::{Cell, RefCell};
use std::fs::File;
use std::io::BufWriter;
use std::rc::Rc;

/// A file opened by `#fopen`.
#[derive(Debug)]
pub enum FileHandle {
    /// For reading: its tokens, and the next one.
    Read(Rc<Tree>, Cell<usize>),
    /// For writing.
    Write(RefCell<BufWriter<File>>),
}
