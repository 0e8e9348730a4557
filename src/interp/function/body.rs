//! Reads the expression in the body of a function, docs/spec/language.md 4.2.

use super::table::builtin;
use super::{Variable, axis};
use crate::interp::limits::MOST_TERMS;
use crate::interp::stream::{Token, TokenKind};
use crate::interp::value::Value;
use crate::interp::{Fault, Result, Vm, Word};
use crate::math::color::GREY;
use crate::scene::Function;
use crate::scene::function::{BinaryOp, Builtin, Expr, FunctionBody};
use crate::source::Span;
use crate::syntax::{Punct, Symbol};
use std::sync::Arc;

/// What is known while the body of a function is read.
pub(super) struct Body {
    /// The name it is declared under.
    pub(super) name: Option<Symbol>,
    pub(super) parameters: Vec<Variable>,
    /// The names `sum` and `prod` count with, outermost first.
    pub(super) running: Vec<Symbol>,
    /// Whether POV-Ray puts numbers together here: everywhere but in the second and further
    /// arguments of calls (docs/spec/language.md 4.2).
    pub(super) folds: bool,
}

/// What stands between the parentheses of a call.
struct Arguments {
    arguments: Vec<Expr>,
    /// One of them depends on a parameter.
    varies: bool,
    /// Whether the first is a number that was not in parentheses.
    plain_first: bool,
    /// The last, if it is such a number.
    plain: Option<f64>,
}

/// An operand: its tree, and what POV-Ray's way of folding constants asks about it.
pub(super) struct Operand {
    pub(super) expr: Expr,
    /// A number that was not in parentheses.
    plain: bool,
    /// Several numbers that were put together.
    combined: bool,
    /// Depends on a parameter.
    varies: bool,
}

impl Operand {
    /// A number as it stands in the text.
    fn number(value: f64) -> Self {
        Self { expr: Expr::Constant(value), plain: true, combined: false, varies: false }
    }

    /// Anything else.
    fn other(expr: Expr, varies: bool) -> Self {
        Self { expr, plain: false, combined: false, varies }
    }
}

/// The binary operators from the loosest to the tightest.
fn operator(level: usize, punct: Punct) -> Option<BinaryOp> {
    Some(match (level, punct) {
        (0, Punct::Or) => BinaryOp::Or,
        (1, Punct::And) => BinaryOp::And,
        (2, Punct::Equal) => BinaryOp::Equal,
        (2, Punct::NotEqual) => BinaryOp::NotEqual,
        (2, Punct::Less) => BinaryOp::Less,
        (2, Punct::LessEqual) => BinaryOp::LessEqual,
        (2, Punct::Greater) => BinaryOp::Greater,
        (2, Punct::GreaterEqual) => BinaryOp::GreaterEqual,
        (3, Punct::Plus) => BinaryOp::Add,
        (3, Punct::Minus) => BinaryOp::Subtract,
        (4, Punct::Star) => BinaryOp::Multiply,
        (4, Punct::Slash) => BinaryOp::Divide,
        _ => return None,
    })
}

fn division_by_zero(vm: &Vm, sign: Span) -> Fault {
    vm.error(sign.to(vm.last), "division by zero in a function")
}

const COMPARISONS: usize = 2;
const TIGHTEST: usize = 5;

/// What an operator gives for two numbers: comparisons are exact here, and false for what is no number.
fn compute(op: BinaryOp, a: f64, b: f64) -> f64 {
    let number = |holds: bool| f64::from(u8::from(holds));
    match op {
        BinaryOp::Add => a + b,
        BinaryOp::Subtract => a - b,
        BinaryOp::Multiply => a * b,
        BinaryOp::Divide => a / b,
        BinaryOp::Less => number(a < b),
        BinaryOp::LessEqual => number(a <= b),
        BinaryOp::Greater => number(a > b),
        BinaryOp::GreaterEqual => number(a >= b),
        BinaryOp::Equal => number(a == b),
        BinaryOp::NotEqual => number(a != b),
        BinaryOp::And => number(a != 0.0 && b != 0.0),
        BinaryOp::Or => number(a != 0.0 || b != 0.0),
    }
}

