//! Expressions as a list of simple operations on numbered registers.

use std::sync::Arc;

use smallvec::SmallVec;

use super::number::{Number, Unary};
use super::{Budget, Function, Internal};
use crate::math::color::{GREY, grey_of};
use crate::math::{Band, Lanes, Slant};

/// A register's number. Parameters come first, intermediate values next, constants last.
pub type Register = u16;

/// One operation: `to` takes what the code makes of `a` and `b`.
#[derive(Clone, Debug)]
pub struct Op {
    /// What to do.
    pub code: Code,
    /// The register that takes the result; for jumps the one that takes the chosen value.
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
    /// The sum with a number.
    Plus(f64),
    /// The product with a number.
    Times(f64),
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
    Power,
    Remainder,
    /// The quotient without its fraction.
    Quotient,
    Atan2,
    /// The next number of those that a sum runs over.
    Next,
    /// A function of `a`.
    Unary(Unary),
    /// An internal function of the point in `a` and these, with its parameters in the registers from `b` on.
    Internal(Internal, [Register; 2]),
    /// The component with this index, or their grey, of a function of the registers from `a` on.
    Call(Arc<Function>, u8),
    /// The tape itself, of the registers from `a` on.
    Recursion,
    /// Goes on with this operation.
    Jump(u32),
    /// Goes on with this operation if `a` is less than 0. Before it is the [`Code::Jump`] to the end of
    /// both ways, which put their value into `to`.
    IfNegative(u32),
    /// The same if `a` is 0.
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

/// A number that tapes can compute with.
pub(super) trait Operand: Number {
    /// A component of a function.
    fn call(function: &Function, arguments: &[Self], component: u8, budget: &Budget) -> Self;
    /// An internal function of a point and as many parameters as it has.
    fn internal(internal: &Internal, point: [Self; 3], parameters: &[Self]) -> Self;
    /// The value of a tape that calls itself.
    fn recursion(tape: &Tape, arguments: &[Self], budget: &Budget) -> Self;
    /// Runs a part of a tape out of line.
    fn aside<const SIZE: usize>(tape: &Tape, way: Way, r: &mut [Self; SIZE], budget: &Budget) -> bool;
}

/// A part of a tape: the first operation, and the one behind the last.
#[derive(Clone, Copy)]
pub(super) struct Way {
    from: usize,
    to: usize,
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
        self.evaluate(arguments, budget)
    }

    /// Four values at once; `None` where they take ways that are too different.
    #[inline(always)]
    pub fn run_four(&self, arguments: &[Lanes], budget: &Budget) -> Option<Lanes> {
        self.try_evaluate(arguments, budget)
    }

    /// What holds the values for all arguments that are held by these.
    #[inline(always)]
    pub fn enclose(&self, arguments: &[Band], budget: &Budget) -> Band {
        self.evaluate(arguments, budget)
    }

    /// The same with how fast they rise.
    pub fn slant(&self, arguments: &[Slant], budget: &Budget) -> Slant {
        self.evaluate(arguments, budget)
    }

    /// Whether [`Self::enclose`] knows all that is in it; of a tape that calls itself as far as what it chooses by is
    /// certain.
    pub fn is_known(&self) -> bool {
        self.ops.iter().all(|op| match &op.code {
            Code::Call(function, _) => function.is_known(),
            _ => true,
        })
    }

    /// Whether four values at once have the bits of one: there are no sines and cosines in it.
    pub(super) fn is_exact(&self) -> bool {
        self.ops.iter().all(|op| match &op.code {
            Code::Unary(Unary::Sin | Unary::Cos) => false,
            Code::Internal(internal, _) => internal.exact,
            _ => true,
        })
    }

    /// Whether anything in it is rounded to single precision.
    pub fn is_single(&self) -> bool {
        self.ops.iter().any(|op| matches!(&op.code, Code::Call(function, _) if function.single))
    }

    #[inline(always)]
    fn evaluate<N: Operand>(&self, arguments: &[N], budget: &Budget) -> N {
        self.try_evaluate(arguments, budget).unwrap_or_else(N::unknown)
    }

    /// The value, unless it couldn't be computed to its end.
    #[inline(always)]
    fn try_evaluate<N: Operand>(&self, arguments: &[N], budget: &Budget) -> Option<N> {
        let registers = self.first_constant + self.constants.len();
        if registers <= FEW / 4 {
            self.evaluate_in::<N, { FEW / 4 }>(arguments, budget)
        } else if registers <= FEW / 2 {
            self.evaluate_in::<N, { FEW / 2 }>(arguments, budget)
        } else if registers <= FEW {
            self.evaluate_in::<N, FEW>(arguments, budget)
        } else {
            self.evaluate_among_many(arguments, budget)
        }
    }

