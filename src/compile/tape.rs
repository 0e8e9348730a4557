//! Writes the tapes of expressions (docs/spec/language.md 4.2).

mod constants;

use std::sync::Arc;

use self::constants::folded;
use super::Unsupported;
use super::texture::TextureCompiler;
use crate::scene;
use crate::scene::function::{BinaryOp, Builtin, Expr, FunctionBody};
use crate::world::function::tape::{Code, Op, Register};
use crate::world::function::{Body, Internal, Tape, Unary};

/// How deep an expression may go; chains of operators are not deep.
const DEEPEST: u32 = 500;

/// Functions of at most so many parts are written out where they are called, unless the tape is already as long
/// as `LONG`, or has `MOST_IN_USE` registers in use.
const SHORT: u32 = 100;
const LONG: usize = 1000;
const MOST_IN_USE: usize = 64;

/// Marks the number of a constant until it is known which registers are left for constants.
const CONSTANT: Register = 1 << 15;

/// Writes one tape. A value goes to the lowest free register, so registers serve as a stack.
pub(super) struct Writer<'w, 'a> {
    compiler: &'w mut TextureCompiler<'a>,
    function: &'w scene::Function,
    constants: Vec<f64>,
    ops: Vec<Op>,
    /// Registers in use, parameters included, and the most there ever were.
    used: usize,
    most: usize,
    /// The running variables of the enclosing sums and products, the outermost first.
    running: Vec<Register>,
    /// Where the arguments are of the function whose expression is being written out instead of called.
    written_out: Option<Vec<Register>>,
    depth: u32,
    /// How many functions deep the tape calls.
    calls: u32,
}

impl<'w, 'a> Writer<'w, 'a> {
    pub(super) fn new(compiler: &'w mut TextureCompiler<'a>, function: &'w scene::Function) -> Self {
        Self {
            compiler,
            function,
            constants: Vec::new(),
            ops: Vec::new(),
            used: function.parameters,
            most: function.parameters,
            running: Vec::new(),
            written_out: None,
            depth: 0,
            calls: 1,
        }
    }

    /// The tape of the whole expression, and how many functions deep it calls.
    pub(super) fn tape(mut self, expression: &Expr) -> Result<(Tape, u32), Unsupported> {
        let result = self.value(expression)?;
        self.constants.truncate(self.constants_read(result));
        let first = self.most;
        let settle = |register: Register| match register & CONSTANT {
            0 => register,
            _ => (first + usize::from(register & !CONSTANT)) as Register,
        };
        for op in &mut self.ops {
            (op.to, op.a, op.b) = (settle(op.to), settle(op.a), settle(op.b));
            if let Code::Internal(_, others) = &mut op.code {
                *others = others.map(settle);
            }
        }
        let tape = Tape::new(self.function.parameters, first, self.constants, self.ops, settle(result));
        let tape = tape.ok_or_else(|| too_big(self.function))?;
        Ok((tape, self.calls))
    }

    /// Writes what computes an expression and says where its value will be: where it is already, or in
    /// the lowest register that was free before.
    fn value(&mut self, expression: &Expr) -> Result<Register, Unsupported> {
        if self.depth >= DEEPEST {
            let feature = format!("an expression nested more than {DEEPEST} deep");
            return Err(Unsupported::new(self.function.span, feature));
        }
        self.depth += 1;
        let register = match expression {
            Expr::Constant(value) => self.constant(*value),
            Expr::Parameter(index) => Ok(self.parameter(*index)),
            Expr::Running(index) => self.running_variable(*index),
            Expr::Negate(e) => {
                let mark = self.used;
                let a = self.value(e)?;
                match self.known(a) {
                    Some(value) => self.constant(-value),
                    None => self.result(mark, Code::Negate, a, a),
                }
            }
            Expr::Binary(..) => self.chain(expression),
            Expr::Call(Builtin::Select, arguments) => self.select(arguments),
            Expr::Call(builtin, arguments) => self.builtin(*builtin, arguments),
            Expr::Power(base, exponent) => {
                let mark = self.used;
                let base = self.value(base)?;
                self.result(mark, Code::Unary(product(*exponent)), base, base)
            }
            Expr::Recursion(arguments) => {
                let mark = self.arguments(arguments)?;
                self.result(mark, Code::Recursion, mark as Register, mark as Register)
            }
            Expr::User(function, arguments) => self.call(function, arguments, 0),
            Expr::Component(function, arguments, component) => self.call(function, arguments, *component),
            Expr::Sum(parts) => self.repeat(parts, 0.0, Code::Add),
            Expr::Product(parts) => self.repeat(parts, 1.0, Code::Multiply),
        };
        self.depth -= 1;
        register
    }