impl Body {
    /// Reads operands of a level and the operators between them.
    ///
    /// Neighbouring numbers are combined from the left as POV-Ray does it, which ignores the
    /// operator before them: `(12)/2*3` is 12/6 (docs/spec/language.md 4.2).
    pub(super) fn expression(&mut self, vm: &mut Vm, level: usize) -> Result<Operand> {
        if level == TIGHTEST {
            return self.unary(vm);
        }
        let mut operands = vec![self.expression(vm, level + 1)?];
        let mut operators = Vec::new();
        let mut varies = operands[0].varies;
        while let Some(mut op) = self.operator_at(vm, level)? {
            let sign = vm.next()?.span;
            let mut right = self.expression(vm, level + 1)?;
            varies |= right.varies;
            if let (BinaryOp::Subtract, true, Expr::Constant(c)) =
                (op, right.plain && !right.combined, &mut right.expr)
            {
                (*c, op) = (-*c, BinaryOp::Add);
            }
            let folds = self.folds && right.plain && (level != 4 || !varies);
            let left = operands.last_mut().filter(|left| folds && left.plain);
            if let (Some(left), Expr::Constant(b)) = (left, &right.expr)
                && let Expr::Constant(a) = left.expr
            {
                let value = compute(op, a, *b);
                left.expr = Expr::Constant(value);
                left.combined = true;
                if let (Some(BinaryOp::Divide), 0.0) = (operators.last(), value) {
                    return Err(division_by_zero(vm, sign));
                }
                continue;
            }
            if let (BinaryOp::Divide, Expr::Constant(0.0), true) = (op, &right.expr, right.plain) {
                return Err(division_by_zero(vm, sign));
            }
            operators.push(op);
            operands.push(right);
        }
        let mut operands = operands.into_iter();
        let Some(first) = operands.next() else { return Err(Fault::reported()) };
        if operators.is_empty() {
            return Ok(first);
        }
        let expr = operators
            .into_iter()
            .zip(operands)
            .fold(first.expr, |left, (op, right)| binary(op, left, right.expr, right.plain));
        Ok(Operand::other(expr, varies))
    }

    fn operator_at(&mut self, vm: &mut Vm, level: usize) -> Result<Option<BinaryOp>> {
        let token = vm.peek()?;
        Ok(match token.kind {
            TokenKind::Punct(punct) => operator(level, punct),
            TokenKind::Vector(..) if level == COMPARISONS => {
                vm.split_vector(token.span);
                Some(BinaryOp::Less)
            }
            _ => None,
        })
    }

    fn unary(&mut self, vm: &mut Vm) -> Result<Operand> {
        let token = vm.peek()?;
        match token.kind {
            TokenKind::Punct(Punct::Minus) => {
                vm.take(token);
                let Operand { expr, plain, varies, .. } = self.operand(vm)?;
                let expr = match expr {
                    Expr::Constant(c) => Expr::Constant(-c),
                    expr => Expr::Negate(Box::new(expr)),
                };
                Ok(Operand { expr, plain: plain && self.folds, combined: false, varies })
            }
            TokenKind::Punct(Punct::Plus) => {
                vm.take(token);
                self.operand(vm)
            }
            _ => self.operand(vm),
        }
    }

