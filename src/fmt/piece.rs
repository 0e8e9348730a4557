//! A file as the pieces that are laid out: its tokens, a vector of numbers taken apart, and its comments.

use crate::syntax::{Directive, NO_LINK, NodeKind, Punct, Tree};
use std::borrow::Cow;

/// Columns from one tabulator stop to the next.
const TAB: usize = 4;

/// What a piece is, as far as its blanks depend on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// A name or a reserved word.
    Word,
    /// A number.
    Number,
    /// The sign of a number in a vector of numbers.
    Sign,
    /// A string.
    Text,
    /// `<` of a vector.
    OpenVector,
    /// `>` of a vector.
    CloseVector,
    /// The `=` of a declaration.
    Assign,
    /// Any other mark.
    Mark(Punct),
    /// A `#` and its word.
    Directive(Directive),
    /// `//` to the end of the line.
    LineComment,
    /// `/*` to `*/`.
    BlockComment,
}

impl Kind {
    /// Whether it is a comment.
    pub(super) fn is_comment(self) -> bool {
        matches!(self, Kind::LineComment | Kind::BlockComment)
    }
}

/// A piece of text that stays as it is.
#[derive(Clone, Debug)]
pub(super) struct Piece<'a> {
    pub(super) kind: Kind,
    /// As it is written out, but for the indentation of a comment's further lines.
    pub(super) text: Cow<'a, str>,
    /// Line ends before it.
    pub(super) lines: usize,
    /// Columns of blanks before it, in its line.
    pub(super) blanks: usize,
    /// Its column, with a piece's own tabulators counted as one column.
    pub(super) column: usize,
}

/// Takes a file without mistakes apart.
pub(super) fn pieces<'a>(tree: &Tree, text: &'a str) -> Vec<Piece<'a>> {
    let mut cutter =
        Cutter { text, pieces: Vec::with_capacity(tree.nodes.len()), at: 0, column: 0, lines: 0, blanks: 0 };
    for node in &tree.nodes {
        let (start, end) = (node.start as usize, node.end as usize);
        cutter.trivia(start);
        match node.kind {
            NodeKind::Word(_) => cutter.piece(Kind::Word, end),
            NodeKind::Number(_) => cutter.piece(Kind::Number, end),
            NodeKind::Text => cutter.piece(Kind::Text, end),
            NodeKind::Punct(punct) => cutter.piece(Kind::Mark(punct), end),
            NodeKind::Directive(directive, _) => cutter.directive(directive, end),
            NodeKind::Vector(..) => cutter.vector(end),
            // There are none in a file without mistakes.
            NodeKind::Error(_) => {}
        }
    }
    cutter.trivia(text.len());
    let mut pieces = cutter.pieces;
    mark_vectors(&mut pieces);
    mark_declarations(&mut pieces);
    pieces
}

/// Whether the whole file is between an `#ifndef` and its `#end`.
pub(super) fn is_guarded(tree: &Tree) -> bool {
    match tree.nodes.first().map(|node| node.kind) {
        Some(NodeKind::Directive(Directive::Ifndef, link)) if link != NO_LINK => {
            let is_end = matches!(tree.nodes[link as usize].kind, NodeKind::Directive(Directive::End, _));
            is_end && link as usize + 1 == tree.nodes.len()
        }
        _ => false,
    }
}

/// Whether a character only separates tokens.
pub(super) fn is_blank(c: char) -> bool {
    matches!(c, ' ' | '\t' | '\n' | '\r' | '\u{b}' | '\u{c}' | '\0' | '\u{1a}')
}

/// The length of the comment a text begins with, if it does.
pub(super) fn comment_length(text: &str) -> Option<usize> {
    if text.starts_with("//") {
        return Some(text.find('\n').unwrap_or(text.len()));
    }
    if !text.starts_with("/*") {
        return None;
    }
    let bytes = text.as_bytes();
    let (mut at, mut depth) = (0, 0);
    while at < bytes.len() {
        match bytes.get(at..at + 2) {
            Some(b"/*") => (at, depth) = (at + 2, depth + 1),
            Some(b"*/") => {
                (at, depth) = (at + 2, depth - 1);
                if depth == 0 {
                    return Some(at);
                }
            }
            _ => at += 1,
        }
    }
    Some(bytes.len())
}

struct Cutter<'a> {
    text: &'a str,
    pieces: Vec<Piece<'a>>,
    /// What is before it is cut.
    at: usize,
    column: usize,
    lines: usize,
    blanks: usize,
}

