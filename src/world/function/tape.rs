//! Expressions as a list of simple operations on numbered registers.

use std::sync::Arc;

use super::{Budget, Function, Internal};

/// A register's number. Parameters come first, intermediate values next, constants last.
pub type Register = u16;

/// One operation: `to` takes what the code makes of `a` and `b`.
#[derive(Clone, Debug)]
pub struct Op {
    /// What to do.
    pub code: Code,
    /// The register that takes the result.
    pub to: Register,
    /// The first operand.
    pub a: Register,
    /// The second operand.
    pub b: Register,
}

/// What an [`Op`] does.
#[derive(Clone, Debug)]
#[expect(missing_docs, reason = "the operators' usual names")]
pub enum Code {
    Copy,
    Add,
    Subtract,
    Multiply,
    Divide,
    Less,
    LessEqual,
    /// Not at most: what is no number is.
    Greater,
    /// Not less.
    GreaterEqual,
    Equal,
    NotEqual,
    And,
    Or,
    Min,
    Max,
    Negate,
    /// A function of `a`.
    Unary(fn(f64) -> f64),
    /// A function of `a` and `b`.
    Binary(fn(f64, f64) -> f64),
    /// An internal function of the registers from `a` on.
    Internal(Internal),
    /// The component with this index of a function of the registers from `a` on.
    Call(Arc<Function>, u8),
    /// The tape itself, of the registers from `a` on.
    Recursion,
    /// Goes on with this operation.
    Jump(u32),
    /// Goes on with this operation if `a` is less than 0.
    IfNegative(u32),
    /// Goes on with this operation if `a` is 0.
    IfZero(u32),
    /// Goes on with this operation if `a` is at most `b`.
    IfUpTo(u32),
}

/// Registers on the stack in the common and in the rare case.
const FEW: usize = 32;
const MANY: usize = 512;

/// A compiled expression.
#[derive(Clone, Debug)]
pub struct Tape {
    parameters: usize,
    first_constant: usize,
    constants: Box<[f64]>,
    ops: Box<[Op]>,
    result: Register,
}

impl Tape {
    /// The most registers a tape may have.
    pub const MOST_REGISTERS: usize = MANY;

    /// The arguments come in the registers from 0 on, `constants` in those from `first_constant` on;
    /// the value is in `result` at the end. `None` where there are more registers than a tape may have.
    pub fn new(
        parameters: usize,
        first_constant: usize,
        constants: Vec<f64>,
        ops: Vec<Op>,
        result: Register,
    ) -> Option<Self> {
        (first_constant + constants.len() <= MANY && parameters <= first_constant).then(|| Self {
            parameters,
            first_constant,
            constants: constants.into(),
            ops: ops.into(),
            result,
        })
    }

    /// The value for these arguments; missing ones count as 0. NaN when the budget is spent.
    pub fn run(&self, arguments: &[f64], budget: &Budget) -> f64 {
        if self.first_constant + self.constants.len() <= FEW {
            self.run_in(&mut [0.0; FEW], arguments, budget)
        } else {
            self.run_in(&mut [0.0; MANY], arguments, budget)
        }
    }

    fn run_in(&self, r: &mut [f64], arguments: &[f64], budget: &Budget) -> f64 {
        let given = arguments.len().min(self.parameters);
        r[..given].copy_from_slice(&arguments[..given]);
        r[self.first_constant..][..self.constants.len()].copy_from_slice(&self.constants);
        let mut at = 0;
        while let Some(op) = self.ops.get(at) {
            at += 1;
            let (a, b) = (r[usize::from(op.a)], r[usize::from(op.b)]);
            r[usize::from(op.to)] = match &op.code {
                Code::Copy => a,
                Code::Add => a + b,
                Code::Subtract => a - b,
                Code::Multiply => a * b,
                Code::Divide => a / b,
                Code::Less => truth(a < b),
                Code::LessEqual => truth(a <= b),
                Code::Greater => truth(a > b || is_no_number(a, b)),
                Code::GreaterEqual => truth(a >= b || is_no_number(a, b)),
                Code::Equal => truth(a == b),
                Code::NotEqual => truth(a != b),
                Code::And => truth(a != 0.0 && b != 0.0),
                Code::Or => truth(a != 0.0 || b != 0.0),
                Code::Min => {
                    if a < b {
                        a
                    } else {
                        b
                    }
                }
                Code::Max => {
                    if a < b {
                        b
                    } else {
                        a
                    }
                }
                Code::Negate => -a,
                Code::Unary(function) => function(a),
                Code::Binary(function) => function(a, b),
                Code::Internal(internal) => internal.call(&r[usize::from(op.a)..]),
                Code::Call(function, component) => {
                    let mut value = [0.0; 5];
                    if !budget.spend() {
                        return f64::NAN;
                    }
                    let arguments = &r[usize::from(op.a)..][..function.parameters];
                    function.call_within(arguments, &mut value, budget);
                    value.get(usize::from(*component)).copied().unwrap_or(0.0)
                }
                Code::Recursion => {
                    let arguments = &r[usize::from(op.a)..][..self.parameters];
                    budget.deeper(|| self.run(arguments, budget))
                }
                Code::Jump(target) => {
                    at = *target as usize;
                    continue;
                }
                Code::IfNegative(target) => {
                    at = if a < 0.0 { *target as usize } else { at };
                    continue;
                }
                Code::IfZero(target) => {
                    at = if a == 0.0 { *target as usize } else { at };
                    continue;
                }
                Code::IfUpTo(target) => {
                    if a <= b {
                        if !budget.spend() {
                            return f64::NAN;
                        }
                        at = *target as usize;
                    }
                    continue;
                }
            };
        }
        r[usize::from(self.result)]
    }
}

fn is_no_number(a: f64, b: f64) -> bool {
    a.is_nan() || b.is_nan()
}

fn truth(holds: bool) -> f64 {
    f64::from(u8::from(holds))
}
