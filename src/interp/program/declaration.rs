//! Directives that are run again: declarations as they were compiled, conditions as their
//! expressions were, and the ends of arms and turns.

use crate::interp::code::{Assignment, Program, Slot};
use crate::interp::directive::BlockKind;
use crate::interp::scope::Place;
use crate::interp::tuple::{Tuple, truth};
use crate::interp::value::Value;
use crate::interp::{Result, Vm};
use crate::source::Span;
use crate::syntax::{Directive, NO_LINK, NodeKind, Punct, Symbol};
use std::rc::Rc;

impl Vm<'_> {
    /// Runs the directive at a node, just read, if that needs no look at its tokens. Otherwise nothing has
    /// happened.
    #[inline(never)]
    pub(in crate::interp) fn rerun(
        &mut self,
        at: usize,
        directive: Directive,
        link: u32,
        span: Span,
    ) -> Result<bool> {
        match directive {
            Directive::Declare | Directive::Local => Ok(self.reassign(at).is_some()),
            Directive::If => {
                let Some(value) = self.recheck(at + 1) else { return Ok(false) };
                let blocked = std::mem::replace(&mut self.blocked, false);
                let chosen = self.choose(Ok(truth(value)), link, span);
                self.blocked = blocked;
                chosen.map(|()| true)
            }
            Directive::Else | Directive::Elseif | Directive::End
                if self.blocks.len() <= self.frame.blocks =>
            {
                Ok(false)
            }
            Directive::Else | Directive::Elseif => match self.blocks.last().map(|open| &open.kind) {
                Some(BlockKind::Arm { last: false }) if link != NO_LINK => {
                    self.next_arm(directive, link, span)?;
                    Ok(true)
                }
                _ => Ok(false),
            },
            Directive::End => match self.blocks.last().map(|open| &open.kind) {
                Some(BlockKind::Arm { .. } | BlockKind::Clause { .. }) => {
                    self.pop_block();
                    Ok(true)
                }
                Some(BlockKind::For { .. }) => {
                    self.end_for()?;
                    Ok(true)
                }
                Some(&BlockKind::While { condition, end, turns }) => {
                    Ok(turns >= super::PATIENCE && self.return_while(condition, end))
                }
                None => Ok(false),
            },
            _ => Ok(false),
        }
    }

    /// `#end` of a `#while` that was looked at already.
    fn return_while(&mut self, condition: usize, end: usize) -> bool {
        let back = std::mem::replace(&mut self.frame.pos, condition);
        let Some(value) = self.recheck(condition) else {
            self.frame.pos = back;
            return false;
        };
        if !truth(value) {
            self.pop_block();
            self.frame.pos = end + 1;
        } else if let Some(BlockKind::While { turns, .. }) = self.blocks.last_mut().map(|open| &mut open.kind)
        {
            *turns += 1;
        }
        true
    }

    /// The value of the condition whose parenthesis is at a node, if it was compiled; what follows it comes
    /// next then.
    fn recheck(&mut self, at: usize) -> Option<f64> {
        let code = Rc::clone(&self.frame.tree);
        let program = match code.slots.borrow().get(at + 1)? {
            Slot::Ready(program) if program.asked == (true, 1) && program.n == 1 => Rc::clone(program),
            _ => return None,
        };
        if code.nodes[at].kind != NodeKind::Punct(Punct::OpenParen)
            || code.nodes.get(program.end)?.kind != NodeKind::Punct(Punct::CloseParen)
        {
            return None;
        }
        let value = self.execute(&program)?.c[0];
        self.frame.pos = program.end + 1;
        self.last = code.span(program.end);
        Some(value)
    }

    /// Runs the declaration at a node, if it was compiled.
    fn reassign(&mut self, at: usize) -> Option<()> {
        let code = Rc::clone(&self.frame.tree);
        let mut slots = code.slots.borrow_mut();
        let assignment = match slots.get_mut(at)? {
            Slot::Assign(assignment) => Rc::clone(assignment),
            slot @ Slot::New => {
                *slot = Slot::Seen;
                return None;
            }
            slot @ Slot::Seen => {
                let compiled = self.compile_declaration(at);
                *slot = compiled.map_or(Slot::Never, |assignment| Slot::Assign(Rc::new(assignment)));
                return None;
            }
            Slot::Ready(_) | Slot::Never => return None,
        };
        drop(slots);
        let done = self.assign_compiled(&assignment);
        if done.is_none() && assignment.program.fail() {
            code.slots.borrow_mut()[at] = Slot::Never;
        }
        done
    }

    fn assign_compiled(&mut self, assignment: &Assignment) -> Option<()> {
        let Assignment { name, local, subscripts, program } = assignment;
        let (name, subscripts) = (*name, usize::from(*subscripts));
        if subscripts == 0 && self.scopes.find(name).is_some_and(|place| !place.is_free()) {
            return None;
        }
        self.run_program(program)?;
        if self.store(name, *local, subscripts, program).is_none() {
            self.random.undo();
            return None;
        }
        self.proceed(program);
        Some(())
    }

    /// Gives a name, or an element of its array, the value a program has left.
    fn store(&mut self, name: Symbol, local: bool, subscripts: usize, program: &Program) -> Option<()> {
        let n = usize::from(program.n);
        let value = match n {
            0 => {
                self.reserve_unnoticed(self.machine.text.len())?;
                Value::Text(self.machine.text.as_str().into())
            }
            1 => Value::Float(self.machine.last(1)[0]),
            _ => Value::from(Tuple::new(self.machine.last(n))),
        };
        if subscripts > 0 {
            let Place::Variable(cell) = self.scopes.find(name)? else { return None };
            let mut held = cell.borrow_mut();
            let Value::Array(array) = &mut *held else { return None };
            let given = &self.machine.last(subscripts + n)[..subscripts];
            if array.sizes.len() != subscripts {
                return None;
            }
            let index = array.index(given).ok()?;
            let array = Rc::get_mut(array)?;
            let new = array.get(index).is_none();
            array.set(index, value).ok()?;
            drop(held);
            if new {
                self.made_something();
            }
            return Some(());
        }
        let known = if local { self.scopes.find_local(name) } else { self.scopes.find(name) };
        match known {
            Some(Place::Variable(cell)) => *cell.borrow_mut() = value,
            Some(Place::Element(..)) => return None,
            None if local => self.scopes.bind_local(name, Place::new(value)),
            None => self.scopes.bind_global(name, Place::new(value)),
        }
        Some(())
    }
}
