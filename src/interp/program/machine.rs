//! The steps of compiled expressions, on a stack of floats and a text that grows.

use crate::interp::builtin::random::Random;
use crate::interp::builtin::string::{compare, leading_number};
use crate::interp::code::{Op, Program, TextOp};
use crate::interp::format::append_float;
use crate::interp::limits::MOST_CHARACTERS;
use crate::interp::scope::{Place, Scopes};
use crate::interp::tuple::{to_int, truth};
use crate::interp::value::Value;
use crate::syntax::Symbol;

/// Numbers on the stack: what needs more is not compiled. A power of two, so that no place on it has to be
/// checked.
const DEPTH: usize = 256;

/// Where compiled expressions calculate.
#[derive(Debug)]
pub(in crate::interp) struct Machine {
    stack: Box<[f64; DEPTH]>,
    /// How many numbers there are.
    top: usize,
    pub(super) text: String,
}

impl Default for Machine {
    fn default() -> Machine {
        Machine { stack: Box::new([0.0; DEPTH]), top: 0, text: String::new() }
    }
}

/// Whether steps have room on the stack, above what is kept at its bottom.
pub(super) fn fits(ops: &[Op], places: u16) -> bool {
    let mut depth = i32::from(places);
    let mut fits = true;
    for op in ops {
        depth += match *op {
            Op::Number(_) | Op::Text(TextOp::Mark) => 1,
            Op::Load(_, n) | Op::Kept(n, _) => i32::from(n),
            Op::Element(_, subscripts, n) => i32::from(n) - i32::from(subscripts),
            Op::Repeat(n) => i32::from(n) - 1,
            Op::Each(..) | Op::Checked(_) | Op::Rand | Op::Free(_) => 0,
            Op::Both(_) | Op::CheckedBoth(_) | Op::Spread(..) => -1,
            Op::Divide(m, n) if m != n => -1,
            Op::Zip(_, n) | Op::Divide(_, n) | Op::Keep(n, _) => -i32::from(n),
            Op::Member(_, n) => 1 - i32::from(n),
            Op::Choose(n) => -1 - i32::from(n),
            Op::Select | Op::Text(TextOp::Str) => -3,
            Op::Text(TextOp::Chr | TextOp::Strcmp) => -1,
            Op::Text(TextOp::Literal(_) | TextOp::Load(_) | TextOp::Strlen | TextOp::Val) => 0,
        };
        fits &= depth < DEPTH as i32;
    }
    fits
}

impl Machine {
    /// The last numbers a program left.
    pub(super) fn last(&self, count: usize) -> &[f64] {
        &self.stack[self.top - count..self.top]
    }

    #[inline(always)]
    fn push(&mut self, value: f64) {
        self.stack[self.top % DEPTH] = value;
        self.top += 1;
    }

    #[inline(always)]
    fn pop(&mut self) -> f64 {
        self.top -= 1;
        self.stack[self.top % DEPTH]
    }

    #[inline(always)]
    fn over(&mut self) -> &mut f64 {
        &mut self.stack[(self.top - 1) % DEPTH]
    }

    fn over_all(&mut self, n: u8) -> &mut [f64] {
        &mut self.stack[self.top - usize::from(n)..self.top]
    }

    fn push_all(&mut self, values: &[f64]) {
        self.stack[self.top..self.top + values.len()].copy_from_slice(values);
        self.top += values.len();
    }

    /// Runs the steps of a program, whose result is then on top; `None` when it gives up.
    pub(super) fn run(&mut self, program: &Program, scopes: &Scopes, random: &mut Random) -> Option<()> {
        self.top = usize::from(program.places);
        self.text.clear();
        for op in &program.ops {
            match *op {
                Op::Number(value) => self.push(value),
                Op::Load(name, n) => self.load(name, n, scopes)?,
                Op::Both(f) => {
                    let b = self.pop();
                    let a = self.over();
                    *a = f(*a, b);
                }
                Op::Each(f, 1) => {
                    let a = self.over();
                    *a = f(*a);
                }
                Op::Element(name, subscripts, n) => self.load_element(name, subscripts, n, scopes)?,
                Op::Repeat(n) => {
                    let value = *self.over();
                    (1..n).for_each(|_| self.push(value));
                }
                Op::Each(f, n) => self.over_all(n).iter_mut().for_each(|c| *c = f(*c)),
                Op::Checked(f) => {
                    let a = self.over();
                    *a = f(*a)?;
                }
                Op::CheckedBoth(f) => {
                    let b = self.pop();
                    let a = self.over();
                    *a = f(*a, b)?;
                }
                Op::Zip(f, n) => self.zip(n, f),
                Op::Spread(f, n) => self.spread(n, f),
                Op::Divide(m, n) => {
                    if self.over_all(n).contains(&0.0) {
                        return None;
                    }
                    if m == n { self.zip(n, |a, b| a / b) } else { self.spread(n, |a, b| a / b) }
                }
                Op::Member(index, n) => {
                    let parts = self.over_all(n);
                    parts[0] = parts[usize::from(index)];
                    self.top -= usize::from(n) - 1;
                }
                Op::Choose(n) => {
                    let n = usize::from(n);
                    let (no, yes) = (self.top - n, self.top - 2 * n);
                    let from = if truth(self.stack[yes - 1]) { yes } else { no };
                    self.stack.copy_within(from..from + n, yes - 1);
                    self.top = yes - 1 + n;
                }
                Op::Select => {
                    let [positive, zero, negative] = [self.pop(), self.pop(), self.pop()];
                    let choice = self.over();
                    *choice = match *choice {
                        choice if choice < 0.0 => negative,
                        0.0 => zero,
                        _ => positive,
                    };
                }
                Op::Rand => {
                    let stream = self.over();
                    *stream = random.next(to_int(*stream))?;
                }
                Op::Keep(n, place) => {
                    let (place, start) = (usize::from(place), self.top - usize::from(n));
                    self.stack.copy_within(start..self.top, place);
                    self.top = start;
                    if n == 5 {
                        // Variables hold colors in single precision.
                        self.stack[place..place + 5].iter_mut().for_each(|c| *c = f64::from(*c as f32));
                    }
                }
                Op::Kept(n, place) => {
                    let place = usize::from(place);
                    self.stack.copy_within(place..place + usize::from(n), self.top);
                    self.top += usize::from(n);
                }
                Op::Free(name) => scopes.find(name).is_none_or(Place::is_free).then_some(())?,
                Op::Text(op) => self.write(op, &program.texts, scopes)?,
            }
        }
        Some(())
    }

