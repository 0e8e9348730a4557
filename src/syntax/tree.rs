//! The nodes of one file.

use super::Symbol;
use crate::diag::Diagnostic;
use crate::source::{FileId, Span};

/// One token of a file: 16 bytes, text and values kept elsewhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// What it is.
    pub kind: NodeKind,
    /// Where it starts in the text.
    pub start: u32,
    /// Where it ends, exclusive.
    pub end: u32,
}

/// What a node is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NodeKind {
    /// A word, reserved or not.
    Word(Symbol),
    /// A number, by its place in [`Tree::numbers`].
    Number(u32),
    /// A vector of two to five plain numbers: how many, and the first one's place in [`Tree::numbers`].
    Vector(u8, u32),
    /// A string, its quotes included in the span.
    Text,
    /// Punctuation.
    Punct(Punct),
    /// `#` and the directive word after it. The link leads to the next node of the same block:
    /// from an `#if` to its `#elseif`, `#else` or `#end`, and so on; [`NO_LINK`] where that is not
    /// in this file.
    Directive(Directive, u32),
    /// Something that is no token, by its place in [`Tree::errors`].
    Error(u32),
}

/// The link of a directive that leads nowhere in its file.
pub const NO_LINK: u32 = u32::MAX;

/// Punctuation marks. Those after `Hash` are read, but mean nothing anywhere.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[expect(missing_docs, reason = "each is named after its mark, listed in `MARKS`")]
pub enum Punct {
    OpenBrace,
    CloseBrace,
    OpenParen,
    CloseParen,
    OpenBracket,
    CloseBracket,
    Less,
    Greater,
    LessEqual,
    GreaterEqual,
    NotEqual,
    Equal,
    Not,
    Plus,
    Minus,
    Star,
    Slash,
    And,
    Or,
    Question,
    Colon,
    Comma,
    Semicolon,
    Point,
    Hash,
    At,
    Tilde,
    Caret,
    Percent,
    Dollar,
    Backslash,
    Apostrophe,
    Backtick,
}

const MARKS: &[(&str, Punct)] = &[
    ("{", Punct::OpenBrace),
    ("}", Punct::CloseBrace),
    ("(", Punct::OpenParen),
    (")", Punct::CloseParen),
    ("[", Punct::OpenBracket),
    ("]", Punct::CloseBracket),
    ("<", Punct::Less),
    (">", Punct::Greater),
    ("<=", Punct::LessEqual),
    (">=", Punct::GreaterEqual),
    ("!=", Punct::NotEqual),
    ("=", Punct::Equal),
    ("!", Punct::Not),
    ("+", Punct::Plus),
    ("-", Punct::Minus),
    ("*", Punct::Star),
    ("/", Punct::Slash),
    ("&", Punct::And),
    ("|", Punct::Or),
    ("?", Punct::Question),
    (":", Punct::Colon),
    (",", Punct::Comma),
    (";", Punct::Semicolon),
    (".", Punct::Point),
    ("#", Punct::Hash),
    ("@", Punct::At),
    ("~", Punct::Tilde),
    ("^", Punct::Caret),
    ("%", Punct::Percent),
    ("$", Punct::Dollar),
    ("\\", Punct::Backslash),
    ("'", Punct::Apostrophe),
    ("`", Punct::Backtick),
];

impl Punct {
    /// The mark with this spelling.
    pub fn from_text(text: &str) -> Option<Punct> {
        MARKS.iter().find(|(mark, _)| *mark == text).map(|&(_, punct)| punct)
    }

    /// How it is written.
    pub fn text(self) -> &'static str {
        MARKS[self as usize].0
    }
}

/// The words that make a directive after `#`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[expect(missing_docs, reason = "each is named after its word, listed in `DIRECTIVES`")]
pub enum Directive {
    Declare,
    Local,
    Undef,
    If,
    Ifdef,
    Ifndef,
    Elseif,
    Else,
    End,
    While,
    For,
    Switch,
    Case,
    Range,
    Break,
    Macro,
    Include,
    Default,
    Version,
    Debug,
    Warning,
    Error,
    Render,
    Statistics,
    Fopen,
    Fclose,
    Read,
    Write,
}

/// Every directive word.
pub const DIRECTIVES: &[(&str, Directive)] = &[
    ("declare", Directive::Declare),
    ("local", Directive::Local),
    ("undef", Directive::Undef),
    ("if", Directive::If),
    ("ifdef", Directive::Ifdef),
    ("ifndef", Directive::Ifndef),
    ("elseif", Directive::Elseif),
    ("else", Directive::Else),
    ("end", Directive::End),
    ("while", Directive::While),
    ("for", Directive::For),
    ("switch", Directive::Switch),
    ("case", Directive::Case),
    ("range", Directive::Range),
    ("break", Directive::Break),
    ("macro", Directive::Macro),
    ("include", Directive::Include),
    ("default", Directive::Default),
    ("version", Directive::Version),
    ("debug", Directive::Debug),
    ("warning", Directive::Warning),
    ("error", Directive::Error),
    ("render", Directive::Render),
    ("statistics", Directive::Statistics),
    ("fopen", Directive::Fopen),
    ("fclose", Directive::Fclose),
    ("read", Directive::Read),
    ("write", Directive::Write),
];

impl Directive {
    /// The word, without its `#`.
    pub fn text(self) -> &'static str {
        DIRECTIVES[self as usize].0
    }

    /// Whether an `#end` belongs to it.
    pub fn opens(self) -> bool {
        use Directive::*;
        matches!(self, If | Ifdef | Ifndef | While | For | Switch | Macro)
    }

    /// Whether it starts another arm of the block it stands in.
    pub fn continues(self) -> bool {
        use Directive::*;
        matches!(self, Elseif | Else | Case | Range)
    }
}

/// The nodes of one file, in order.
#[derive(Debug)]
pub struct Tree {
    /// The file.
    pub file: FileId,
    /// The tokens.
    pub nodes: Vec<Node>,
    /// The values of numbers, and of those in vectors.
    pub numbers: Vec<f64>,
    /// What is wrong with the text itself.
    pub errors: Vec<Diagnostic>,
}

impl Tree {
    /// A file without tokens.
    pub fn empty(file: FileId) -> Tree {
        Tree { file, nodes: Vec::new(), numbers: Vec::new(), errors: Vec::new() }
    }

    /// The numbers of a vector of plain numbers: how many, and the first one's place.
    pub fn vector(&self, len: u8, first: u32) -> &[f64] {
        let first = first as usize;
        &self.numbers[first..first + usize::from(len)]
    }

    /// The span of the node at an index, or the empty one at the end of the text.
    pub fn span(&self, index: usize) -> Span {
        match self.nodes.get(index) {
            Some(node) => Span { file: self.file, start: node.start, end: node.end },
            None => {
                let end = self.nodes.last().map_or(0, |node| node.end);
                Span { file: self.file, start: end, end }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_node_takes_sixteen_bytes() {
        assert_eq!(size_of::<Node>(), 16);
    }

    #[test]
    fn the_tables_are_in_the_order_of_their_enums() {
        for (index, &(text, punct)) in MARKS.iter().enumerate() {
            assert_eq!((punct as usize, punct.text()), (index, text));
        }
        for (index, &(text, directive)) in DIRECTIVES.iter().enumerate() {
            assert_eq!((directive as usize, directive.text()), (index, text));
        }
    }
}
