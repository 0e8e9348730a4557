//! Functions, as expressions.

use super::block::Block;
use super::value::{number, transform, vector};
use super::{pattern, texture};
use crate::math::color::GREY;
use crate::scene::Function;
use crate::scene::function::{BinaryOp, Expr, FunctionBody};
use crate::scene::spline::{Spline, SplineKind};

pub(super) fn dump(function: &Function) -> Block {
    let head = format!("function({})", function.parameters);
    let block = Block::new(head);
    match &*function.body {
        FunctionBody::Expression(e) => block.line(expression(e)),
        FunctionBody::Internal(index) => block.line(format!("internal({index})")),
        FunctionBody::Pattern(field) => block.block(Block::new("pattern").extend(pattern::dump(field))),
        FunctionBody::Pigment(inner) => block.block(texture::pigment("pigment", inner)),
        FunctionBody::Transform(by) => block.line(transform(by)),
        FunctionBody::Spline(inner) => block.block(spline(inner)),
    }
}

fn spline(spline: &Spline) -> Block {
    let kind = match spline.kind {
        SplineKind::Linear => "linear_spline",
        SplineKind::Quadratic => "quadratic_spline",
        SplineKind::Cubic => "cubic_spline",
        SplineKind::Natural => "natural_spline",
    };
    let start = Block::new("spline").line(kind);
    spline.points.iter().fold(start, |block, (key, value)| {
        block.line(format!("{}, {}", number(*key), vector(&value[..spline.size.min(5)])))
    })
}

/// An expression; parameters are `p0, p1 …`, running variables `i0, i1 …`. Parentheses stand around
/// every operation inside another.
fn expression(e: &Expr) -> String {
    match e {
        Expr::Binary(op, a, b) => format!("{} {} {}", operand(a), operator(*op), operand(b)),
        other => operand(other),
    }
}

fn operand(e: &Expr) -> String {
    match e {
        Expr::Constant(value) => number(*value),
        Expr::Parameter(index) => format!("p{index}"),
        Expr::Running(index) => format!("i{index}"),
        Expr::Negate(inner) => format!("-{}", operand(inner)),
        Expr::Binary(..) => format!("({})", expression(e)),
        Expr::Call(builtin, arguments) => {
            format!("{}({})", format!("{builtin:?}").to_lowercase(), list(arguments))
        }
        Expr::Power(base, exponent) => format!("pow({}, {exponent})", expression(base)),
        Expr::Recursion(arguments) => format!("self({})", list(arguments)),
        Expr::User(function, arguments) => format!("{}({})", name(function), list(arguments)),
        Expr::Component(function, arguments, GREY) => {
            format!("{}({}).gray", name(function), list(arguments))
        }
        Expr::Component(function, arguments, index) => {
            format!("{}({}).{index}", name(function), list(arguments))
        }
        Expr::Sum(parts) => format!("sum({})", list(&parts[..])),
        Expr::Product(parts) => format!("prod({})", list(&parts[..])),
    }
}

fn name(function: &Function) -> &str {
    if function.name.is_empty() { "function" } else { &function.name }
}

fn list(arguments: &[Expr]) -> String {
    arguments.iter().map(expression).collect::<Vec<_>>().join(", ")
}

fn operator(op: BinaryOp) -> &'static str {
    match op {
        BinaryOp::Add => "+",
        BinaryOp::Subtract => "-",
        BinaryOp::Multiply => "*",
        BinaryOp::Divide => "/",
        BinaryOp::Less => "<",
        BinaryOp::LessEqual => "<=",
        BinaryOp::Greater => ">",
        BinaryOp::GreaterEqual => ">=",
        BinaryOp::Equal => "=",
        BinaryOp::NotEqual => "!=",
        BinaryOp::And => "&",
        BinaryOp::Or => "|",
    }
}
