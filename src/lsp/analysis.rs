//! What is known of a document: read once, asked often.

use crate::diag::{Collect, Diagnostic, Severity};
use crate::index::{Declaration, Index};
use crate::interp::notes::Notes;
use crate::interp::{self, Word};
use crate::lint;
use crate::options::LanguageOptions;
use crate::source::{FileId, Library, Source, Sources, Span};
use crate::syntax::{self, NodeKind, Symbol, Symbols, Tree};
use std::panic::{self, AssertUnwindSafe};

/// A document, the files it includes, and what is known of them.
#[derive(Debug)]
pub(super) struct Analysis {
    pub(super) sources: Sources,
    /// The document among them.
    pub(super) main: FileId,
    pub(super) symbols: Symbols,
    /// The document's tokens.
    pub(super) tree: Tree,
    /// The names of each file.
    pub(super) indexes: Vec<Index>,
    /// What names held.
    pub(super) notes: Notes,
    pub(super) diagnostics: Vec<Diagnostic>,
}

/// What was found by running a scene.
struct Run {
    sources: Sources,
    notes: Notes,
    diagnostics: Vec<Diagnostic>,
}

impl Analysis {
    /// Reads a document; runs it if it is a scene.
    pub(super) fn new(uri: &str, text: &str, library: Library, options: &LanguageOptions) -> Self {
        let path = super::place::path(uri).unwrap_or_default();
        let name =
            path.file_name().map_or_else(|| uri.to_owned(), |name| name.to_string_lossy().into_owned());
        let options = LanguageOptions { input_file_name: name.clone(), ..options.clone() };
        let sources = || {
            let mut sources = Sources::new(library.clone());
            let main = sources.add(Source::new(name.clone(), path.clone(), text.as_bytes().to_vec()));
            (sources, main)
        };
        let is_part = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("inc"));
        let (unread, main) = sources();
        let Run { sources, notes, diagnostics } = if is_part {
            Run { sources: unread, notes: Notes::default(), diagnostics: Vec::new() }
        } else {
            // A mistake of povista's own costs the answers that depend on a run, not the editor its server.
            panic::catch_unwind(AssertUnwindSafe(|| run(sources(), &options))).unwrap_or_else(|_| {
                let message = "reading this scene failed by a mistake of povista's own; please report it";
                let diagnostics = vec![Diagnostic::new(Severity::Error, None, message)];
                Run { sources: unread, notes: Notes::default(), diagnostics }
            })
        };
        let mut symbols = Word::symbols();
        let mut trees: Vec<Tree> = (0..)
            .zip(sources.all())
            .map(|(number, source)| syntax::parse(FileId(number), source, &mut symbols))
            .collect();
        let indexes = trees
            .iter()
            .zip(sources.all())
            .map(|(tree, source)| Index::new(tree, source.text(), &symbols))
            .collect();
        let tree = trees.swap_remove(main.0 as usize);
        let diagnostics = if is_part { tree.errors.clone() } else { diagnostics };
        Self { sources, main, symbols, tree, indexes, notes, diagnostics }
    }

    /// The document's source.
    pub(super) fn source(&self) -> &Source {
        self.sources.get(self.main)
    }

    /// The names of the document.
    pub(super) fn index(&self) -> &Index {
        &self.indexes[self.main.0 as usize]
    }

    /// The token of the document at a byte, or that ends there.
    pub(super) fn token(&self, offset: usize) -> Option<(NodeKind, Span)> {
        let nodes = &self.tree.nodes;
        let next = nodes.partition_point(|node| node.start as usize <= offset);
        let place = next.checked_sub(1)?;
        let touches = |place: &usize| (nodes[*place].end as usize) >= offset;
        // Between two tokens a name is more likely meant than a mark.
        let is_mark = matches!(nodes[place].kind, NodeKind::Punct(_));
        let before = place.checked_sub(1).filter(|_| is_mark).filter(touches);
        let place = before.or(Some(place).filter(touches))?;
        Some((nodes[place].kind, self.tree.span(place)))
    }

    /// Where a name at some place of the document is declared, as far as the text tells: there, or in the file that
    /// was included last of those that declare it.
    pub(super) fn declaration(&self, name: Symbol, at: u32) -> Option<&Declaration> {
        let others = (0..self.indexes.len()).rev().filter(|&file| file != self.main.0 as usize);
        self.index()
            .find(name, at)
            .or_else(|| others.filter_map(|file| self.indexes[file].find(name, u32::MAX)).next())
    }
}

/// Runs a scene, and looks for bad habits if it has no errors.
fn run((mut sources, main): (Sources, FileId), options: &LanguageOptions) -> Run {
    let mut sink = Collect::default();
    let (scene, notes) = interp::interpret_noting(main, &mut sources, options, &mut sink);
    let mut diagnostics = sink.diagnostics;
    if scene.is_some() {
        diagnostics.extend(lint::text(main, &sources, |_| false));
    }
    Run { sources, notes, diagnostics }
}
