//! Running compiled expressions.

use super::compile::COLOR;
use crate::interp::Vm;
use crate::interp::code::{Macro, Program, Slot};
use crate::interp::limits::MOST_SCOPES;
use crate::interp::scope::Place;
use crate::interp::tuple::Tuple;
use crate::interp::value::Value;
use crate::syntax::{NodeKind, Punct, Symbol};
use std::rc::Rc;

/// What gives up so often is not worth another try.
const MOST_FAILURES: u8 = 8;

impl Program {
    /// Notes that it gave up, and whether it did so too often in a row.
    pub(super) fn fail(&self) -> bool {
        self.failures.set(self.failures.get() + 1);
        self.failures.get() >= MOST_FAILURES
    }
}

impl Vm<'_> {
    /// The value of the expression at hand, if it was compiled before and can be computed that
    /// way; it is then taken. Otherwise nothing has happened.
    #[inline]
    pub(in crate::interp) fn replay(&mut self, comparisons: bool, n: u8) -> Option<Tuple> {
        if !self.is_repeating() {
            return None;
        }
        self.replay_at(self.next_node()?, (comparisons, n))
    }

    /// The color of the `{ rgb … }` that follows the word that was peeked, if it was compiled before; both
    /// are then taken.
    pub(in crate::interp) fn replay_color(&mut self) -> Option<[f64; 3]> {
        /// Braces that are open before it is looked at how many those are.
        const FEW: i32 = 100;
        if !self.is_repeating() || self.ahead.is_none() || self.depth > FEW {
            return None;
        }
        let [r, g, b, ..] = self.replay_at(self.next_node()? + 1, COLOR)?.c;
        self.made_something();
        Some([r, g, b])
    }

    /// The value of the argument at hand, if it was compiled before and is no name alone; it is then taken.
    pub(in crate::interp) fn replay_argument(&mut self) -> Option<Place> {
        let at = self.next_node()?;
        let program = match self.frame.tree.slots.borrow().get(at)? {
            Slot::Ready(program) if program.asked == (false, 1) => Rc::clone(program),
            _ => return None,
        };
        let NodeKind::Punct(Punct::Comma | Punct::CloseParen) = self.frame.tree.nodes.get(program.end)?.kind
        else {
            return None;
        };
        Some(Place::new(self.execute(&program)?.into()))
    }

    /// The node of the next token, if it is in the file at hand.
    fn next_node(&self) -> Option<usize> {
        match self.ahead {
            None => Some(self.frame.pos),
            Some(token) => {
                let before = self.frame.pos.checked_sub(1)?;
                (self.frame.tree.span(before) == token.span).then_some(before)
            }
        }
    }

    fn replay_at(&mut self, at: usize, asked: (bool, u8)) -> Option<Tuple> {
        let code = Rc::clone(&self.frame.tree);
        let mut slots = code.slots.borrow_mut();
        if slots.is_empty() {
            slots.resize(code.nodes.len() + 1, Slot::New);
        }
        let slot = &mut slots[at];
        match slot {
            Slot::Never | Slot::Assign(_) => None,
            Slot::New => {
                *slot = Slot::Seen;
                None
            }
            Slot::Seen => {
                *slot = match self.compile(at, asked) {
                    Some(program) => Slot::Ready(Rc::new(program)),
                    None => Slot::Never,
                };
                None
            }
            Slot::Ready(program) => {
                let program = Rc::clone(program);
                drop(slots);
                let value = if program.asked == asked { self.execute(&program) } else { None };
                if value.is_none() && program.fail() {
                    code.slots.borrow_mut()[at] = Slot::Never;
                }
                value
            }
        }
    }

    /// The value of a program, after which reading goes on. Otherwise nothing has happened.
    #[inline]
    pub(super) fn execute(&mut self, program: &Program) -> Option<Tuple> {
        self.run_program(program)?;
        self.proceed(program);
        Some(Tuple::new(self.machine.last(usize::from(program.n))))
    }

    /// Goes on behind what was computed.
    #[inline]
    pub(super) fn proceed(&mut self, program: &Program) {
        program.failures.set(0);
        self.ahead = None;
        self.frame.pos = program.end;
        self.last = self.frame.tree.span(program.end - 1);
    }

    /// Leaves the result of a program in the machine; `None`, and nothing has happened, when it gives up.
    #[inline]
    pub(super) fn run_program(&mut self, program: &Program) -> Option<()> {
        if program.end > self.frame.end
            || self.scopes.has_deprecated()
            || !program.calls.is_empty() && self.count_calls(&program.calls).is_none()
        {
            return None;
        }
        self.random.start_recording();
        let done = self.machine.run(program, &self.scopes, &mut self.random);
        if done.is_none() {
            self.random.undo();
        }
        done
    }

    /// Makes sure that macros are what they were, and may be called.
    fn count_calls(&mut self, calls: &[(Symbol, Rc<Macro>)]) -> Option<()> {
        let same = |(name, called): &(Symbol, Rc<Macro>)| match self.scopes.find(*name) {
            Some(Place::Variable(cell)) => match &*cell.borrow() {
                Value::Macro(now) => Rc::ptr_eq(now, called),
                _ => false,
            },
            _ => false,
        };
        if !calls.iter().all(same) || self.scopes.depth() + calls.len() as u32 > MOST_SCOPES {
            return None;
        }
        self.count(calls.len() as u64);
        Some(())
    }
}