    fn operand(&mut self, vm: &mut Vm) -> Result<Operand> {
        let token = vm.peek()?;
        match token.kind {
            TokenKind::Number(value) => {
                vm.take(token);
                Ok(Operand::number(value))
            }
            TokenKind::Punct(Punct::OpenParen) => {
                vm.take(token);
                let inner = self.deeper(vm, token.span, |body, vm| body.expression(vm, 0))?;
                if vm.peek()?.kind == TokenKind::Punct(Punct::Question) {
                    let fault = vm.expected("`)`");
                    return Err(fault.help(
                        "a function has no `?`: write `select(A, B, C)`, which is B for A < 0, else C",
                    ));
                }
                vm.close_paren(token.span)?;
                Ok(Operand { plain: false, ..inner })
            }
            TokenKind::Name(symbol) => self.named(vm, token, symbol),
            TokenKind::Word(Word::Pi) => {
                vm.take(token);
                Ok(Operand::number(std::f64::consts::PI))
            }
            TokenKind::Word(Word::Clock) => {
                vm.take(token);
                Ok(Operand::number(vm.options.clock.value))
            }
            TokenKind::Word(word) => self.word(vm, token, word),
            TokenKind::Vector(..)
            | TokenKind::Text
            | TokenKind::Punct(_)
            | TokenKind::Bad
            | TokenKind::End => Err(no_operand(vm)),
        }
    }

    fn parameter(&self, variable: Variable) -> Option<Operand> {
        let index = self.parameters.iter().position(|&parameter| parameter == variable)?;
        Some(Operand::other(Expr::Parameter(index as u16), true))
    }

    fn word(&mut self, vm: &mut Vm, token: Token, word: Word) -> Result<Operand> {
        if let Some(axis) = axis(word) {
            vm.take(token);
            // An axis that is no parameter is zero.
            let zero = Operand::other(Expr::Constant(0.0), true);
            return Ok(self.parameter(Variable::Axis(axis)).unwrap_or(zero));
        }
        if matches!(word, Word::Sum | Word::Prod) {
            vm.take(token);
            return self.series(vm, word);
        }
        let Some((builtin, least, most)) = builtin(word) else {
            let fault = no_operand(vm);
            return Err(fault.help(format!("`{}` cannot be used inside a function", word.text())));
        };
        vm.take(token);
        let folds = self.folds;
        // `pow` is an operator to POV-Ray, more than a call.
        let Arguments { arguments, varies, plain_first, plain } =
            self.arguments(vm, folds && builtin == Builtin::Pow)?;
        if arguments.len() < least || arguments.len() > most {
            let wanted = match (least, most) {
                (least, usize::MAX) => format!("{least} or more arguments"),
                (1, 1) => "one argument".to_owned(),
                (least, most) if least == most => format!("{least} arguments"),
                (least, most) => format!("{least} or {most} arguments"),
            };
            let message = format!("`{}` takes {wanted}, but {} given", word.text(), arguments.len());
            return Err(vm.error(token.span.to(vm.last), message));
        }
        let expr = match (builtin, plain) {
            (Builtin::Pow, Some(exponent)) if folds && !plain_first => {
                if exponent == 0.0 && varies {
                    vm.warn(token.span.to(vm.last), "a power of zero is always 1", "");
                }
                power(arguments, exponent)
            }
            _ => Expr::Call(builtin, arguments),
        };
        Ok(Operand::other(expr, varies))
    }

    /// Reads `(i, from, to, term)` after `sum` or `prod`.
    fn series(&mut self, vm: &mut Vm, word: Word) -> Result<Operand> {
        let open = vm.expect(Punct::OpenParen)?;
        let token = vm.peek()?;
        let TokenKind::Name(name) = token.kind else { return Err(vm.expected("the name that counts")) };
        vm.take(token);
        vm.expect(Punct::Comma)?;
        let (from, to, term) = self.deeper(vm, open, |body, vm| {
            let from = body.expression(vm, 0)?;
            vm.expect(Punct::Comma)?;
            let to = body.further(vm)?;
            vm.expect(Punct::Comma)?;
            body.running.push(name);
            let term = body.further(vm);
            body.running.pop();
            Ok((from, to, term?))
        })?;
        vm.close_paren(open)?;
        if let (Expr::Constant(first), Expr::Constant(last)) = (&from.expr, &to.expr)
            && last - first > MOST_TERMS
        {
            let message =
                format!("this `{}` has {:e} terms, more than can be computed", word.text(), last - first);
            return Err(vm.error(token.span.to(vm.last), message));
        }
        let varies = from.varies || to.varies || term.varies;
        let parts = Box::new([from.expr, to.expr, term.expr]);
        let expr = if word == Word::Sum { Expr::Sum(parts) } else { Expr::Product(parts) };
        Ok(Operand::other(expr, varies))
    }