impl<'a> Cutter<'a> {
    /// Counts blanks and cuts comments up to a place.
    fn trivia(&mut self, end: usize) {
        while self.at < end {
            let rest = &self.text[self.at..end];
            if let Some(length) = comment_length(rest) {
                let comment = rest[..length].trim_end_matches(is_blank);
                let kind = if comment.starts_with("//") { Kind::LineComment } else { Kind::BlockComment };
                self.push(kind, Cow::Borrowed(comment), self.at + length);
                continue;
            }
            let mut chars = rest.chars();
            match chars.next() {
                // A lone carriage return ends a line too; before a line feed it is a part of that.
                Some('\n') => self.line(),
                Some('\r') if !chars.as_str().starts_with('\n') => self.line(),
                Some('\t') => {
                    let stop = (self.column / TAB + 1) * TAB;
                    self.blanks += stop - self.column;
                    self.column = stop;
                }
                Some(' ') => (self.column, self.blanks) = (self.column + 1, self.blanks + 1),
                _ => {}
            }
            self.at += rest.len() - chars.as_str().len();
        }
    }

    fn line(&mut self) {
        (self.lines, self.column, self.blanks) = (self.lines + 1, 0, 0);
    }

    fn piece(&mut self, kind: Kind, end: usize) {
        self.push(kind, Cow::Borrowed(&self.text[self.at..end]), end);
    }

    fn push(&mut self, kind: Kind, text: Cow<'a, str>, end: usize) {
        let piece = Piece { kind, text, lines: self.lines, blanks: self.blanks, column: self.column };
        self.pieces.push(piece);
        (self.lines, self.blanks) = (0, 0);
        let written = &self.text[self.at..end];
        self.column = match written.rfind('\n') {
            Some(line) => written[line + 1..].chars().count(),
            None => self.column + written.chars().count(),
        };
        self.at = end;
    }

    /// `#  declare` becomes `#declare`, unless there is a comment in between.
    fn directive(&mut self, directive: Directive, end: usize) {
        let written = &self.text[self.at..end];
        let text = match written.contains('/') {
            true => Cow::Borrowed(written),
            false => Cow::Owned(format!("#{}", directive.text())),
        };
        self.push(Kind::Directive(directive), text, end);
    }

    fn vector(&mut self, end: usize) {
        while self.at < end {
            let rest = &self.text[self.at..end];
            let (kind, length) = match rest.as_bytes()[0] {
                b'<' => (Kind::OpenVector, 1),
                b'>' => (Kind::CloseVector, 1),
                b',' => (Kind::Mark(Punct::Comma), 1),
                b'+' | b'-' => (Kind::Sign, 1),
                _ => (Kind::Number, number_length(rest)),
            };
            self.piece(kind, self.at + length);
            let blanks = self.text[self.at..end].trim_start_matches(is_blank).len();
            self.trivia(end - blanks);
        }
    }
}

/// The length of the number a text begins with; its exponent may have a sign.
fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let part = |at: usize| match bytes[at] {
        b'0'..=b'9' | b'.' | b'e' | b'E' => true,
        b'+' | b'-' => at > 0 && matches!(bytes[at - 1], b'e' | b'E'),
        _ => false,
    };
    // At least one byte, so that cutting always goes on.
    (0..bytes.len()).find(|&at| !part(at)).unwrap_or(bytes.len()).max(1)
}

/// Finds the `<` and `>` that make vectors: between them is a comma, and nothing is closed that they are in.
fn mark_vectors(pieces: &mut [Piece<'_>]) {
    /// A bracket that is open.
    enum Open {
        /// A `<` by its place, and whether there is a comma in it.
        Less(usize, bool),
        Bracket,
    }
    let mut open: Vec<Open> = Vec::new();
    for index in 0..pieces.len() {
        match pieces[index].kind {
            Kind::Mark(Punct::Less) => open.push(Open::Less(index, false)),
            Kind::Mark(Punct::Comma) => {
                if let Some(Open::Less(_, comma)) = open.last_mut() {
                    *comma = true;
                }
            }
            Kind::Mark(Punct::Greater) => {
                if let Some(&Open::Less(start, comma)) = open.last() {
                    open.pop();
                    if comma {
                        (pieces[start].kind, pieces[index].kind) = (Kind::OpenVector, Kind::CloseVector);
                    }
                }
            }
            Kind::Mark(Punct::OpenParen | Punct::OpenBracket) => open.push(Open::Bracket),
            Kind::Mark(Punct::CloseParen | Punct::CloseBracket) => {
                while !matches!(open.pop(), None | Some(Open::Bracket)) {}
            }
            Kind::Mark(Punct::OpenBrace | Punct::CloseBrace | Punct::Semicolon) | Kind::Directive(_) => {
                open.clear()
            }
            _ => {}
        }
    }
}

/// Finds the `=` of declarations.
fn mark_declarations(pieces: &mut [Piece<'_>]) {
    let mut declaring = false;
    for piece in pieces {
        match piece.kind {
            Kind::Directive(Directive::Declare | Directive::Local) => declaring = true,
            Kind::Mark(Punct::Equal) if declaring => (piece.kind, declaring) = (Kind::Assign, false),
            Kind::Directive(_) | Kind::Mark(Punct::Semicolon | Punct::OpenBrace) => declaring = false,
            _ => {}
        }
    }
}
