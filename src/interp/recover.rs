//! Going on after an error: what belongs to the statement that has it is skipped, and nothing in
//! it is run.

use super::directive::BlockKind;
use super::scope::Place;
use super::stream::{Token, TokenKind};
use super::value::Value;
use super::{Vm, Word};
use crate::syntax::{Directive, NO_LINK, NodeKind, Punct, Symbol};

impl Vm<'_> {
    /// Skips the rest of a top-level statement that began where braces were `depth` deep.
    pub(super) fn skip_statement(&mut self, depth: i32) {
        self.blocked = false;
        let mut entered = self.depth > depth;
        let mut first = !entered;
        loop {
            if !entered && !first && self.at_fresh_start() {
                return;
            }
            let Some(token) = self.skip_token() else { return };
            match token.kind {
                TokenKind::Punct(Punct::OpenBrace) => entered = true,
                TokenKind::Punct(Punct::CloseBrace) if self.depth <= depth => {
                    self.depth = depth;
                    return;
                }
                _ => {}
            }
            first = false;
        }
    }

    /// Skips the rest of a declaration that began where braces were `depth` deep: to its `;`, or
    /// its closing brace, or where something else begins.
    pub(super) fn skip_declaration(&mut self, depth: i32) {
        self.blocked = false;
        let mut entered = self.depth > depth;
        let mut first = !entered;
        loop {
            let next = self.peek_raw();
            if self.depth <= depth {
                match next.kind {
                    TokenKind::Punct(Punct::Semicolon) => {
                        self.skip_token();
                        return;
                    }
                    TokenKind::Punct(Punct::CloseBrace) | TokenKind::End => return,
                    TokenKind::Punct(Punct::Hash) => return,
                    _ if !first && !entered && self.at_fresh_start() => return,
                    _ => {}
                }
            }
            let Some(token) = self.skip_token() else { return };
            match token.kind {
                TokenKind::Punct(Punct::OpenBrace) => entered = true,
                TokenKind::Punct(Punct::CloseBrace) if self.depth <= depth => return,
                _ => {}
            }
            first = false;
        }
    }

    /// Whether a new statement seems to begin: a directive, a word before a brace, a known name.
    fn at_fresh_start(&mut self) -> bool {
        let token = self.peek_raw();
        match token.kind {
            TokenKind::Punct(Punct::Hash) | TokenKind::End => true,
            TokenKind::Name(symbol) => self.makes_objects(symbol),
            TokenKind::Word(word) => {
                starts_statement(word)
                    && {
                        // The word is buffered, so the node at hand is the one after it.
                        matches!(self.frame.tree.nodes.get(self.frame.pos), Some(node) if node.kind == NodeKind::Punct(Punct::OpenBrace))
                    }
            }
            _ => false,
        }
    }

    fn makes_objects(&self, symbol: Symbol) -> bool {
        matches!(self.lookup(symbol), Some(Value::Object(_) | Value::Macro(_)))
    }

    /// Whether a token at the top level is what an error before it left over. Unknown words with a brace or
    /// parenthesis after them are mistakes of their own.
    pub(super) fn is_left_over(&self, token: Token) -> bool {
        let own = match token.kind {
            TokenKind::Name(symbol) => {
                !self.scopes.is_bound(symbol)
                    && (self.at_node(Punct::OpenBrace)
                        || self.at_node(Punct::OpenParen)
                        || self.at_node(Punct::Equal))
            }
            _ => false,
        };
        self.confused && !own
    }

    /// Whether the node after the token that was peeked is this mark.
    pub(super) fn at_node(&self, mark: Punct) -> bool {
        let frame = &self.frame;
        frame.pos < frame.end && frame.tree.nodes[frame.pos].kind == NodeKind::Punct(mark)
    }

    /// Gives a name that could not be declared a value whose uses are no further errors.
    pub(super) fn poison(&mut self, symbol: Symbol) {
        if !self.scopes.is_bound(symbol) {
            self.scopes.bind_global(symbol, Place::new(Value::Poisoned));
        }
    }

    /// Takes one token without running anything; of conditionals the first arm is passed.
    /// `None` at the end of the scene.
    pub(super) fn skip_token(&mut self) -> Option<Token> {
        loop {
            if self.ahead.is_none()
                && let Some((node, span)) = self.node()
                && let NodeKind::Directive(directive, link) = node.kind
            {
                self.frame.pos += 1;
                self.skip_directive(directive, link, span);
                continue;
            }
            let token = self.next_raw();
            return (token.kind != TokenKind::End).then_some(token);
        }
    }

    fn skip_directive(&mut self, directive: Directive, link: u32, span: crate::source::Span) {
        match directive {
            Directive::Macro if link != NO_LINK => self.frame.pos = self.end_of(link as usize) + 1,
            Directive::Macro => {}
            _ if directive.opens() => {
                // Too deep is no concern here: what is skipped does not run.
                let _: super::Result<()> = self.push_block(BlockKind::Arm { last: false }, span);
            }
            _ if directive.continues() && self.pop_block().is_some() && link != NO_LINK => {
                self.frame.pos = self.end_of(link as usize) + 1;
            }
            Directive::End => {
                self.pop_block();
            }
            _ => {}
        }
    }
}

/// Whether a word before a brace is likely to begin a statement, not to continue one.
fn starts_statement(word: Word) -> bool {
    use Word::*;
    !matches!(
        word,
        Texture
            | Pigment
            | Normal
            | Finish
            | Interior
            | Material
            | Media
            | Density
            | Photons
            | ClippedBy
            | BoundedBy
            | Transform
            | ColorMap
            | ColourMap
            | PigmentMap
            | NormalMap
            | TextureMap
            | SlopeMap
            | DensityMap
            | Warp
            | Function
            | ContainedBy
    )
}