    /// Reads a name: what counts in a sum, a parameter, a variable, or the call of a function.
    fn named(&mut self, vm: &mut Vm, token: Token, symbol: Symbol) -> Result<Operand> {
        if let Some(index) = self.running.iter().rposition(|&running| running == symbol) {
            vm.take(token);
            return Ok(Operand::other(Expr::Running(index as u16), true));
        }
        if let Some(operand) = self.parameter(Variable::Name(symbol)) {
            vm.take(token);
            return Ok(operand);
        }
        if vm.place.is_none() && self.name == Some(symbol) {
            vm.take(token);
            return self.recursion(vm, symbol, token.span);
        }
        let value = match vm.place.clone() {
            Some(place) => match place.get() {
                Some(value) => value,
                None => return Err(vm.unset_element(token.span)),
            },
            None => return Err(no_operand(vm)),
        };
        match value {
            Value::Float(value) => {
                vm.take(token);
                Ok(Operand::number(value))
            }
            Value::Function(function) => {
                vm.take(token);
                self.call(vm, function, token.span)
            }
            Value::Vector2(_) | Value::Vector3(_) | Value::Vector4(_) | Value::Color(_) => {
                let fault = no_operand(vm);
                Err(fault.help("functions know floats only: declare a float with the component you need"))
            }
            _ => Err(no_operand(vm)),
        }
    }

    /// Reads the arguments of a function that calls itself; its name was just taken.
    fn recursion(&mut self, vm: &mut Vm, symbol: Symbol, span: Span) -> Result<Operand> {
        let Arguments { arguments, varies, .. } = self.arguments(vm, false)?;
        let name = vm.name(symbol).to_owned();
        if arguments.len() != self.parameters.len() {
            return Err(wrong_count(vm, &name, self.parameters.len(), arguments.len(), span));
        }
        vm.possible(
            span.to(vm.last),
            format!("function `{name}` calls itself, which POV-Ray does not support"),
            "it has to end: `select` computes only the argument it chooses",
        );
        Ok(Operand::other(Expr::Recursion(arguments), varies))
    }

    fn call(&mut self, vm: &mut Vm, function: Arc<Function>, span: Span) -> Result<Operand> {
        let Arguments { arguments, varies, .. } = self.arguments(vm, false)?;
        if arguments.len() != function.parameters {
            let fault = wrong_count(vm, &function.name, function.parameters, arguments.len(), span);
            return Err(fault.see(function.span, "the function"));
        }
        let several = matches!(
            *function.body,
            FunctionBody::Pigment(_) | FunctionBody::Transform(_) | FunctionBody::Spline(_)
        );
        let expr =
            if several { self.component(vm, function, arguments)? } else { Expr::User(function, arguments) };
        Ok(Operand::other(expr, varies))
    }

