//! `#while` and `#for`, docs/spec/language.md 2.5. The body is read in place, turn after turn.

use super::BlockKind;
use super::endless::PATIENCE;
use crate::interp::scope::Place;
use crate::interp::stream::TokenKind;
use crate::interp::tuple::truth;
use crate::interp::value::Value;
use crate::interp::{Fault, Result, Vm};
use crate::source::Span;
use crate::syntax::{Directive, NO_LINK, Punct};

const EPSILON: f64 = 1e-10;

impl Vm<'_> {
    /// `#while`, just read.
    pub(super) fn repeat_while(&mut self, link: u32, span: Span) -> Result<()> {
        let end = self.loop_end(Directive::While, link, span)?;
        let condition = self.frame.pos;
        match self.condition_value(Directive::While) {
            Ok(value) if truth(value) => self.push_block(BlockKind::While { condition, end, turns: 0 }, span),
            Ok(_) => {
                self.frame.pos = end + 1;
                Ok(())
            }
            Err(fault) => self.give_up_loop(fault, end),
        }
    }

    /// `#end` of a `#while`: the condition is read again.
    pub(super) fn end_while(&mut self) -> Result<()> {
        let Some(open) = self.blocks.last_mut() else { return Ok(()) };
        let span = open.span;
        let BlockKind::While { condition, end, turns } = &mut open.kind else { return Ok(()) };
        let (condition, end) = (*condition, *end);
        *turns += 1;
        let suspicious = *turns == PATIENCE;
        self.frame.pos = condition;
        let endless = if suspicious { self.endless(condition, end, span) } else { None };
        let value = match endless {
            Some(fault) => Err(fault),
            None => self.condition_value(Directive::While),
        };
        if !matches!(value, Ok(value) if truth(value)) {
            self.pop_block();
            self.frame.pos = end + 1;
        }
        match value {
            Ok(_) => Ok(()),
            Err(fault) => self.give_up_loop(fault, end),
        }
    }

    /// `#for`, just read.
    pub(super) fn repeat_for(&mut self, link: u32, span: Span) -> Result<()> {
        let end = self.loop_end(Directive::For, link, span)?;
        match self.read_for(end) {
            Ok((kind, true)) => self.push_block(kind, span),
            Ok((_, false)) => {
                self.frame.pos = end + 1;
                Ok(())
            }
            Err(fault) => self.give_up_loop(fault, end),
        }
    }

    /// Reads the head of a `#for`, and whether it runs at all.
    fn read_for(&mut self, end: usize) -> Result<(BlockKind, bool)> {
        let open = self.next_raw();
        if open.kind != TokenKind::Punct(Punct::OpenParen) {
            return Err(self.expected_at(open, "`(` after `#for`"));
        }
        let token = self.next_raw();
        let TokenKind::Name(name) = token.kind else {
            let fault = self.expected_at(token, "the name that counts");
            return Err(fault.help("write `#for (I, 1, 10)`; reserved words cannot count"));
        };
        if let Some(value @ (Value::Macro(_) | Value::Function(_))) = self.lookup(name) {
            return Err(self.error(
                token.span,
                format!("`{}` is {} and cannot count", self.symbols.name(name), value.kind()),
            ));
        }
        self.comma()?;
        let first = self.read_float()?;
        self.comma()?;
        let last = self.read_float()?;
        let mut step = 1.0;
        let comma = self.accept_punct(Punct::Comma)?;
        if comma || self.peek()?.kind != TokenKind::Punct(Punct::CloseParen) {
            let start = self.peek()?.span;
            step = self.read_float()?;
            if step.abs() < EPSILON {
                let fault = self.error(start.to(self.last), "the step of `#for` is zero");
                return Err(fault.help("the loop would never end"));
            }
        }
        self.close_paren(open.span)?;
        match self.scopes.find_local(name) {
            // What cannot be assigned was refused above.
            Some(place) => drop(place.set(Value::Float(first))),
            None => self.scopes.bind_local(name, Place::new(Value::Float(first))),
        }
        let runs = if step > 0.0 { first < last + EPSILON } else { first > last - EPSILON };
        Ok((BlockKind::For { name, last, step, body: self.frame.pos, end, turns: 0 }, runs))
    }

    /// `#end` of a `#for`: counts on.
    pub(in crate::interp) fn end_for(&mut self) -> Result<()> {
        let Some(open) = self.blocks.last_mut() else { return Ok(()) };
        let span = open.span;
        let BlockKind::For { name, last, step, body, end, turns } = &mut open.kind else { return Ok(()) };
        *turns += 1;
        let (name, last, step, body, end) = (*name, *last, *step, *body, *end);
        let mut value = None;
        match self.scopes.find_local(name) {
            // By far the most frequent.
            Some(Place::Variable(cell)) => {
                if let Value::Float(counted) = &mut *cell.borrow_mut() {
                    *counted += step;
                    value = Some(*counted);
                }
            }
            Some(place @ Place::Element(..)) => {
                if let Some(Value::Float(counted)) = place.get() {
                    drop(place.set(Value::Float(counted + step)));
                    value = Some(counted + step);
                }
            }
            None => {}
        }
        let Some(value) = value else {
            self.pop_block();
            let text = format!(
                "`{}` is no number any more at the end of the `#for` that counts with it",
                self.symbols.name(name)
            );
            let fault = self.error(span, text);
            return Err(fault.help("do not `#undef` it, or give it a value of another kind, in the body"));
        };
        let over = if step > 0.0 { value > last + EPSILON } else { value < last - EPSILON };
        if over {
            self.pop_block();
            self.frame.pos = end + 1;
        } else {
            self.frame.pos = body;
        }
        Ok(())
    }

    /// The node of a loop's `#end`, which has to be in the same file.
    fn loop_end(&mut self, directive: Directive, link: u32, span: Span) -> Result<usize> {
        let end = if link == NO_LINK { usize::MAX } else { self.end_of(link as usize) };
        if end >= self.frame.end {
            let fault = self.fatal(span, format!("`#{}` without `#end` in this file", directive.text()));
            return Err(fault.help("a loop has to end in the file, and in the macro, where it starts"));
        }
        Ok(end)
    }

    fn give_up_loop(&mut self, fault: Fault, end: usize) -> Result<()> {
        self.settle(fault);
        self.ahead = None;
        self.frame.pos = end + 1;
        Ok(())
    }
}
