//! Running compiled expressions.

use crate::interp::Vm;
use crate::interp::code::{Op, Program, Slot};
use crate::interp::scope::Place;
use crate::interp::tuple::{Tuple, to_int, truth};
use crate::interp::value::Value;
use crate::syntax::Symbol;
use std::rc::Rc;

/// What gives up so often is not worth another try.
const MOST_FAILURES: u8 = 8;

impl Vm<'_> {
    /// The value of the expression at hand, if it was compiled before and can be computed that
    /// way; it is then taken. Otherwise nothing has happened.
    #[inline]
    pub(in crate::interp) fn replay(&mut self, comparisons: bool, n: u8) -> Option<Tuple> {
        if !self.is_repeating() {
            return None;
        }
        let at = match self.ahead {
            None => self.frame.pos,
            // The token that was peeked may be the first of the expression.
            Some(token) => {
                let before = self.frame.pos.checked_sub(1)?;
                let span = self.frame.tree.span(before);
                (span == token.span).then_some(before)?
            }
        };
        self.replay_at(at, (comparisons, n))
    }

    fn replay_at(&mut self, at: usize, asked: (bool, u8)) -> Option<Tuple> {
        let code = Rc::clone(&self.frame.tree);
        let mut slots = code.slots.borrow_mut();
        if slots.is_empty() {
            slots.resize(code.nodes.len() + 1, Slot::New);
        }
        let slot = &mut slots[at];
        match slot {
            Slot::Never => None,
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
                if value.is_none() {
                    program.failures.set(program.failures.get() + 1);
                    if program.failures.get() >= MOST_FAILURES {
                        code.slots.borrow_mut()[at] = Slot::Never;
                    }
                }
                value
            }
        }
    }

    fn execute(&mut self, program: &Program) -> Option<Tuple> {
        if program.end > self.frame.end || self.scopes.has_deprecated() {
            return None;
        }
        let mut stack = std::mem::take(&mut self.stack);
        stack.clear();
        self.random.start_recording();
        let done = self.steps(&program.ops, &mut stack);
        let value = done.map(|()| Tuple::new(&stack[stack.len() - usize::from(program.n)..]));
        self.stack = stack;
        match value {
            Some(_) => {
                self.ahead = None;
                self.frame.pos = program.end;
                self.last = self.frame.tree.span(program.end - 1);
            }
            None => self.random.undo(),
        }
        value
    }

    /// Runs the steps; `None` when one gives up.
    fn steps(&mut self, ops: &[Op], stack: &mut Vec<f64>) -> Option<()> {
        for op in ops {
            match *op {
                Op::Number(value) => stack.push(value),
                Op::Load(symbol, n) => self.load(symbol, n, stack)?,
                Op::Element(symbol, subscripts, n) => self.load_element(symbol, subscripts, n, stack)?,
                Op::Repeat(n) => {
                    let top = *stack.last()?;
                    stack.resize(stack.len() + usize::from(n) - 1, top);
                }
                Op::Each(f, n) => {
                    let start = stack.len() - usize::from(n);
                    stack[start..].iter_mut().for_each(|c| *c = f(*c));
                }
                Op::Checked(f) => {
                    let top = stack.last_mut()?;
                    *top = f(*top)?;
                }
                Op::Both(f) => {
                    let b = stack.pop()?;
                    let a = stack.last_mut()?;
                    *a = f(*a, b);
                }
                Op::CheckedBoth(f) => {
                    let b = stack.pop()?;
                    let a = stack.last_mut()?;
                    *a = f(*a, b)?;
                }
                Op::Zip(f, n) => zip(stack, usize::from(n), f),
                Op::Spread(f, n) => {
                    let at = stack.len() - usize::from(n) - 1;
                    let a = stack.remove(at);
                    stack[at..].iter_mut().for_each(|c| *c = f(a, *c));
                }
                Op::Divide(m, n) => {
                    let (m, n) = (usize::from(m), usize::from(n));
                    let right = stack.len() - n;
                    if stack[right..].contains(&0.0) {
                        return None;
                    }
                    if m == n {
                        zip(stack, n, |a, b| a / b);
                    } else {
                        let a = stack.remove(right - 1);
                        stack[right - 1..].iter_mut().for_each(|c| *c = a / *c);
                    }
                }
                Op::Member(index, n) => {
                    let start = stack.len() - usize::from(n);
                    stack[start] = stack[start + usize::from(index)];
                    stack.truncate(start + 1);
                }
                Op::Choose(n) => {
                    let n = usize::from(n);
                    let (no, yes) = (stack.len() - n, stack.len() - 2 * n);
                    let from = if truth(stack[yes - 1]) { yes } else { no };
                    stack.copy_within(from..from + n, yes - 1);
                    stack.truncate(yes - 1 + n);
                }
                Op::Select => {
                    let [choice, negative, zero, positive] = *stack.last_chunk::<4>()?;
                    let value = match choice {
                        choice if choice < 0.0 => negative,
                        0.0 => zero,
                        _ => positive,
                    };
                    stack.truncate(stack.len() - 4);
                    stack.push(value);
                }
                Op::Rand => {
                    let stream = stack.last_mut()?;
                    *stream = self.random.next(to_int(*stream))?;
                }
            }
        }
        Some(())
    }

    fn load(&self, symbol: Symbol, n: u8, stack: &mut Vec<f64>) -> Option<()> {
        match self.scopes.find(symbol)? {
            Place::Variable(cell) => push(&cell.borrow(), n, stack),
            Place::Element(cell, index) => match &*cell.borrow() {
                Value::Array(array) => push(array.get(*index)?, n, stack),
                _ => None,
            },
        }
    }

    fn load_element(&self, symbol: Symbol, subscripts: u8, n: u8, stack: &mut Vec<f64>) -> Option<()> {
        let Place::Variable(cell) = self.scopes.find(symbol)? else { return None };
        let value = cell.borrow();
        let Value::Array(array) = &*value else { return None };
        let start = stack.len() - usize::from(subscripts);
        if array.sizes.len() != usize::from(subscripts) {
            return None;
        }
        let index = array.index(&stack[start..]).ok()?;
        stack.truncate(start);
        push(array.get(index)?, n, stack)
    }
}

/// Pushes the components of a value that has `n` of them.
#[inline]
fn push(value: &Value, n: u8, stack: &mut Vec<f64>) -> Option<()> {
    match (value, n) {
        (Value::Float(value), 1) => stack.push(*value),
        (Value::Vector3(v), 3) => stack.extend_from_slice(v),
        (Value::Vector2(v), 2) => stack.extend_from_slice(v),
        (Value::Vector4(v), 4) => stack.extend_from_slice(&v[..]),
        (Value::Color(c), 5) => stack.extend(c.iter().map(|&c| f64::from(c))),
        _ => return None,
    }
    Some(())
}

fn zip(stack: &mut Vec<f64>, n: usize, f: impl Fn(f64, f64) -> f64) {
    let right = stack.len() - n;
    let (left, b) = stack.split_at_mut(right);
    let a = &mut left[right - n..];
    for (a, b) in a.iter_mut().zip(b) {
        *a = f(*a, *b);
    }
    stack.truncate(right);
}
