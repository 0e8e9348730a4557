//! Habits that lead to mistakes, in scenes that are read without an error.
//!
//! - [`text`] looks at the files as they are written; nothing is run for it, so arms that are never read and macros
//!   that are never called are looked at too.
//! - [`geometry`] looks at what stands where in a scene that was read.
//! - Each finding has a [`Code`](crate::diag::Code), by which [`Levels`] leaves it out or makes it an error.
//! - Only the user's own files are looked at; those of others are read to know which names they use.

mod defaults;
mod deprecated;
mod isosurface;
mod levels;
mod places;
mod reserved;
mod shadowed;
mod unused;

pub use levels::{Level, Levels};
pub use places::geometry;

use crate::diag::Diagnostic;
use crate::index::Index;
use crate::interp::Word;
use crate::source::{FileId, Sources, Span};
use crate::syntax::{self, Symbol, Symbols, Tree};

/// All files of a scene, by their numbers, as far as their text tells.
struct Scene {
    symbols: Symbols,
    files: Vec<File>,
    main: FileId,
}

struct File {
    tree: Tree,
    index: Index,
    /// Whether the user wrote it.
    own: bool,
}

/// What is to be said about the text of a scene that was read: of its main file, and of those files it includes that
/// `own` says are the user's.
pub fn text(main: FileId, sources: &Sources, own: impl Fn(FileId) -> bool) -> Vec<Diagnostic> {
    let mut symbols = Word::symbols();
    let mut files = Vec::new();
    for (number, source) in (0..).zip(sources.all()) {
        let id = FileId(number);
        let tree = syntax::parse(id, source, &mut symbols);
        let index = Index::new(&tree, source.text(), &symbols);
        files.push(File { tree, index, own: id == main || own(id) });
    }
    let scene = Scene { symbols, files, main };
    let mut found = Vec::new();
    unused::names(&scene, &mut found);
    unused::parameters(&scene, &mut found);
    shadowed::names(&scene, &mut found);
    reserved::names(&scene, &mut found);
    deprecated::spellings(&scene, &mut found);
    defaults::overwritten(&scene, &mut found);
    isosurface::without_gradient(&scene, &mut found);
    found.sort_by_key(|diagnostic| diagnostic.span.map(|span| (span.file, span.start)));
    found.retain(|diagnostic| !is_allowed(diagnostic, sources));
    found
}

impl Scene {
    fn own(&self) -> impl Iterator<Item = &File> {
        self.files.iter().filter(|file| file.own)
    }

    fn name(&self, symbol: Symbol) -> &str {
        self.symbols.name(symbol)
    }
}

/// Whether a comment in the same line, or alone in the line above, says `povista: allow(CODE)`.
fn is_allowed(diagnostic: &Diagnostic, sources: &Sources) -> bool {
    let Some(Span { file, start, .. }) = diagnostic.span else { return false };
    let text = &**sources.get(file).text();
    let line_start = text[..start as usize].rfind('\n').map_or(0, |at| at + 1);
    let line = text[line_start..].lines().next().unwrap_or_default();
    let above = text[..line_start].lines().next_back().unwrap_or_default().trim_start();
    let allows = |line: &str| {
        line.split_once("povista: allow(").and_then(|(_, codes)| codes.split_once(')')).is_some_and(
            |(codes, _)| {
                codes.split(',').any(|code| crate::diag::Code::find(code.trim()) == Some(diagnostic.code))
            },
        )
    };
    allows(line) || above.starts_with("//") && allows(above)
}

#[cfg(test)]
mod tests;
