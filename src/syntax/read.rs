//! From pest's pairs to our nodes. This is the only file that knows pest.

mod grammar {
    #[derive(pest_derive::Parser)]
    #[grammar = "../grammar/lexical.pest"]
    #[grammar = "../grammar/sdl.pest"]
    pub(super) struct Grammar;
}

use super::tree::{DIRECTIVES, Node, NodeKind, NumberVector, Punct, Tree};
use super::{Directive, NO_LINK, Symbols};
use crate::diag::{Diagnostic, Severity};
use crate::source::{Encoding, FileId, Source, Span};
use grammar::{Grammar, Rule};
use pest::Parser;

/// pest needs about fifty bytes for each byte of text, so a long file is read in pieces.
const PIECE: usize = 1 << 16;
/// What may stand between the quotes of a string, in bytes.
const LONGEST_STRING: usize = 255;
/// Characters of a name.
const LONGEST_NAME: usize = 255;
/// Brackets, braces and directives inside each other; the interpreter's own limits are far lower. Of a
/// file that goes deeper the rest is not read: nobody writes that, and reading it takes its time.
const DEEPEST: i32 = 10_000;
/// Mistakes in the text of one file that are reported before the rest is ignored.
const MOST_ERRORS: usize = 20;

/// Reads a whole file. Words are interned in `symbols`.
pub fn parse(id: FileId, source: &Source, symbols: &mut Symbols) -> Tree {
    let mut reader = Reader { tree: Tree::empty(id), depth: 0, source, symbols };
    if u32::try_from(source.text.len()).is_err() {
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
    let mut reader = Reader { tree: Tree::empty(span.file), depth: 0, source, symbols };
    let start = span.start as usize;
    let marks = Grammar::parse(Rule::marks, &source.text[start..span.end as usize]);
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
}

impl Reader<'_> {
    fn read(&mut self) {
        let text = &*self.source.text;
        let (mut start, mut size) = (0, PIECE);
        while start < text.len() {
            let end = piece_end(text, start, size);
            let nodes = self.tree.nodes.len();
            let again = self.piece(start, &text[start..end], end == text.len());
            if self.depth >= DEEPEST {
                return;
            }
            if again == start {
                self.tree.nodes.truncate(nodes);
                size *= 2;
            } else {
                size = PIECE;
            }
            start = again;
        }
    }

    /// Reads one piece, and says where the next one starts: before this one's end when its last
    /// token goes on in the next.
    fn piece(&mut self, offset: usize, text: &str, last: bool) -> usize {
        let pairs = match Grammar::parse(Rule::piece, text) {
            Ok(pairs) => pairs,
            Err(_) => {
                // Every character fits some rule, so only pest's own limit on nesting is left.
                self.error(offset, offset, "comments are nested too deeply here", "remove some of the `/*`");
                return self.source.text.len();
            }
        };
        for pair in pairs.flat_map(|piece| piece.into_inner()) {
            let (rule, span) = (pair.as_rule(), pair.as_span());
            if matches!(rule, Rule::unclosed_comment | Rule::unclosed_string) && !last {
                return offset + span.start();
            }
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
        // The word of a directive may stand in the next piece.
        match self.tree.nodes.pop_if(|node| node.kind == NodeKind::Punct(Punct::Hash) && !last) {
            Some(hash) if hash.start as usize >= offset => hash.start as usize,
            _ => offset + text.len(),
        }
    }

    fn token(&mut self, rule: Rule, text: &str, start: usize) {
        let end = start + text.len();
        let kind = match rule {
            Rule::word if text.len() > LONGEST_NAME => {
                return self.error(start, end, "this name is longer than 255 characters", "shorten it");
            }
            Rule::word => NodeKind::Word(self.symbols.intern(text)),
            Rule::vector => {
                self.tree.vectors.push(vector(text));
                NodeKind::Vector(self.tree.vectors.len() as u32 - 1)
            }
            Rule::number => {
                self.tree.numbers.push(number(text));
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

/// The end of a piece that starts at `start`: where a token is not cut, if there is such a place.
fn piece_end(text: &str, start: usize, size: usize) -> usize {
    if text.len() - start <= size {
        return text.len();
    }
    let end = text.floor_char_boundary(start + size);
    // Some programs write all of a mesh on one line.
    let piece = &text[start..end];
    let cut = piece.rfind('\n').or_else(|| piece.rfind([' ', ',', '\t']));
    cut.map_or(end, |at| start + at + 1)
}

/// `1e` and `1e+` are numbers in a scene but not in Rust.
fn number(text: &str) -> f64 {
    text.trim_end_matches(['+', '-']).trim_end_matches(['e', 'E']).parse().unwrap_or(f64::NAN)
}

fn vector(text: &str) -> NumberVector {
    let mut vector = NumberVector { values: [0.0; 5], len: 0 };
    let inner = &text[1..text.len() - 1];
    for (slot, part) in vector.values.iter_mut().zip(inner.split(',')) {
        let part = part.trim_matches(|c: char| c.is_ascii_whitespace() || c.is_control());
        if !part.is_empty() {
            *slot = match part.strip_prefix('-') {
                Some(positive) => -number(positive),
                None => number(part.strip_prefix('+').unwrap_or(part)),
            };
            vector.len += 1;
        }
    }
    vector
}

fn directive(text: &str) -> Option<super::Directive> {
    let start = text.rfind(|c: char| !c.is_ascii_alphabetic()).map_or(0, |at| at + 1);
    DIRECTIVES.iter().find(|(word, _)| *word == &text[start..]).map(|&(_, directive)| directive)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> (Tree, Symbols) {
        let mut symbols = Symbols::new([]);
        let tree = parse(FileId(0), &Source::new("a.pov", "", text.into()), &mut symbols);
        (tree, symbols)
    }

    fn kinds(text: &str) -> Vec<NodeKind> {
        read(text).0.nodes.iter().map(|node| node.kind).collect()
    }

    #[test]
    fn where_a_long_file_is_cut_makes_no_difference() {
        let tail = "#  \n declare A = \"b c\"; /* d \n e */ <1.5, -2e3, 3> 12345 # // f\n macro G() #end";
        let alone = kinds(tail);
        for cut in 0..tail.len() {
            let padded = " ".repeat(PIECE - cut) + tail;
            assert_eq!(kinds(&padded).len(), alone.len(), "cut before {:?}", &tail[cut..]);
        }
    }

    #[test]
    fn a_long_line_is_not_cut_inside_a_number() {
        let numbers = 40_000;
        let (tree, _) = read(&"123456,".repeat(numbers));
        assert_eq!(tree.numbers, vec![123456.0; numbers]);
    }

    #[test]
    fn a_vector_of_plain_numbers_is_one_node() {
        let (tree, _) = read("<1, -2.5 , +3e2,> <1 -1 0> <1,2,3,4,5,6> <1,2>= 3");
        assert_eq!(tree.vectors, [NumberVector { values: [1.0, -2.5, 300.0, 0.0, 0.0], len: 3 }]);
    }

    #[test]
    fn what_is_nested_without_end_is_not_read_to_its_end() {
        for opener in ["(", "{", "[", "#if(1)", "#while(1)"] {
            let (tree, _) = read(&opener.repeat(1_000_000));
            assert_eq!(tree.errors.len(), 1, "{opener}");
            assert!(tree.nodes.len() < 10 * DEEPEST as usize, "{opener}: {}", tree.nodes.len());
        }
    }

    #[test]
    fn a_vector_can_be_read_as_marks_and_numbers() {
        let text = "x<1, -.5>y";
        let source = Source::new("a.pov", "", text.into());
        let mut symbols = Symbols::new([]);
        let span = Span { file: FileId(0), start: 1, end: 9 };
        let tree = parse_marks(span, &source, &mut symbols);
        let found: Vec<&str> =
            tree.nodes.iter().map(|node| &text[node.start as usize..node.end as usize]).collect();
        assert_eq!((found, tree.numbers), (vec!["<", "1", ",", "-", ".5", ">"], vec![1.0, 0.5]));
    }

    #[test]
    fn blocks_are_linked_and_what_crosses_files_is_not() {
        let links: Vec<u32> = kinds("#if(1) #else #while(1) #end #end #end #if(0)")
            .into_iter()
            .filter_map(|kind| match kind {
                NodeKind::Directive(_, link) => Some(link),
                _ => None,
            })
            .collect();
        assert_eq!(links, [4, 10, 9, NO_LINK, NO_LINK, NO_LINK, NO_LINK]);
    }
}
