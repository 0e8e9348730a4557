//! The constants of tapes.

use super::{CONSTANT, Writer, too_big};
use crate::compile::Unsupported;
use crate::world::function::tape::{Code, Register};
use crate::world::function::{Tape, Unary};

impl Writer<'_, '_> {
    /// The register of a number.
    pub(super) fn constant(&mut self, value: f64) -> Result<Register, Unsupported> {
        let known = self.constants.iter().position(|c| c.to_bits() == value.to_bits());
        let index = known.unwrap_or(self.constants.len());
        if known.is_none() {
            self.constants.push(value);
        }
        if index >= Tape::MOST_REGISTERS {
            return Err(too_big(self.function));
        }
        Ok(index as Register | CONSTANT)
    }

    /// The number in a register that holds a constant.
    pub(super) fn known(&self, register: Register) -> Option<f64> {
        (register & CONSTANT != 0).then(|| self.constants[usize::from(register & !CONSTANT)])
    }

    /// The first of the registers in a row that hold these constants.
    pub(super) fn run_of_constants(&mut self, values: &[f64]) -> Result<Register, Unsupported> {
        let is_same = |run: &[f64]| run.iter().zip(values).all(|(a, b)| a.to_bits() == b.to_bits());
        let known = self.constants.windows(values.len().max(1)).position(is_same);
        let index = known.unwrap_or(self.constants.len());
        if known.is_none() {
            self.constants.extend_from_slice(values);
        }
        if index + values.len() > Tape::MOST_REGISTERS {
            return Err(too_big(self.function));
        }
        Ok(index as Register | CONSTANT)
    }

    /// A sum or a product one part of which is a known number, and the register of the other.
    pub(super) fn with_number(&self, code: &Code, a: Register, b: Register) -> Option<(Code, Register)> {
        let (number, other) = match (self.known(a), self.known(b)) {
            (Some(number), None) => (number, b),
            (None, Some(number)) => (number, a),
            _ => return None,
        };
        match code {
            Code::Add => Some((Code::Plus(number), other)),
            Code::Subtract if other == a => Some((Code::Plus(-number), other)),
            Code::Multiply => Some((Code::Times(number), other)),
            _ => None,
        }
    }

    /// How many constants have to be in registers: those behind them are only parts of [sums and
    /// products](Self::with_number).
    pub(super) fn constants_read(&self, result: Register) -> usize {
        let behind = |register: Register, count: usize| match register & CONSTANT {
            0 => 0,
            _ => usize::from(register & !CONSTANT) + count,
        };
        let read = self.ops.iter().map(|op| {
            let (others, count) = match &op.code {
                Code::Internal(internal, others) => (*others, internal.parameters - others.len() - 1),
                _ => ([op.a; 2], 1),
            };
            let [y, z] = others.map(|other| behind(other, 1));
            behind(op.a, 1).max(behind(op.b, count)).max(y).max(z)
        });
        read.fold(behind(result, 1), usize::max)
    }
}

/// What an operator makes of two numbers.
pub(super) fn folded(code: &Code, a: f64, b: f64) -> Option<f64> {
    Some(match code {
        Code::Add => a + b,
        Code::Subtract => a - b,
        Code::Multiply => a * b,
        Code::Divide => a / b,
        Code::Unary(Unary::Square) => a * a,
        _ => return None,
    })
}