    #[inline(never)]
    fn evaluate_among_many<N: Operand>(&self, arguments: &[N], budget: &Budget) -> Option<N> {
        self.evaluate_in::<N, MANY>(arguments, budget)
    }

    #[inline(always)]
    fn evaluate_in<N: Operand, const SIZE: usize>(&self, arguments: &[N], budget: &Budget) -> Option<N> {
        let mut r = [N::constant(0.0); SIZE];
        // Counted: adapters of iterators are calls here.
        let given = &arguments[..arguments.len().min(self.parameters)];
        let mut at = 0;
        while let Some(argument) = given.get(at) {
            r[at & (SIZE - 1)] = *argument;
            at += 1;
        }
        at = 0;
        while let Some(constant) = self.constants.get(at) {
            r[(self.first_constant + at) & (SIZE - 1)] = N::constant(*constant);
            at += 1;
        }
        let whole = Way { from: 0, to: self.ops.len() };
        self.steps(whole, &mut r, budget).then(|| r[usize::from(self.result) & (SIZE - 1)])
    }

    /// Runs a part; whether it came to its end.
    #[inline(always)]
    pub(super) fn steps<N: Operand, const SIZE: usize>(
        &self,
        way: Way,
        r: &mut [N; SIZE],
        budget: &Budget,
    ) -> bool {
        // Registers are numbered within the size, a power of two: masking saves the check.
        let index = |register: Register| usize::from(register) & (SIZE - 1);
        let mut at = way.from;
        while let Some(op) = self.ops.get(at)
            && at < way.to
        {
            at += 1;
            let (a, b) = (&r[index(op.a)], &r[index(op.b)]);
            // Each writes its own result: a place that all wrote to first would be one more to wait for.
            macro_rules! put {
                ($value:expr) => {{
                    let value = $value;
                    r[index(op.to)] = value;
                }};
            }
            match &op.code {
                Code::Copy => put!(*a),
                Code::Add => put!(*a + *b),
                Code::Subtract => put!(*a - *b),
                Code::Multiply => put!(*a * *b),
                Code::Plus(number) => put!(*a + *number),
                Code::Times(number) => put!(*a * *number),
                Code::Divide => put!(*a / *b),
                Code::Less => put!(a.less(*b)),
                Code::LessEqual => put!(a.less_equal(*b)),
                Code::Greater => put!(a.less_equal(*b).not()),
                Code::GreaterEqual => put!(a.less(*b).not()),
                Code::Equal => put!(a.equal(*b)),
                Code::NotEqual => put!(a.equal(*b).not()),
                Code::And => put!(a.and(*b)),
                Code::Or => put!(a.not().and(b.not()).not()),
                Code::Min => put!(a.lower(*b)),
                Code::Max => put!(a.upper(*b)),
                Code::Negate => put!(-*a),
                Code::Power => put!(a.powf(*b)),
                Code::Remainder => put!(a.rem(*b)),
                Code::Quotient => put!(a.quotient(*b)),
                Code::Atan2 => put!(a.atan2(*b)),
                Code::Next => put!(a.fixed().map_or_else(N::unknown, |v| N::constant(v + 1.0))),
                Code::Unary(function) => put!(a.unary(*function)),
                Code::Internal(internal, [y, z]) => {
                    let parameters = &r[index(op.b)..][..internal.parameters - 3];
                    put!(N::internal(internal, [*a, r[index(*y)], r[index(*z)]], parameters));
                }
                Code::Call(function, component) => {
                    if !budget.spend() {
                        return false;
                    }
                    let arguments = &r[index(op.a)..][..function.parameters];
                    put!(N::call(function, arguments, *component, budget));
                }
                Code::Recursion => put!(N::recursion(self, &r[index(op.a)..][..self.parameters], budget)),
                Code::Jump(target) => {
                    at = *target as usize;
                    continue;
                }
                Code::IfNegative(target) | Code::IfZero(target) => {
                    let condition = *a;
                    let is_sign = matches!(op.code, Code::IfNegative(_));
                    let holds = if is_sign { condition.is_negative() } else { condition.is_zero() };
                    let target = *target as usize;
                    match holds {
                        Some(true) => at = target,
                        Some(false) => {}
                        None => {
                            let Some(Code::Jump(end)) =
                                self.ops.get(target.wrapping_sub(1)).map(|op| &op.code)
                            else {
                                return false;
                            };
                            let (end, to) = (*end as usize, index(op.to));
                            if !N::aside(self, Way { from: at, to: end }, r, budget) {
                                return false;
                            }
                            let other = r[to];
                            if !N::aside(self, Way { from: target, to: end }, r, budget) {
                                return false;
                            }
                            let held = r[to];
                            r[to] = if is_sign {
                                condition.choose(held, other)
                            } else {
                                condition.either(held, other)
                            };
                            at = end;
                        }
                    }
                    continue;
                }
                Code::IfUpTo(target) => {
                    let (Some(from), Some(to)) = (a.fixed(), b.fixed()) else {
                        return false;
                    };
                    if from <= to {
                        if !budget.spend() {
                            return false;
                        }
                        at = *target as usize;
                    }
                    continue;
                }
            }
        }
        true
    }
}

