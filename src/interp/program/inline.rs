//! Macros whose bodies are part of an expression, compiled where they are called.
//!
//! A body is read as if it stood in place of the call, as it is when it is run: `M(1)*2` multiplies the last
//! operand of the body. Arguments are evaluated once, into places at the bottom of the stack.

use super::compile::Compiler;
use crate::interp::Word;
use crate::interp::code::{Macro, Op};
use crate::interp::value::Value;
use crate::syntax::{Directive, NodeKind, Punct, Symbol};
use std::rc::Rc;

/// Macros inside each other, and in one expression, that are worth compiling.
const DEEPEST: usize = 8;
const MOST: usize = 32;

/// An argument or a local name of a macro.
pub(super) struct Bound {
    name: Symbol,
    pub(super) size: u8,
    pub(super) place: u16,
    /// It may be another's name too, so it is not assigned here.
    argument: bool,
}

impl Compiler<'_, '_> {
    /// What a name stands for, if a macro at hand gave it that meaning.
    pub(super) fn find_bound(&self, name: Symbol) -> Option<&Bound> {
        self.bound.iter().rev().find(|bound| bound.name == name)
    }

    /// Goes on behind the calls of macros that have ended.
    pub(super) fn leave_macros(&mut self) {
        while self.at >= self.stop
            && let Some((code, at, stop, bound)) = self.outer.pop()
        {
            (self.code, self.at, self.stop) = (code, at, stop);
            self.bound.truncate(bound);
        }
    }

    /// Enters the macros called here, and compiles the `#local` directives their bodies begin with.
    pub(super) fn enter_macros(&mut self) -> Option<()> {
        loop {
            match self.kind()? {
                NodeKind::Word(name) if Word::of(name).is_none() => match self.macro_of(name) {
                    Some(called) => self.enter(name, called)?,
                    None => return Some(()),
                },
                NodeKind::Directive(Directive::Local, _) if !self.outer.is_empty() => self.local()?,
                _ => return Some(()),
            }
        }
    }

    fn macro_of(&self, name: Symbol) -> Option<Rc<Macro>> {
        if self.find_bound(name).is_some() {
            return None;
        }
        match self.vm.scopes.find(name)?.look().as_deref() {
            Some(Value::Macro(called)) => Some(Rc::clone(called)),
            _ => None,
        }
    }

    fn enter(&mut self, name: Symbol, called: Rc<Macro>) -> Option<()> {
        (self.outer.len() < DEEPEST && self.calls.len() < MOST).then_some(())?;
        self.at += 1;
        self.skip(Punct::OpenParen)?;
        let mut arguments = Vec::with_capacity(called.parameters.len());
        for &name in &called.parameters {
            let (size, place) = self.kept(None)?;
            arguments.push(Bound { name, size, place, argument: true });
            // Commas are optional.
            let _: Option<()> = self.skip(Punct::Comma);
        }
        self.skip(Punct::CloseParen)?;
        let back = (Rc::clone(&called.tree), called.start, called.end);
        let (code, at, stop) = (
            std::mem::replace(&mut self.code, back.0),
            std::mem::replace(&mut self.at, back.1),
            std::mem::replace(&mut self.stop, back.2),
        );
        self.outer.push((code, at, stop, self.bound.len()));
        self.bound.extend(arguments);
        self.calls.push((name, called));
        // What the body begins with is the value.
        self.starts_value = true;
        Some(())
    }

    /// Compiles a value that is kept, at a place of its own or at the one given.
    fn kept(&mut self, at: Option<(u8, u16)>) -> Option<(u8, u16)> {
        self.starts_value = true;
        let size = self.deeper(|compiler| compiler.arith(1))?;
        let place = match at {
            Some((same, place)) => (same == size).then_some(place)?,
            None => {
                let place = self.places;
                self.places = place.checked_add(u16::from(size))?;
                place
            }
        };
        self.ops.push(Op::Keep(size, place));
        Some((size, place))
    }

    /// Compiles a `#local` in the body of a macro.
    fn local(&mut self) -> Option<()> {
        self.at += 1;
        let depth = self.outer.len();
        let name = self.target()?;
        self.skip(Punct::Equal)?;
        let here = self.outer.last()?.3;
        let known = self.bound.iter().rposition(|bound| bound.name == name).filter(|&index| index >= here);
        match known.map(|index| &self.bound[index]) {
            Some(Bound { argument: true, .. }) => return None,
            Some(bound) => {
                let at = Some((bound.size, bound.place));
                self.kept(at)?;
            }
            None => {
                self.ops.push(Op::Free(name));
                let (size, place) = self.kept(None)?;
                self.bound.push(Bound { name, size, place, argument: false });
            }
        }
        self.semicolons()?;
        self.starts_value = true;
        (self.outer.len() == depth).then_some(())
    }

    /// The free name that is declared here.
    pub(super) fn target(&mut self) -> Option<Symbol> {
        let NodeKind::Word(name) = self.kind()? else { return None };
        self.at += 1;
        Word::of(name).is_none().then_some(name)
    }

    /// Takes the semicolon after a declaration, of which a second may follow.
    pub(super) fn semicolons(&mut self) -> Option<()> {
        self.skip(Punct::Semicolon)?;
        let _: Option<()> = self.skip(Punct::Semicolon);
        Some(())
    }
}
