//! Calls of macros, docs/spec/language.md 2.8.

use super::code::Macro;
use super::stream::{Entered, Frame, TokenKind};
use super::{Result, Vm};
use crate::source::Span;
use crate::syntax::{Punct, Symbol};
use std::rc::Rc;

impl Vm<'_> {
    /// Reads the arguments of a macro whose name was just read, and goes on in its body.
    pub(super) fn call(&mut self, symbol: Symbol, called: &Rc<Macro>, span: Span) -> Result<()> {
        self.work(1, span)?;
        let name = Rc::clone(self.symbols.name(symbol));
        let blocked = std::mem::replace(&mut self.blocked, false);
        let open = self.peek()?;
        if open.kind != TokenKind::Punct(Punct::OpenParen) {
            let fault = self.expected(&format!("`(` after the macro `{name}`"));
            return Err(fault.see(called.span, "the macro"));
        }
        self.take(open);
        let arguments = self.nested(span, |vm| {
            let mut arguments = Vec::with_capacity(called.parameters.len());
            for (given, parameter) in called.parameters.iter().enumerate() {
                if let Some(place) = vm.replay_argument() {
                    arguments.push(place);
                    vm.comma()?;
                    continue;
                }
                let token = vm.peek()?;
                if token.kind == TokenKind::Punct(Punct::CloseParen) {
                    let wanted = called.parameters.len();
                    let missing = Rc::clone(vm.symbols.name(*parameter));
                    let plural = if wanted == 1 { "" } else { "s" };
                    let fault = vm.error(
                        span.to(token.span),
                        format!("macro `{name}` takes {wanted} argument{plural}, but {given} given"),
                    );
                    return Err(fault
                        .label(format!("no value for `{missing}`"))
                        .see(called.span, "the macro"));
                }
                arguments.push(vm.read_argument()?);
                vm.comma()?;
            }
            Ok(arguments)
        })?;
        let token = self.peek()?;
        if token.kind != TokenKind::Punct(Punct::CloseParen) {
            let wanted = called.parameters.len();
            let plural = if wanted == 1 { "" } else { "s" };
            let fault = self.expected(&format!("`)` after {wanted} argument{plural} of macro `{name}`"));
            return Err(fault.see(called.span, "the macro"));
        }
        self.take(token);
        self.blocked = blocked;
        self.enter_scope(span)?;
        for (&parameter, place) in called.parameters.iter().zip(arguments) {
            self.scopes.bind_local(parameter, place);
        }
        let body = Frame {
            tree: Rc::clone(&called.tree),
            pos: called.start,
            end: called.end,
            entered: Some(Entered { name: Some(symbol), span }),
            blocks: self.blocks.len(),
        };
        self.frames.push(std::mem::replace(&mut self.frame, body));
        Ok(())
    }
}