    /// Reads the `.member` that has to follow the call of a function with several components.
    fn component(&mut self, vm: &mut Vm, function: Arc<Function>, arguments: Vec<Expr>) -> Result<Expr> {
        if !vm.accept_punct(Punct::Point)? {
            let fault = vm.expected("`.` and a component");
            let name = &function.name;
            return Err(
                fault.help(format!("`{name}` gives several numbers; choose one, such as `{name}(..).x`"))
            );
        }
        let token = vm.peek()?;
        let part = |index: u8| Expr::Component(function.clone(), arguments.clone(), index);
        let times = |part: Expr, by: f64| binary(BinaryOp::Multiply, part, Expr::Constant(by), true);
        let plus = |a: Expr, b: Expr| binary(BinaryOp::Add, a, b, false);
        let mixed = match token.kind {
            TokenKind::Word(Word::Gray) => Some(part(GREY)),
            TokenKind::Name(symbol) => match &**vm.symbols.name(symbol) {
                "grey" => Some(part(GREY)),
                "hf" => Some(times(plus(part(0), times(part(1), 1.0 / 255.0)), 0.996093)),
                _ => None,
            },
            TokenKind::Word(word) => crate::interp::expr::component(word).map(|index| part(index as u8)),
            _ => None,
        };
        match mixed {
            Some(expr) => {
                vm.take(token);
                Ok(expr)
            }
            None => Err(vm.expected("a component such as `x`, `red` or `gray`")),
        }
    }

    /// Reads the arguments of a call; `folds` says whether numbers are put together in all of them, as they are
    /// in the first.
    fn arguments(&mut self, vm: &mut Vm, folds: bool) -> Result<Arguments> {
        let open = vm.expect(Punct::OpenParen)?;
        self.deeper(vm, open, |body, vm| {
            let first = body.expression(vm, 0)?;
            let plain_first = first.plain;
            let (mut arguments, mut varies, mut plain) = (vec![first.expr], first.varies, None);
            while vm.accept_punct(Punct::Comma)? {
                let next = if folds { body.expression(vm, 0)? } else { body.further(vm)? };
                varies |= next.varies;
                plain = if let (Expr::Constant(value), true) = (&next.expr, next.plain) {
                    Some(*value)
                } else {
                    None
                };
                arguments.push(next.expr);
            }
            vm.close_paren(open)?;
            Ok(Arguments { arguments, varies, plain_first, plain })
        })
    }

    /// Reads an argument in which numbers are not put together.
    fn further(&mut self, vm: &mut Vm) -> Result<Operand> {
        let folds = std::mem::replace(&mut self.folds, false);
        let operand = self.expression(vm, 0);
        self.folds = folds;
        operand
    }

    /// Reads something inside parentheses.
    fn deeper<T>(
        &mut self,
        vm: &mut Vm,
        span: Span,
        read: impl FnOnce(&mut Self, &mut Vm) -> Result<T>,
    ) -> Result<T> {
        vm.nested(span, |vm| read(self, vm))
    }
}

/// The error for a call with too few or too many arguments, the last of which was just taken.
fn wrong_count(vm: &Vm, name: &str, wanted: usize, given: usize, span: Span) -> Fault {
    vm.error(span.to(vm.last), format!("function `{name}` takes {wanted} arguments, but {given} given"))
}

fn no_operand(vm: &mut Vm) -> Fault {
    let fault = vm.expected("an operand");
    match fault.has_help() {
        true => fault,
        false => fault.help("functions calculate with numbers, parameters, float variables and calls"),
    }
}

/// Puts two trees together. What is divided by a plain number is multiplied by its inverse.
fn binary(op: BinaryOp, left: Expr, right: Expr, plain: bool) -> Expr {
    let (op, right) = match (op, &right) {
        (BinaryOp::Divide, &Expr::Constant(c)) if plain => (BinaryOp::Multiply, Expr::Constant(1.0 / c)),
        _ => (op, right),
    };
    match (&left, &right) {
        (&Expr::Constant(a), &Expr::Constant(b)) => Expr::Constant(compute(op, a, b)),
        _ => Expr::Binary(op, Box::new(left), Box::new(right)),
    }
}

/// `pow` of anything but a plain number with a plain exponent: those up to 8 are products.
fn power(arguments: Vec<Expr>, exponent: f64) -> Expr {
    match (arguments.first(), exponent) {
        (_, 0.0) => Expr::Constant(1.0),
        (Some(base), 2.0..=8.0) if exponent.fract() == 0.0 => {
            Expr::Power(Box::new(base.clone()), exponent as u8)
        }
        _ => Expr::Call(Builtin::Pow, arguments),
    }
}