    fn zip(&mut self, n: u8, f: impl Fn(f64, f64) -> f64) {
        let (left, right) = self.over_all(2 * n).split_at_mut(usize::from(n));
        for (a, b) in left.iter_mut().zip(right) {
            *a = f(*a, *b);
        }
        self.top -= usize::from(n);
    }

    fn spread(&mut self, n: u8, f: impl Fn(f64, f64) -> f64) {
        let parts = self.over_all(n + 1);
        let a = parts[0];
        for index in 0..usize::from(n) {
            parts[index] = f(a, parts[index + 1]);
        }
        self.top -= 1;
    }

    #[inline]
    fn load(&mut self, name: Symbol, n: u8, scopes: &Scopes) -> Option<()> {
        match scopes.find(name)? {
            Place::Variable(cell) => self.load_value(&cell.borrow(), n),
            Place::Element(cell, index) => match &*cell.borrow() {
                Value::Array(array) => self.load_value(array.get(*index)?, n),
                _ => None,
            },
        }
    }

    fn load_element(&mut self, name: Symbol, subscripts: u8, n: u8, scopes: &Scopes) -> Option<()> {
        let Place::Variable(cell) = scopes.find(name)? else { return None };
        let value = cell.borrow();
        let Value::Array(array) = &*value else { return None };
        let given = self.last(usize::from(subscripts));
        if array.sizes.len() != given.len() {
            return None;
        }
        let index = array.index(given).ok()?;
        self.top -= usize::from(subscripts);
        self.load_value(array.get(index)?, n)
    }

    /// Pushes the components of a value that has `n` of them.
    #[inline]
    fn load_value(&mut self, value: &Value, n: u8) -> Option<()> {
        match (value, n) {
            (Value::Float(value), 1) => self.push(*value),
            (Value::Vector3(v), 3) => self.push_all(v),
            (Value::Vector2(v), 2) => self.push_all(v),
            (Value::Vector4(v), 4) => self.push_all(&v[..]),
            (Value::Color(c), 5) => self.push_all(&c.map(f64::from)),
            _ => return None,
        }
        Some(())
    }

    /// Runs one step that concerns strings; `None` when it gives up.
    fn write(&mut self, op: TextOp, texts: &[Box<str>], scopes: &Scopes) -> Option<()> {
        match op {
            TextOp::Literal(index) => self.text.push_str(texts.get(usize::from(index))?),
            TextOp::Load(name) => match &*scopes.find(name)?.look()? {
                Value::Text(text) => self.text.push_str(text),
                _ => return None,
            },
            TextOp::Str => {
                let [precision, length, value] = [self.pop(), self.pop(), self.pop()];
                append_float(&mut self.text, value, to_int(length), to_int(precision));
            }
            TextOp::Chr => {
                let code = u16::try_from(self.pop() as i64).ok()?;
                self.text.push(char::from_u32(code.into()).unwrap_or('\u{fffd}'));
            }
            TextOp::Mark => self.push(self.text.len() as f64),
            TextOp::Strlen | TextOp::Val => {
                let start = self.pop() as usize;
                let text = self.text.get(start..)?;
                let value = match op {
                    TextOp::Val => leading_number(text),
                    _ => text.chars().count() as f64,
                };
                self.text.truncate(start);
                self.push(value);
            }
            TextOp::Strcmp => {
                let (second, first) = (self.pop() as usize, self.pop() as usize);
                let order = compare(self.text.get(first..second)?, self.text.get(second..)?);
                self.text.truncate(first);
                self.push(order);
            }
        }
        (self.text.len() <= MOST_CHARACTERS).then_some(())
    }
}
