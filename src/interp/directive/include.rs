//! `#include`, docs/spec/language.md 2.9.

use crate::interp::code::Code;
use crate::interp::limits::MOST_SCOPES;
use crate::interp::stream::{Entered, Frame};
use crate::interp::{Fault, Result, Vm};
use crate::source::{FileId, Missing, Span};
use crate::syntax::{Directive, NodeKind, parse};
use std::rc::Rc;

impl Vm<'_> {
    /// `#include`, just read: goes on in the file.
    pub(in crate::interp) fn include(&mut self, span: Span) -> Result<()> {
        let named = self.include_name();
        let (start, name) = match named {
            Ok(named) => named,
            Err(fault) => {
                // As with a file that cannot be found.
                self.stop();
                return Err(fault);
            }
        };
        self.include_file(&name, span, start.to(self.last))
    }

    /// Reads the name of a file, and where it starts.
    fn include_name(&mut self) -> Result<(Span, String)> {
        // A directive may choose between names, but none of these.
        if let Some((node, span)) = self.node()
            && matches!(
                node.kind,
                NodeKind::Directive(Directive::Include | Directive::Declare | Directive::Local, _)
            )
        {
            let word = self.sources.text(span).to_owned();
            return Err(self.error(span, format!("expected a string after `#include`, found `{word}`")));
        }
        let start = self.peek()?.span;
        Ok((start, self.read_file_name()?))
    }

    /// Goes on in a file; `span` is the directive, `place` the name in it.
    pub(in crate::interp) fn include_file(&mut self, name: &str, span: Span, place: Span) -> Result<()> {
        let file = match self.sources.include(name) {
            Ok(file) => file,
            Err(missing) => {
                // What the file would have declared is missing from here on: reading further
                // would only report that.
                let fault = self.missing_file(name, place, missing);
                self.stop();
                return Err(fault);
            }
        };
        let tree = self.tree(file);
        self.enter_scope(span)?;
        let frame = Frame {
            end: tree.nodes.len(),
            tree,
            pos: 0,
            entered: Some(Entered { name: None, span: span.to(place) }),
            blocks: self.blocks.len(),
        };
        self.frames.push(std::mem::replace(&mut self.frame, frame));
        Ok(())
    }

    /// The nodes of a file, read once.
    pub(in crate::interp) fn tree(&mut self, file: FileId) -> Rc<Code> {
        if let Some(tree) = self.trees.get(&file) {
            return Rc::clone(tree);
        }
        let tree = Code::new(parse(file, self.sources.get(file), &mut self.symbols));
        for error in &tree.errors {
            self.report(error.clone());
        }
        self.trees.insert(file, Rc::clone(&tree));
        tree
    }

    /// The error for a file that cannot be read.
    pub(in crate::interp) fn missing_file(&mut self, name: &str, place: Span, missing: Missing) -> Fault {
        match missing {
            Missing::NotFound(folders) => {
                let fault = self.error(place, format!("cannot find the file `{name}`")).label("not found");
                let mut shown: Vec<String> = Vec::new();
                for folder in folders {
                    let folder = match folder.as_os_str().is_empty() {
                        true => "the current folder".to_owned(),
                        false => folder.display().to_string(),
                    };
                    // The scene's own folder, asked last, is often one of the others.
                    if !shown.contains(&folder) {
                        shown.push(folder);
                    }
                }
                fault.help(format!("looked in {}; `+L` adds a folder", shown.join(", ")))
            }
            Missing::Folder(path) => {
                self.error(place, format!("`{}` is a folder, not a file", path.display()))
            }
            Missing::Unreadable(path, error) => {
                self.error(place, format!("cannot read `{}`: {error}", path.display()))
            }
        }
    }

    /// Enters the scope of a macro or file.
    pub(in crate::interp) fn enter_scope(&mut self, span: Span) -> Result<()> {
        if self.scopes.depth() >= MOST_SCOPES {
            let message = format!("more than {MOST_SCOPES} macros and include files inside each other");
            return Err(self
                .fatal(span, message)
                .help("does a macro call itself, or a file include itself, without end?"));
        }
        self.scopes.enter();
        Ok(())
    }
}
