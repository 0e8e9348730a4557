//! User-defined functions as expression trees (docs/spec/language.md 4).

use std::sync::Arc;

use super::depth::Nested;
use super::pigment::Pigment;
use super::{Field, Spline};
use crate::math::Transform;
use crate::source::Span;

/// `function(…) { … }`.
#[derive(Clone, Debug)]
pub struct Function {
    /// Where the statement stands.
    pub span: Span,
    /// Name it was declared under, for messages; empty where it has none.
    pub name: Arc<str>,
    /// Number of parameters; `x, y, z` where none were written.
    pub parameters: usize,
    /// What it computes.
    pub body: Nested<FunctionBody>,
}

/// What a [`Function`] computes.
#[derive(Clone, Debug)]
pub enum FunctionBody {
    /// A number from numbers.
    Expression(Expr),
    /// `internal(n)`: number in the table of docs/spec/language.md 4.5.
    Internal(u8),
    /// `pattern { … }`: a number from a point.
    Pattern(Arc<Field>),
    /// `pigment { … }`: five components from a point.
    Pigment(Arc<Pigment>),
    /// `transform { … }`: a point from a point.
    Transform(Arc<Transform>),
    /// `spline { … }`: components from a number.
    Spline(Arc<Spline>),
}

/// An expression of a function's body. Identifiers are resolved, constants folded.
#[derive(Clone, Debug)]
pub enum Expr {
    /// A number.
    Constant(f64),
    /// A parameter, by position.
    Parameter(u16),
    /// The running variable of the n-th enclosing `sum` or `prod`, counted from the outermost.
    Running(u16),
    /// `-e`.
    Negate(Box<Expr>),
    /// `a op b`.
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// A built-in, with as many arguments as it takes.
    Call(Builtin, Vec<Expr>),
    /// A power 2 … 8 as a product.
    Power(Box<Expr>, u8),
    /// The function itself, with other arguments.
    Recursion(Vec<Expr>),
    /// A user function that gives a number.
    User(Arc<Function>, Vec<Expr>),
    /// `.x`, `.red` … of a user function that gives several components, or their [`GREY`](crate::math::color::GREY).
    Component(Arc<Function>, Vec<Expr>, u8),
    /// `sum(i, from, to, e)`.
    Sum(Box<[Expr; 3]>),
    /// `prod(i, from, to, e)`.
    Product(Box<[Expr; 3]>),
}

/// Operators between two numbers; comparisons and logic give 1 or 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the operators' usual names")]
pub enum BinaryOp {
    Add,
    Subtract,
    Multiply,
    Divide,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
    And,
    Or,
}

/// Functions a body may call (docs/spec/language.md 4.2).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[expect(missing_docs, reason = "the language's own words")]
pub enum Builtin {
    Abs,
    Acos,
    Acosh,
    Asin,
    Asinh,
    Atan,
    Atan2,
    Atanh,
    Ceil,
    Cos,
    Cosh,
    Degrees,
    Div,
    Exp,
    Floor,
    Int,
    Ln,
    Log,
    /// Two or more arguments.
    Max,
    /// Two or more arguments.
    Min,
    Mod,
    Pow,
    Radians,
    /// Three or four arguments.
    Select,
    Sin,
    Sinh,
    Sqrt,
    Tan,
    Tanh,
}
