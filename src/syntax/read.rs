//! From pest's pairs to our nodes. This is the only file that knows pest.

mod grammar {
    #[derive(pest_derive::Parser)]
    #[grammar = "../grammar/lexical.pest"]
    #[grammar = "../grammar/sdl.pest"]
    pub(super) struct Grammar;
}

use super::tree::{DIRECTIVES, Node, NodeKind, Punct, Tree};
use super::{Directive, NO_LINK, Symbols, scan};
use crate::diag::{Diagnostic, Severity};
use crate::source::{Encoding, FileId, Source, Span};
use grammar::{Grammar, Rule};
use pest::Parser;
use rustc_hash::FxHashMap;
use std::ops::Range;

/// Stretches of text up to so many bytes are kept, and so many of them.
const LONGEST_KEPT: usize = 256;
const MOST_KEPT: usize = 4096;
/// What may stand between the quotes of a string, in bytes.
const LONGEST_STRING: usize = 255;
/// Characters of a name.
const LONGEST_NAME: usize = 255;
/// Brackets, braces and directives inside each other; the interpreter's own limits are far lower. Of a
/// file that goes deeper the rest is not read: nobody writes that, and reading it takes its time.
const DEEPEST: i32 = 10_000;
/// Comments inside each other: pest goes down a level of the stack for each.
const DEEPEST_COMMENT: usize = 250;
/// There is room for a node, and for a number, for so many bytes of text at first: lists that grow are copied, and
/// room that nothing is written to costs nothing.
const BYTES_A_NODE: usize = 8;
/// Mistakes in the text of one file that are reported before the rest is ignored.
const MOST_ERRORS: usize = 20;

/// Reads a whole file. Words are interned in `symbols`.
pub fn parse(id: FileId, source: &Source, symbols: &mut Symbols) -> Tree {
    let mut reader = Reader::new(id, source, symbols);
    if u32::try_from(source.text().len()).is_err() {
        reader.error(0, 0, "this file is longer than 4 GiB", "split it, and `#include` the parts");
    } else if source.is_binary() {
        reader.error(0, 0, "this file is not text", "a scene is a text file; was a picture given instead?");
    } else {
        reader.read();
    }
    super::link::link(&mut reader.tree.nodes);
    reader.tree
}

/// Reads a vector of plain numbers again as the marks and numbers it is written with: after an operand
/// its `<` compares.
pub fn parse_marks(span: Span, source: &Source, symbols: &mut Symbols) -> Tree {
    let mut reader = Reader::new(span.file, source, symbols);
    let start = span.start as usize;
    let marks = Grammar::parse(Rule::marks, &source.text()[start..span.end as usize]);
    for pair in marks.into_iter().flatten().flat_map(|marks| marks.into_inner()) {
        if matches!(pair.as_rule(), Rule::number | Rule::punct) {
            reader.token(pair.as_rule(), pair.as_str(), start + pair.as_span().start());
        }
    }
    reader.tree
}

struct Reader<'a> {
    tree: Tree,
    /// Brackets, braces and directives that are open.
    depth: i32,
    source: &'a Source,
    symbols: &'a mut Symbols,
    /// What stretches of text that were met are made of: long files repeat a few.
    known: FxHashMap<&'a str, Known>,
    /// The nodes of those, placed as if each stretch began its file.
    kept: Vec<Node>,
}

/// A stretch of text that was read.
#[derive(Clone)]
struct Known {
    /// Its nodes among those kept.
    nodes: Range<usize>,
    /// How many more brackets, braces and directives are open after it.
    depth: i32,
}