    fn parameter(&self, index: u16) -> Register {
        self.written_out.as_ref().map_or(index, |arguments| arguments[usize::from(index)])
    }

    fn running_variable(&self, index: u16) -> Result<Register, Unsupported> {
        let register = self.running.get(usize::from(index)).copied();
        register
            .ok_or_else(|| Unsupported::broken(self.function.span, "a running variable outside of its sum"))
    }

    /// The lowest free register.
    fn take(&mut self) -> Result<Register, Unsupported> {
        if self.used >= Tape::MOST_REGISTERS {
            return Err(too_big(self.function));
        }
        self.used += 1;
        self.most = self.most.max(self.used);
        Ok((self.used - 1) as Register)
    }

    fn emit(&mut self, code: Code, to: Register, a: Register, b: Register) {
        self.ops.push(Op { code, to, a, b });
    }

    /// Frees the registers from `mark` on and writes an operation with its result there.
    fn result(&mut self, mark: usize, code: Code, a: Register, b: Register) -> Result<Register, Unsupported> {
        self.used = mark;
        let to = self.take()?;
        self.emit(code, to, a, b);
        Ok(to)
    }

    /// The value of an expression in the lowest free register, which stays in use.
    fn value_on_top(&mut self, expression: &Expr) -> Result<Register, Unsupported> {
        let mark = self.used;
        let value = self.value(expression)?;
        if usize::from(value) == mark {
            return Ok(value);
        }
        self.result(mark, Code::Copy, value, value)
    }

    /// A chain of operators, however long: `a + b + c …` is nested on its left only.
    fn chain(&mut self, expression: &Expr) -> Result<Register, Unsupported> {
        let mut links = Vec::new();
        let mut first = expression;
        while let Expr::Binary(op, left, right) = first {
            links.push((*op, &**right));
            first = left;
        }
        let mark = self.used;
        let mut sum = self.value(first)?;
        for (op, right) in links.into_iter().rev() {
            let right = self.value(right)?;
            let (code, a, b) = match op {
                BinaryOp::Add => (Code::Add, sum, right),
                BinaryOp::Subtract => (Code::Subtract, sum, right),
                BinaryOp::Multiply if sum == right => (Code::Unary(Unary::Square), sum, right),
                BinaryOp::Multiply => (Code::Multiply, sum, right),
                BinaryOp::Divide => (Code::Divide, sum, right),
                BinaryOp::Less => (Code::Less, sum, right),
                BinaryOp::LessEqual => (Code::LessEqual, sum, right),
                BinaryOp::Greater => (Code::Greater, sum, right),
                BinaryOp::GreaterEqual => (Code::GreaterEqual, sum, right),
                BinaryOp::Equal => (Code::Equal, sum, right),
                BinaryOp::NotEqual => (Code::NotEqual, sum, right),
                BinaryOp::And => (Code::And, sum, right),
                BinaryOp::Or => (Code::Or, sum, right),
            };
            sum = match self.known(a).zip(self.known(b)).and_then(|(a, b)| folded(&code, a, b)) {
                Some(value) => {
                    self.used = mark;
                    self.constant(value)?
                }
                None => match self.with_number(&code, a, b) {
                    Some((code, other)) => self.result(mark, code, other, other)?,
                    None => self.result(mark, code, a, b)?,
                },
            };
        }
        Ok(sum)
    }

    fn builtin(&mut self, builtin: Builtin, arguments: &[Expr]) -> Result<Register, Unsupported> {
        let mark = self.used;
        let Some((first, rest)) = arguments.split_first() else {
            return Err(Unsupported::broken(self.function.span, "a function call without arguments"));
        };
        let mut value = self.value(first)?;
        let exact = self.compiler.last_digits;
        if let (Builtin::Pow, [Expr::Constant(exponent)]) = (builtin, rest)
            && let Some(power) = (2..=8).find(|power| !exact && f64::from(*power) == *exponent)
        {
            return self.result(mark, Code::Unary(product(power)), value, value);
        }
        if rest.is_empty() {
            return self.result(mark, one_argument(builtin), value, value);
        }
        for argument in rest {
            let next = self.value(argument)?;
            value = self.result(mark, two_arguments(builtin), value, next)?;
        }
        Ok(value)
    }

