//! Tokens, one after another, whatever file or macro they stand in.
//!
//! [`Vm::peek`] runs the directives and calls the macros it meets, so that readers of statements
//! never see them. In the blocked zones of docs/spec/language.md 2.2 [`Vm::peek_raw`] is used,
//! which runs nothing: there a directive looks like a lone `#`.

use super::code::Code;
use super::scope::Place;
use super::value::Value;
use super::{Fault, Result, Vm, Word};
use crate::source::Span;
use crate::syntax::{Node, NodeKind, Punct, Symbol, parse_marks};
use std::rc::Rc;

/// A token as readers get it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Token {
    /// What it is.
    pub kind: TokenKind,
    /// Where it stands.
    pub span: Span,
}

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TokenKind {
    /// A reserved word.
    Word(Word),
    /// Any other word; never one that stands for a macro, unless read raw.
    Name(Symbol),
    /// A number.
    Number(f64),
    /// A vector of plain numbers: how many, and the first one's place among those of the current file.
    Vector(u8, u32),
    /// A string literal.
    Text,
    /// Punctuation. A directive read raw is a [`Punct::Hash`].
    Punct(Punct),
    /// What is no token of the language; that was reported when the file was read.
    Bad,
    /// The end of the scene.
    End,
}

/// What the tokens come from: a file, or the body of a macro within one.
#[derive(Debug)]
pub(super) struct Frame {
    pub tree: Rc<Code>,
    /// The next node.
    pub pos: usize,
    /// The node to stop before.
    pub end: usize,
    /// How it was entered; `None` for the scene file, and for a vector that is read as marks.
    pub entered: Option<Entered>,
    /// How many blocks were open before.
    pub blocks: usize,
}

/// How a frame was entered.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entered {
    /// The macro, or `None` for an include file.
    pub name: Option<Symbol>,
    /// The call, or the `#include`.
    pub span: Span,
}