impl Operand for f64 {
    fn call(function: &Function, arguments: &[Self], component: u8, budget: &Budget) -> Self {
        let mut value = [0.0; 5];
        function.call_within(arguments, &mut value, budget);
        if component == GREY {
            return grey_of([value[0], value[1], value[2]]);
        }
        value.get(usize::from(component)).copied().unwrap_or(0.0)
    }

    #[inline(always)]
    fn internal(internal: &Internal, point: [Self; 3], parameters: &[Self]) -> Self {
        internal.number(point, parameters)
    }

    fn recursion(tape: &Tape, arguments: &[Self], budget: &Budget) -> Self {
        budget.deeper(|| tape.run(arguments, budget))
    }

    #[inline(always)]
    fn aside<const SIZE: usize>(_: &Tape, _: Way, _: &mut [Self; SIZE], _: &Budget) -> bool {
        // Whether a number is negative or 0 is always known.
        false
    }
}

impl Operand for Lanes {
    fn call(function: &Function, arguments: &[Self], component: u8, budget: &Budget) -> Self {
        function.four_of_points(arguments, component).unwrap_or_else(|| {
            one_by_one(arguments, |arguments| f64::call(function, arguments, component, budget))
        })
    }

    #[inline(always)]
    fn internal(internal: &Internal, point: [Self; 3], parameters: &[Self]) -> Self {
        internal.four(point, parameters)
    }

    fn recursion(tape: &Tape, arguments: &[Self], budget: &Budget) -> Self {
        one_by_one(arguments, |arguments| f64::recursion(tape, arguments, budget))
    }

    fn aside<const SIZE: usize>(tape: &Tape, way: Way, r: &mut [Self; SIZE], budget: &Budget) -> bool {
        tape.steps(way, r, budget)
    }
}

/// A function of the arguments in each lane.
fn one_by_one(arguments: &[Lanes], call: impl Fn(&[f64]) -> f64) -> Lanes {
    Lanes([0, 1, 2, 3].map(|i| {
        let one: SmallVec<[f64; 16]> = arguments.iter().map(|argument| argument.0[i]).collect();
        call(&one)
    }))
}

impl Operand for Band {
    fn call(function: &Function, arguments: &[Self], component: u8, budget: &Budget) -> Self {
        function.enclose_within(arguments, component, budget)
    }

    #[inline(always)]
    fn internal(internal: &Internal, point: [Self; 3], parameters: &[Self]) -> Self {
        internal.band(point, parameters)
    }

    /// Where no choice tells when to end, nothing is known.
    fn recursion(tape: &Tape, arguments: &[Self], budget: &Budget) -> Self {
        let settled: SmallVec<[Self; 8]> = arguments.iter().map(|argument| argument.settled()).collect();
        budget.a_little_deeper(|| tape.enclose(&settled, budget)).unwrap_or(Self::UNKNOWN)
    }

    fn aside<const SIZE: usize>(tape: &Tape, way: Way, r: &mut [Self; SIZE], budget: &Budget) -> bool {
        tape.steps(way, r, budget)
    }
}

impl Operand for Slant {
    fn call(function: &Function, arguments: &[Self], component: u8, budget: &Budget) -> Self {
        function.slant_within(arguments, component, budget)
    }

    fn internal(internal: &Internal, point: [Self; 3], parameters: &[Self]) -> Self {
        internal.slanted(point, parameters)
    }

    fn recursion(tape: &Tape, arguments: &[Self], budget: &Budget) -> Self {
        let settled = |argument: &Self| Self { value: argument.value.settled(), ..*argument };
        let settled: SmallVec<[Self; 8]> = arguments.iter().map(settled).collect();
        budget.a_little_deeper(|| tape.slant(&settled, budget)).unwrap_or(Self::UNKNOWN)
    }

    fn aside<const SIZE: usize>(tape: &Tape, way: Way, r: &mut [Self; SIZE], budget: &Budget) -> bool {
        tape.steps(way, r, budget)
    }
}