    /// `select`: only the branch that is taken is computed.
    fn select(&mut self, arguments: &[Expr]) -> Result<Register, Unsupported> {
        let mark = self.used;
        let (condition, negative, zero, positive) = match arguments {
            [condition, negative, other] => (condition, negative, None, other),
            [condition, negative, zero, positive] => (condition, negative, Some(zero), positive),
            _ => {
                return Err(Unsupported::broken(
                    self.function.span,
                    "`select` takes three or four arguments",
                ));
            }
        };
        let condition = self.value(condition)?;
        self.used = mark;
        let to = self.take()?;
        let to_negative = self.jump(Code::IfNegative(0), to, condition);
        let to_zero = zero.map(|_| self.jump(Code::IfZero(0), to, condition));
        self.branch(positive, to)?;
        let mut to_end = vec![self.jump(Code::Jump(0), to, to)];
        if let (Some(jump), Some(zero)) = (to_zero, zero) {
            self.land(jump);
            self.branch(zero, to)?;
            to_end.push(self.jump(Code::Jump(0), to, to));
        }
        self.land(to_negative);
        self.branch(negative, to)?;
        for jump in to_end {
            self.land(jump);
        }
        Ok(to)
    }

    /// Writes a jump whose target is not known yet, and says where it is.
    fn jump(&mut self, code: Code, to: Register, a: Register) -> usize {
        self.emit(code, to, a, a);
        self.ops.len() - 1
    }

    /// Makes a jump go to what is written next.
    fn land(&mut self, jump: usize) {
        let next = self.ops.len() as u32;
        match &mut self.ops[jump].code {
            Code::Jump(target) | Code::IfNegative(target) | Code::IfZero(target) | Code::IfUpTo(target) => {
                *target = next;
            }
            _ => {}
        }
    }

    /// Writes what puts the value of an expression into a register.
    fn branch(&mut self, expression: &Expr, to: Register) -> Result<(), Unsupported> {
        let mark = self.used;
        let value = self.value(expression)?;
        self.used = mark;
        self.emit(Code::Copy, to, value, value);
        Ok(())
    }

    fn call(
        &mut self,
        function: &Arc<scene::Function>,
        arguments: &[Expr],
        component: u8,
    ) -> Result<Register, Unsupported> {
        let compiled = self.compiler.function(function)?;
        if arguments.len() != compiled.parameters {
            return Err(Unsupported::broken(
                self.function.span,
                "a function call with too few or too many arguments",
            ));
        }
        self.calls = self.calls.max(compiled.depth + 1);
        if let FunctionBody::Expression(body) = &*function.body
            && self.depth + SHORT < DEEPEST
            && self.ops.len() < LONG
            && self.used < MOST_IN_USE
            && is_short(body, &mut { SHORT })
        {
            return self.write_out(body, arguments);
        }
        if let (Body::Internal(internal), [x, y, z, parameters @ ..]) = (&compiled.body, arguments) {
            return self.internal(*internal, [x, y, z], parameters);
        }
        let mark = self.arguments(arguments)?;
        self.result(mark, Code::Call(compiled, component), mark as Register, mark as Register)
    }

    fn internal(
        &mut self,
        internal: Internal,
        [x, y, z]: [&Expr; 3],
        parameters: &[Expr],
    ) -> Result<Register, Unsupported> {
        let mark = self.used;
        let (x, y, z) = (self.value(x)?, self.value(y)?, self.value(z)?);
        let first = match parameters.iter().map(number).collect::<Option<Vec<_>>>() {
            Some(numbers) => self.run_of_constants(&numbers)?,
            None => self.arguments(parameters)? as Register,
        };
        self.result(mark, Code::Internal(internal, [y, z]), x, first)
    }

    /// Writes the expression of a function instead of a call.
    fn write_out(&mut self, body: &Expr, arguments: &[Expr]) -> Result<Register, Unsupported> {
        let mark = self.used;
        let places = arguments.iter().map(|argument| self.value(argument)).collect::<Result<_, _>>()?;
        let outer = (self.written_out.replace(places), std::mem::take(&mut self.running));
        let value = self.value(body);
        (self.written_out, self.running) = outer;
        let value = value?;
        self.used = mark;
        if value & CONSTANT != 0 || usize::from(value) < mark {
            return Ok(value);
        }
        let to = self.take()?;
        if to != value {
            self.emit(Code::Copy, to, value, value);
        }
        Ok(to)
    }