impl Vm<'_> {
    /// The next token, without taking it. Directives before it are run, macros are expanded, and
    /// the subscripts of an array element are evaluated.
    #[inline]
    pub fn peek(&mut self) -> Result<Token> {
        match self.ahead {
            Some(token) => Ok(token),
            None => self.advance(),
        }
    }

    /// Takes the next token.
    #[inline]
    #[expect(clippy::should_implement_trait, reason = "tokens are no iterator: taking one can fail")]
    pub fn next(&mut self) -> Result<Token> {
        let token = self.peek()?;
        self.take(token);
        Ok(token)
    }

    /// Takes the token that was last peeked.
    #[inline]
    pub(super) fn take(&mut self, token: Token) {
        self.ahead = None;
        self.last = token.span;
        match token.kind {
            TokenKind::Punct(Punct::OpenBrace) => self.depth += 1,
            TokenKind::Punct(Punct::CloseBrace) => self.depth -= 1,
            _ => {}
        }
    }

    /// The next token without running anything.
    pub fn peek_raw(&mut self) -> Token {
        if let Some(token) = self.ahead {
            return token;
        }
        let Some((node, span)) = self.node() else {
            return Token { kind: TokenKind::End, span: self.end_span() };
        };
        let kind = match node.kind {
            NodeKind::Directive(..) => return Token { kind: TokenKind::Punct(Punct::Hash), span },
            NodeKind::Word(symbol) => match Word::of(symbol) {
                Some(word) => TokenKind::Word(word),
                None => return Token { kind: TokenKind::Name(symbol), span },
            },
            NodeKind::Punct(Punct::Hash) => return Token { kind: TokenKind::Punct(Punct::Hash), span },
            NodeKind::Number(index) => TokenKind::Number(self.frame.tree.numbers[index as usize]),
            NodeKind::Vector(len, first) => TokenKind::Vector(len, first),
            NodeKind::Text => TokenKind::Text,
            NodeKind::Punct(punct) => TokenKind::Punct(punct),
            NodeKind::Error(_) => TokenKind::Bad,
        };
        let token = Token { kind, span };
        self.frame.pos += 1;
        self.ahead = Some(token);
        token
    }

    /// Takes the next token without running anything.
    pub fn next_raw(&mut self) -> Token {
        let token = self.peek_raw();
        if self.ahead.is_none() && token.kind != TokenKind::End {
            self.frame.pos += 1;
        }
        self.take(token);
        token
    }

    /// The node at hand: frames that have ended are left, except the scene file.
    #[inline(always)]
    pub(super) fn node(&mut self) -> Option<(Node, Span)> {
        while self.frame.pos >= self.frame.end {
            if !self.leave_frame() {
                return None;
            }
        }
        let tree = &self.frame.tree;
        let node = tree.nodes[self.frame.pos];
        Some((node, Span { file: tree.file, start: node.start, end: node.end }))
    }

    /// Whether `[` follows in the same file or macro.
    pub(super) fn at_bracket(&self) -> bool {
        let frame = &self.frame;
        frame.pos < frame.end && frame.tree.nodes[frame.pos].kind == NodeKind::Punct(Punct::OpenBracket)
    }

    /// Finds the next token and keeps it in `ahead`.
    fn advance(&mut self) -> Result<Token> {
        loop {
            let Some((node, span)) = self.node() else {
                let token = Token { kind: TokenKind::End, span: self.end_span() };
                self.ahead = Some(token);
                return Ok(token);
            };
            self.frame.pos += 1;
            let kind = match node.kind {
                NodeKind::Word(symbol) => match Word::of(symbol) {
                    Some(word) => TokenKind::Word(word),
                    None => match self.resolve(symbol, span)? {
                        true => TokenKind::Name(symbol),
                        false => continue,
                    },
                },
                NodeKind::Number(index) => TokenKind::Number(self.frame.tree.numbers[index as usize]),
                NodeKind::Vector(len, first) => TokenKind::Vector(len, first),
                NodeKind::Text => TokenKind::Text,
                NodeKind::Punct(Punct::Hash) => {
                    // Before anything that is no directive a `#` means nothing.
                    self.dropped_hash = Some(span);
                    continue;
                }
                NodeKind::Punct(punct) => TokenKind::Punct(punct),
                NodeKind::Directive(directive, link) => {
                    let at = self.frame.pos - 1;
                    if self.is_repeating() && self.rerun(at, directive, link, span)? {
                        self.work(1, span)?;
                    } else {
                        self.run(directive, link, span)?;
                    }
                    // A directive may have looked one token ahead.
                    match self.ahead {
                        Some(token) => return Ok(token),
                        None => continue,
                    }
                }
                // It was reported when the file was read.
                NodeKind::Error(_) => return Err(Fault::reported()),
            };
            let token = Token { kind, span };
            self.ahead = Some(token);
            return Ok(token);
        }
    }

    /// Finds out what a name stands for: calls it and answers `false` if it is a macro, else
    /// leaves its place in `place`.
    #[inline]
    pub(super) fn resolve(&mut self, symbol: Symbol, span: Span) -> Result<bool> {
        self.place = None;
        let Some(place) = self.scopes.find(symbol) else { return Ok(true) };
        let array = match place {
            Place::Variable(cell) => match &*cell.borrow() {
                Value::Macro(called) => Some(Some(Rc::clone(called))),
                Value::Array(_) => Some(None),
                _ => None,
            },
            Place::Element(..) => Some(None),
        };
        let place = place.clone();
        match array {
            None => self.place = Some(place),
            Some(None) => self.place = Some(self.element(place, symbol, span)?),
            Some(Some(called)) => {
                self.note_use(symbol, span);
                self.call(symbol, &called, span)?;
                return Ok(false);
            }
        }
        self.note_place(span);
        Ok(true)
    }

    /// Leaves a frame that has ended. The scene file is never left.
    pub(super) fn leave_frame(&mut self) -> bool {
        let Some(outer) = self.frames.pop() else { return false };
        let left = std::mem::replace(&mut self.frame, outer);
        if left.entered.is_some() {
            self.scopes.leave();
        }
        if left.entered.is_some_and(|entered| entered.name.is_some()) {
            // The body of a macro is balanced, but `#break` may leave it early.
            while self.blocks.len() > left.blocks {
                self.pop_block();
            }
        }
        true
    }

    /// Goes on with the marks and numbers of the vector that was peeked, for there is an operand
    /// before it: its `<` compares.
    pub(super) fn split_vector(&mut self, span: Span) {
        self.ahead = None;
        let tree = parse_marks(span, self.sources.get(span.file), &mut self.symbols);
        let marks = Frame {
            end: tree.nodes.len(),
            tree: Code::new(tree),
            pos: 0,
            entered: None,
            blocks: self.blocks.len(),
        };
        self.frames.push(std::mem::replace(&mut self.frame, marks));
    }

    /// Makes what follows the end of the scene, so that whatever is being read comes to its end.
    pub(super) fn stop(&mut self) {
        self.stopped = true;
        while let Some(outer) = self.frames.pop() {
            self.frame = outer;
        }
        self.frame.end = 0;
        self.ahead = None;
    }

    /// Whether what is read now may be read again: in a loop, or in a macro.
    #[inline]
    pub(super) fn is_repeating(&self) -> bool {
        // A compiled expression doesn't look at names one by one, so none are made where that is to be noted.
        self.notes.is_none()
            && (self.loops > 0 || self.frame.entered.is_some_and(|entered| entered.name.is_some()))
    }

    /// The place just after the last token of the scene.
    fn end_span(&self) -> Span {
        self.frame.tree.span(self.frame.tree.nodes.len())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_token_takes_32_bytes() {
        assert_eq!(size_of::<Token>(), 32);
    }
}
