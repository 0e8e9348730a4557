//! `#macro`: keeps a stretch of the file for later, docs/spec/language.md 2.8.

use crate::interp::code::Macro;
use crate::interp::limits::MOST_PARAMETERS;
use crate::interp::scope::Place;
use crate::interp::stream::TokenKind;
use crate::interp::value::Value;
use crate::interp::{Result, Vm};
use crate::source::Span;
use crate::syntax::{NO_LINK, Punct, Symbol};
use std::rc::Rc;

impl Vm<'_> {
    /// `#macro`, just read.
    pub(super) fn define_macro(&mut self, link: u32, span: Span) -> Result<()> {
        let end = if link == NO_LINK { self.frame.end } else { self.end_of(link as usize) };
        if end >= self.frame.end {
            let fault = self.fatal(span, "`#macro` without `#end` in this file");
            return Err(fault
                .help("every `#if`, `#while`, `#for` and `#switch` in its body needs an `#end` of its own"));
        }
        let named = self.peek_raw();
        let head = self.read_macro_head();
        let start = self.frame.pos;
        self.ahead = None;
        self.frame.pos = end + 1;
        let (name, span, parameters) = match head {
            Ok(head) => head,
            Err(fault) => {
                self.settle(fault);
                if let TokenKind::Name(symbol) = named.kind {
                    self.poison(symbol);
                }
                return Ok(());
            }
        };
        let value = Macro { parameters, tree: Rc::clone(&self.frame.tree), start, end, span };
        let place = Place::new(Value::Macro(Rc::new(value)));
        self.scopes.bind_global(name, place);
        Ok(())
    }

    fn read_macro_head(&mut self) -> Result<(Symbol, Span, Vec<Symbol>)> {
        let token = self.next_raw();
        let name = match token.kind {
            TokenKind::Name(name) => name,
            TokenKind::Word(word) => {
                let fault = self.error(
                    token.span,
                    format!("`{}` is a reserved word and cannot name a macro", word.text()),
                );
                return Err(fault.help("names with a capital letter are never reserved"));
            }
            _ => return Err(self.expected_at(token, "the name of the macro")),
        };
        if let Some(value) = self.lookup(name)
            && !matches!(value, Value::Macro(_) | Value::Poisoned)
        {
            let text = self.symbols.name(name).clone();
            let fault = self.error(token.span, format!("`{text}` is {} already", value.kind()));
            return Err(fault.help(format!("`#undef {text}` first, or take another name")));
        }
        if self.version < 310 {
            let fault = self.error(token.span, "macros came with version 3.1 of the language");
            return Err(fault.help("write `#version 3.7;` before it"));
        }
        let open = self.next_raw();
        if open.kind != TokenKind::Punct(Punct::OpenParen) {
            let text = self.symbols.name(name).clone();
            let fault = self.expected_at(open, &format!("`(` after the name of macro `{text}`"));
            return Err(fault.help(format!("a macro without parameters is written `#macro {text}()`")));
        }
        let mut parameters = Vec::new();
        loop {
            let token = self.next_raw();
            match token.kind {
                TokenKind::Punct(Punct::CloseParen) => break,
                TokenKind::Name(_) if parameters.len() == MOST_PARAMETERS => {
                    return Err(
                        self.error(token.span, format!("a macro has at most {MOST_PARAMETERS} parameters"))
                    );
                }
                TokenKind::Name(parameter) => parameters.push(parameter),
                TokenKind::Word(word) => {
                    let message = format!("`{}` is a reserved word and cannot name a parameter", word.text());
                    return Err(self.error(token.span, message));
                }
                _ => {
                    return Err(self
                        .expected_at(token, "the name of a parameter")
                        .see(open.span, "in these parentheses"));
                }
            }
            if self.peek_raw().kind == TokenKind::Punct(Punct::Comma) {
                self.next_raw();
            }
        }
        Ok((name, token.span, parameters))
    }
}