impl<'a> Reader<'a> {
    fn new(file: FileId, source: &'a Source, symbols: &'a mut Symbols) -> Reader<'a> {
        let tree = Tree::empty(file);
        Reader { tree, depth: 0, source, symbols, known: FxHashMap::default(), kept: Vec::new() }
    }

    /// Reads the file: plain numbers here, what is between them by pest.
    fn read(&mut self) {
        let source = self.source;
        let bytes = source.text().as_bytes();
        self.tree.nodes.reserve(bytes.len() / BYTES_A_NODE);
        self.tree.numbers.reserve(bytes.len() / BYTES_A_NODE);
        let mut at = 0;
        while at < bytes.len() && self.depth < DEEPEST {
            at = match bytes[at] {
                byte if scan::is_blank(byte) => scan::skip_blanks(bytes, at),
                b',' => self.push(NodeKind::Punct(Punct::Comma), at, at + 1),
                b'<' if scan::at_vector(bytes, at) => self.vector(bytes, at),
                _ => match scan::at_number(bytes, at).then(|| scan::number(bytes, at)).flatten() {
                    Some((value, end)) => {
                        self.tree.numbers.push(value);
                        self.push(NodeKind::Number(self.tree.numbers.len() as u32 - 1), at, end)
                    }
                    None => self.stretch(at, scan::stretch(bytes, at)),
                },
            };
        }
    }

    fn push(&mut self, kind: NodeKind, start: usize, end: usize) -> usize {
        self.tree.nodes.push(Node { kind, start: start as u32, end: end as u32 });
        end
    }

    /// Reads the vector of plain numbers that may start here, or just its `<`.
    fn vector(&mut self, bytes: &[u8], at: usize) -> usize {
        let first = self.tree.numbers.len() as u32;
        match scan::vector(bytes, at, &mut self.tree.numbers) {
            Some((len, end)) => self.push(NodeKind::Vector(len, first), at, end),
            None => self.push(NodeKind::Punct(Punct::Less), at, at + 1),
        }
    }

    /// Reads a stretch of text, or remembers what it is made of, and says where to go on.
    fn stretch(&mut self, start: usize, end: usize) -> usize {
        let source = self.source;
        let text = &source.text()[start..end];
        if let Some(known) = self.known.get(text).cloned()
            && self.depth + (known.nodes.len() as i32) < DEEPEST
        {
            let offset = start as u32;
            let nodes = self.kept[known.nodes].iter();
            self.tree.nodes.extend(nodes.map(|node| Node {
                start: node.start + offset,
                end: node.end + offset,
                ..*node
            }));
            self.depth += known.depth;
            return end;
        }
        let (nodes, errors, depth) = (self.tree.nodes.len(), self.tree.errors.len(), self.depth);
        let next = self.piece(start, text);
        if text.len() <= LONGEST_KEPT && self.known.len() < MOST_KEPT && self.tree.errors.len() == errors {
            let first = self.kept.len();
            let offset = start as u32;
            let nodes = self.tree.nodes[nodes..].iter();
            self.kept.extend(nodes.map(|node| Node {
                start: node.start - offset,
                end: node.end - offset,
                ..*node
            }));
            let known = Known { nodes: first..self.kept.len(), depth: self.depth - depth };
            self.known.insert(text, known);
        }
        next
    }

    /// Reads a piece of text by pest, and says where to go on.
    fn piece(&mut self, offset: usize, text: &str) -> usize {
        if scan::depth_of_comments(text.as_bytes()) > DEEPEST_COMMENT {
            self.error(offset, offset, "comments are nested too deeply here", "remove some of the `/*`");
            return self.source.text().len();
        }
        // Every character fits some rule.
        let pairs = Grammar::parse(Rule::piece, text);
        for pair in pairs.into_iter().flatten().flat_map(|piece| piece.into_inner()) {
            let (rule, span) = (pair.as_rule(), pair.as_span());
            match rule {
                Rule::block_rest | Rule::line_text | Rule::block_text | Rule::EOI => {}
                _ => self.token(rule, span.as_str(), offset + span.start()),
            }
            if self.depth >= DEEPEST {
                let message = format!("nested more than {DEEPEST} levels deep here");
                let at = offset + span.start();
                self.error(at, at + 1, message, "the rest of the file is not read");
                break;
            }
        }
        offset + text.len()
    }

    fn token(&mut self, rule: Rule, text: &str, start: usize) {
        let end = start + text.len();
        let kind = match rule {
            Rule::word if text.len() > LONGEST_NAME => {
                return self.error(start, end, "this name is longer than 255 characters", "shorten it");
            }
            Rule::word => NodeKind::Word(self.symbols.intern(text)),
            Rule::vector => {
                self.vector(self.source.text().as_bytes(), start);
                return;
            }
            Rule::number => {
                let (value, _) = scan::number(text.as_bytes(), 0).unwrap_or((f64::NAN, 0));
                self.tree.numbers.push(value);
                NodeKind::Number(self.tree.numbers.len() as u32 - 1)
            }
            Rule::string if self.bytes(text) - 2 > LONGEST_STRING => {
                return self.error(
                    start,
                    start + 1,
                    "this string is longer than 255 bytes",
                    "is its closing quote missing? otherwise join parts with `concat`",
                );
            }
            Rule::string => NodeKind::Text,
            Rule::directive => match directive(text) {
                Some(directive) => {
                    self.depth += i32::from(directive.opens()) - i32::from(directive == Directive::End);
                    NodeKind::Directive(directive, NO_LINK)
                }
                None => return,
            },
            Rule::hash => NodeKind::Punct(Punct::Hash),
            Rule::punct | Rule::mark => match Punct::from_text(text) {
                Some(punct) => {
                    self.depth += match punct {
                        Punct::OpenBrace | Punct::OpenBracket | Punct::OpenParen => 1,
                        Punct::CloseBrace | Punct::CloseBracket | Punct::CloseParen => -1,
                        _ => 0,
                    };
                    NodeKind::Punct(punct)
                }
                None => return,
            },
            Rule::bad_number => {
                return self.error(start, end, "a number has one decimal point", "remove the second point");
            }
            Rule::unclosed_comment => {
                return self.error(
                    start,
                    start + 2,
                    "this comment is never closed",
                    "comments nest: every `/*` needs a `*/` of its own",
                );
            }
            Rule::unclosed_string => return self.unclosed_string(text, start),
            _ => return self.illegal(text, start),
        };
        self.tree.nodes.push(Node { kind, start: start as u32, end: end as u32 });
    }

    fn bytes(&self, text: &str) -> usize {
        match self.source.encoding {
            Encoding::Utf8 => text.len(),
            Encoding::Latin1 => text.chars().count(),
        }
    }

    fn unclosed_string(&mut self, text: &str, start: usize) {
        // A backslash before a line end is what ends the string rule early.
        match text.find("\\\n").or_else(|| text.find("\\\r")) {
            Some(at) if !text[1..at].contains('"') => self.error(
                start + at,
                start + at + 1,
                "a backslash cannot stand at the end of a line in a string",
                "write `\\n` for a new line, or `\\\\` for a backslash",
            ),
            _ => self.error(start, start + 1, "this string is never closed", "add the closing `\"`"),
        }
    }

    fn illegal(&mut self, text: &str, start: usize) {
        let end = start + text.len();
        // A run of them, such as a word in another script, is one mistake.
        if let Some(Node { kind: NodeKind::Error(_), end: before, .. }) = self.tree.nodes.last_mut()
            && *before as usize == start
        {
            *before = end as u32;
            return;
        }
        let c = text.chars().next().unwrap_or_default();
        let shown = if c.is_control() { c.escape_default().to_string() } else { c.to_string() };
        let message = format!("the character `{shown}` (0x{:02X}) cannot stand here", u32::from(c));
        self.error(start, end, message, "outside strings and comments only ASCII is allowed");
    }

    fn error(&mut self, start: usize, end: usize, message: impl Into<String>, help: &str) {
        let span = Span { file: self.tree.file, start: start as u32, end: end as u32 };
        let index = self.tree.errors.len().min(MOST_ERRORS - 1);
        if self.tree.errors.len() < MOST_ERRORS {
            self.tree.errors.push(Diagnostic::new(Severity::Error, span, message).help(help));
        }
        self.tree.nodes.push(Node { kind: NodeKind::Error(index as u32), start: span.start, end: span.end });
    }
}

fn directive(text: &str) -> Option<super::Directive> {
    let start = text.rfind(|c: char| !c.is_ascii_alphabetic()).map_or(0, |at| at + 1);
    DIRECTIVES.iter().find(|(word, _)| *word == &text[start..]).map(|&(_, directive)| directive)
}

#[cfg(test)]
mod tests;