    /// Writes what puts arguments into the lowest free registers, and says which is the first.
    fn arguments(&mut self, arguments: &[Expr]) -> Result<usize, Unsupported> {
        let mark = self.used;
        for argument in arguments {
            self.value_on_top(argument)?;
        }
        Ok(mark)
    }

    /// `sum` and `prod`: the running variable from the first to the second part, both included.
    fn repeat(&mut self, parts: &[Expr; 3], start: f64, code: Code) -> Result<Register, Unsupported> {
        let [from, to, body] = parts;
        let start = self.constant(start)?;
        let total = self.take()?;
        let variable = self.value_on_top(from)?;
        let end = self.value_on_top(to)?;
        self.emit(Code::Copy, total, start, start);
        let to_test = self.jump(Code::Jump(0), total, total);
        let top = self.ops.len() as u32;
        self.running.push(variable);
        let mark = self.used;
        let term = self.value(body)?;
        self.used = mark;
        self.running.pop();
        self.emit(code, total, total, term);
        self.emit(Code::Next, variable, variable, variable);
        self.land(to_test);
        self.emit(Code::IfUpTo(top), variable, variable, end);
        self.used = usize::from(total) + 1;
        Ok(total)
    }
}

/// Takes a node of an expression for each step; whether they last, and the function doesn't call itself.
fn is_short(expression: &Expr, steps: &mut u32) -> bool {
    if *steps == 0 {
        return false;
    }
    *steps -= 1;
    let mut all = |parts: &[Expr]| parts.iter().all(|part| is_short(part, steps));
    match expression {
        Expr::Constant(_) | Expr::Parameter(_) | Expr::Running(_) => true,
        Expr::Negate(e) | Expr::Power(e, _) => is_short(e, steps),
        Expr::Binary(_, a, b) => is_short(a, steps) && is_short(b, steps),
        Expr::Call(_, arguments) | Expr::User(_, arguments) | Expr::Component(_, arguments, _) => {
            all(arguments)
        }
        Expr::Sum(parts) | Expr::Product(parts) => all(&**parts),
        Expr::Recursion(_) => false,
    }
}

/// The number that an expression is.
fn number(expression: &Expr) -> Option<f64> {
    match expression {
        Expr::Constant(value) => Some(*value),
        Expr::Negate(e) => number(e).map(|value| -value),
        _ => None,
    }
}

fn too_big(function: &scene::Function) -> Unsupported {
    let feature = format!("a function with more than {} numbers in flight", Tape::MOST_REGISTERS);
    Unsupported::new(function.span, feature)
}

/// A power 2 … 8 as a product.
fn product(exponent: u8) -> Unary {
    if exponent == 2 { Unary::Square } else { Unary::Power(exponent) }
}

fn one_argument(builtin: Builtin) -> Code {
    Code::Unary(match builtin {
        Builtin::Abs => Unary::Abs,
        Builtin::Acos => Unary::Acos,
        Builtin::Acosh => Unary::Acosh,
        Builtin::Asin => Unary::Asin,
        Builtin::Asinh => Unary::Asinh,
        Builtin::Atan => Unary::Atan,
        Builtin::Atanh => Unary::Atanh,
        Builtin::Ceil => Unary::Ceil,
        Builtin::Cos => Unary::Cos,
        Builtin::Cosh => Unary::Cosh,
        Builtin::Degrees => Unary::Degrees,
        Builtin::Exp => Unary::Exp,
        Builtin::Floor => Unary::Floor,
        Builtin::Int => Unary::Int,
        Builtin::Ln => Unary::Ln,
        Builtin::Log => Unary::Log,
        Builtin::Radians => Unary::Radians,
        Builtin::Sin => Unary::Sin,
        Builtin::Sinh => Unary::Sinh,
        Builtin::Sqrt => Unary::Sqrt,
        Builtin::Tan => Unary::Tan,
        Builtin::Tanh => Unary::Tanh,
        // These take more; with one argument they are that argument.
        Builtin::Atan2
        | Builtin::Div
        | Builtin::Max
        | Builtin::Min
        | Builtin::Mod
        | Builtin::Pow
        | Builtin::Select => return Code::Copy,
    })
}

fn two_arguments(builtin: Builtin) -> Code {
    match builtin {
        Builtin::Max => Code::Max,
        Builtin::Min => Code::Min,
        Builtin::Div => Code::Quotient,
        Builtin::Mod => Code::Remainder,
        Builtin::Atan2 => Code::Atan2,
        _ => Code::Power,
    }
}
