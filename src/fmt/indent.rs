//! How far lines are indented.
//!
//! Braces need not nest with directives: an arm of an `#if` may open a brace that is closed after its `#end`. So each
//! directive that is open keeps brackets of its own, and what its first arm leaves open goes on after its `#end`.

use super::piece::{Kind, Piece};
use crate::syntax::{Directive, Punct};
use smallvec::SmallVec;

/// Columns of one level.
pub(super) const LEVEL: usize = 2;

/// A bracket that is open.
#[derive(Clone, Debug)]
struct Bracket {
    /// The indentation of the line it stands in.
    base: usize,
    /// For a bracket in an expression: the columns of what follows it in its line, each as it was written and as it is
    /// laid out.
    hanging: SmallVec<[(usize, usize); 4]>,
    /// Whether it is in an expression.
    is_inner: bool,
    /// Whether its line goes on.
    is_fresh: bool,
}

/// A directive that is open, or the whole file.
#[derive(Debug)]
struct Block {
    /// The indentation of the line it stands in.
    base: usize,
    /// The indentation of what is in it.
    content: usize,
    directive: Option<Directive>,
    /// The brackets opened in this arm.
    brackets: Vec<Bracket>,
    /// Brackets this arm closed that were open before.
    closed: usize,
    /// Both of the first arm.
    first: Option<(Vec<Bracket>, usize)>,
}

/// What is open at some place in a file.
#[derive(Debug)]
pub(super) struct Nesting {
    blocks: Vec<Block>,
    /// An `#ifndef` around the whole file doesn't indent it.
    guard: bool,
}

impl Nesting {
    /// At the start of a file, which may be between an `#ifndef` and its `#end` as a whole.
    pub(super) fn new(guarded: bool) -> Self {
        Self { blocks: vec![Block::new(0, 0, None)], guard: guarded }
    }

    /// The indentation of a line that starts with these pieces, after a token.
    pub(super) fn indentation(&self, line: &[Piece<'_>], before: Option<Kind>) -> usize {
        let Some(first) = line.first() else { return 0 };
        let block = self.block();
        if let Kind::Directive(directive) = first.kind
            && (directive.continues() || directive == Directive::End)
        {
            let in_switch = block.directive == Some(Directive::Switch) && directive.continues();
            return if in_switch { block.base + LEVEL } else { block.base };
        }
        let closing = line.iter().take_while(|piece| closes(piece.kind)).count();
        if closing > 0 {
            return match block.brackets.len().checked_sub(closing) {
                Some(left) => block.brackets[left].base,
                None => block.content,
            };
        }
        let Some(bracket) = block.brackets.last() else {
            return block.content + continuation(line, before);
        };
        match bracket.hanging.iter().find(|(written, _)| *written == first.column) {
            Some(&(_, now)) => now,
            None if bracket.is_inner => bracket.base + LEVEL,
            None => bracket.base + LEVEL + continuation(line, before),
        }
    }

    /// Starts a line.
    pub(super) fn start_line(&mut self) {
        for bracket in self.block_mut().brackets.iter_mut().rev().take_while(|bracket| bracket.is_fresh) {
            bracket.is_fresh = false;
        }
    }

    /// Takes in one piece of a line with an indentation. `next` is the piece after it in the same line, and the column
    /// that one will have.
    pub(super) fn take(&mut self, kind: Kind, indentation: usize, next: Option<(&Piece<'_>, usize)>) {
        if let Kind::Directive(directive) = kind {
            self.directive(directive, indentation);
        } else if opens(kind) {
            let is_inner = kind != Kind::Mark(Punct::OpenBrace);
            let bracket = Bracket { base: indentation, hanging: SmallVec::new(), is_inner, is_fresh: true };
            self.block_mut().brackets.push(bracket);
        } else if closes(kind) {
            let block = self.block_mut();
            if block.brackets.pop().is_none() {
                block.closed += 1;
            }
        }
        let Some((piece, now)) = next.filter(|(piece, _)| piece.kind != Kind::LineComment) else { return };
        if let Some(bracket) = self.block_mut().brackets.last_mut().filter(|b| b.is_inner && b.is_fresh) {
            bracket.hanging.push((piece.column, now));
        }
    }

    fn directive(&mut self, directive: Directive, indentation: usize) {
        if directive.opens() {
            let is_guard = std::mem::take(&mut self.guard);
            let content = if is_guard { indentation } else { indentation + LEVEL };
            self.blocks.push(Block::new(indentation, content, Some(directive)));
        } else if directive.continues() {
            let block = self.block_mut();
            if block.directive.is_some() {
                let arm = (std::mem::take(&mut block.brackets), std::mem::take(&mut block.closed));
                block.first.get_or_insert(arm);
            }
            if block.directive == Some(Directive::Switch) {
                block.content = block.base + 2 * LEVEL;
            }
        } else if directive == Directive::End && self.blocks.len() > 1 {
            self.end();
        }
    }

    fn end(&mut self) {
        let Some(block) = self.blocks.pop() else { return };
        let is_choice = matches!(
            block.directive,
            Some(Directive::If | Directive::Ifdef | Directive::Ifndef | Directive::Switch)
        );
        if !is_choice {
            return;
        }
        let (brackets, closed) = block.first.unwrap_or((block.brackets, block.closed));
        let outer = self.block_mut();
        for _ in 0..closed {
            if outer.brackets.pop().is_none() {
                outer.closed += 1;
            }
        }
        outer.brackets.extend(brackets.into_iter().map(|bracket| Bracket { base: block.base, ..bracket }));
    }

    fn block(&self) -> &Block {
        &self.blocks[self.blocks.len() - 1]
    }

    fn block_mut(&mut self) -> &mut Block {
        let last = self.blocks.len() - 1;
        &mut self.blocks[last]
    }
}

impl Block {
    fn new(base: usize, content: usize, directive: Option<Directive>) -> Self {
        Self { base, content, directive, brackets: Vec::new(), closed: 0, first: None }
    }
}

fn opens(kind: Kind) -> bool {
    matches!(kind, Kind::OpenVector | Kind::Mark(Punct::OpenBrace | Punct::OpenParen | Punct::OpenBracket))
}

fn closes(kind: Kind) -> bool {
    matches!(
        kind,
        Kind::CloseVector | Kind::Mark(Punct::CloseBrace | Punct::CloseParen | Punct::CloseBracket)
    )
}

/// How much further a line is indented that goes on with the expression of the one before.
fn continuation(line: &[Piece<'_>], before: Option<Kind>) -> usize {
    use Punct::*;
    let ends_open = matches!(
        before,
        Some(Kind::Assign | Kind::Mark(Equal | Plus | Minus | Star | Slash | And | Or | Question | Colon))
    );
    let goes_on = line.first().is_some_and(|first| {
        matches!(first.kind, Kind::Mark(Plus | Star | Slash | And | Or | Question | Colon))
    });
    // The statement that is declared may stand under its `#declare`.
    let mut kinds = line.iter().map(|piece| piece.kind);
    let is_statement = kinds.next() == Some(Kind::Word)
        && matches!(kinds.next(), None | Some(Kind::Mark(OpenBrace) | Kind::LineComment));
    let is_block =
        line.first().is_some_and(|first| first.kind.is_comment() || first.kind == Kind::Mark(OpenBrace));
    if (ends_open && !is_statement || goes_on) && !is_block { LEVEL } else { 0 }
}
