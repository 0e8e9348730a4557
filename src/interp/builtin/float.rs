//! Functions that give a float, docs/spec/language.md 3.8.

use super::arguments;
use crate::interp::scope::Place;
use crate::interp::stream::TokenKind;
use crate::interp::tuple::{to_int, truth};
use crate::interp::value::Value;
use crate::interp::{Result, Vm, Word, tuple::Tuple};
use crate::math::hyperbolic;
use crate::source::Span;
use crate::syntax::Punct;

/// Whether a word is a function or changing constant that gives a float.
pub fn is_function(word: Word) -> bool {
    use Word::*;
    pure(word).is_some()
        || matches!(
            word,
            Select
                | Vdot
                | Vlength
                | Asc
                | Strlen
                | Strcmp
                | Val
                | FileExists
                | Defined
                | Dimensions
                | DimensionSize
                | Inside
                | Rand
                | Seed
                | Clock
                | ClockOn
                | Version
                | Now
        )
}

/// Functions of floats that depend on nothing else.
pub enum Pure {
    /// Of one float.
    One(fn(f64) -> f64),
    /// Of one float, not of every one.
    OneChecked(fn(f64) -> Option<f64>),
    /// Of two floats.
    Two(fn(f64, f64) -> f64),
    /// Of two floats, not of all.
    TwoChecked(fn(f64, f64) -> Option<f64>),
    /// Of one or more floats, put together from the left.
    Fold(fn(f64, f64) -> f64),
}

/// The pure function a word stands for.
pub fn pure(word: Word) -> Option<Pure> {
    Some(match word {
        Word::Abs => Pure::One(f64::abs),
        Word::Sin => Pure::One(f64::sin),
        Word::Cos => Pure::One(f64::cos),
        Word::Tan => Pure::One(f64::tan),
        Word::Sinh => Pure::One(f64::sinh),
        Word::Cosh => Pure::One(f64::cosh),
        Word::Tanh => Pure::One(f64::tanh),
        Word::Asinh => Pure::One(hyperbolic::asinh),
        Word::Acosh => Pure::One(hyperbolic::acosh),
        Word::Atanh => Pure::One(hyperbolic::atanh),
        Word::Atan => Pure::One(f64::atan),
        Word::Exp => Pure::One(f64::exp),
        Word::Ceil => Pure::One(f64::ceil),
        Word::Floor => Pure::One(f64::floor),
        Word::Int => Pure::One(|a| f64::from(to_int(a))),
        Word::Degrees => Pure::One(|a| a / (std::f64::consts::PI / 180.0)),
        Word::Radians => Pure::One(|a| a * (std::f64::consts::PI / 180.0)),
        Word::Asin => Pure::OneChecked(|a| (a.abs() <= 1.0 || a.is_nan()).then(|| a.asin())),
        Word::Acos => Pure::OneChecked(|a| (a.abs() <= 1.0 || a.is_nan()).then(|| a.acos())),
        // What is no number is outside of nothing.
        Word::Sqrt => Pure::OneChecked(|a| (a >= 0.0 || a.is_nan()).then(|| a.sqrt())),
        Word::Ln => Pure::OneChecked(|a| (a > 0.0 || a.is_nan()).then(|| a.ln())),
        Word::Log => Pure::OneChecked(|a| (a > 0.0 || a.is_nan()).then(|| a.log10())),
        Word::Atan2 => Pure::TwoChecked(|a, b| (truth(a) || truth(b)).then(|| a.atan2(b))),
        Word::Pow => Pure::TwoChecked(|a, b| (a != 0.0 || b != 0.0).then(|| a.powf(b))),
        Word::Div => Pure::Two(|a, b| f64::from(to_int(a / b))),
        // What the C library gives for a zero prints as `-nan`, and scenes may print it.
        Word::Mod => Pure::Two(|a, b| if b == 0.0 { -f64::NAN } else { a % b }),
        Word::Min => Pure::Fold(|a, b| if b < a { b } else { a }),
        Word::Max => Pure::Fold(|a, b| if b > a { b } else { a }),
        Word::BitwiseAnd => Pure::Fold(|a, b| f64::from(to_int(a) & to_int(b))),
        Word::BitwiseOr => Pure::Fold(|a, b| f64::from(to_int(a) | to_int(b))),
        Word::BitwiseXor => Pure::Fold(|a, b| f64::from(to_int(a) ^ to_int(b))),
        _ => return None,
    })
}

/// Reads the arguments of a function whose name was just taken, and computes it.
pub fn call(vm: &mut Vm, word: Word, span: Span) -> Result<f64> {
    match pure(word) {
        Some(Pure::One(f)) => return Ok(f(one(vm)?)),
        Some(Pure::OneChecked(f)) => {
            let a = one(vm)?;
            return match f(a) {
                Some(value) => Ok(value),
                None => outside(vm, word, a, span.to(vm.last)),
            };
        }
        Some(Pure::Two(f)) => {
            let [a, b] = several(vm)?;
            return Ok(f(a, b));
        }
        Some(Pure::TwoChecked(f)) => {
            let [a, b] = several(vm)?;
            return f(a, b).ok_or_else(|| {
                let fault = vm.error(span.to(vm.last), format!("`{}` of zero and zero", word.text()));
                match word {
                    Word::Atan2 => fault.help("a point at the origin has no angle"),
                    _ => fault.help("it is neither 0 nor 1"),
                }
            });
        }
        Some(Pure::Fold(f)) => return fold(vm, f),
        None => {}
    }
    let name = word.text();
    Ok(match word {
        Word::Clock => vm.options.clock.value,
        Word::ClockOn => f64::from(u8::from(vm.options.clock.chosen)),
        Word::Version => f64::from(vm.version) / 100.0,
        Word::Now => super::string::days_now(),
        Word::Select => arguments(vm, select)?,
        Word::Vdot => arguments(vm, |vm| {
            let a = vm.read_vector()?;
            vm.comma()?;
            Ok(a.dot(vm.read_vector()?))
        })?,
        Word::Vlength => arguments(vm, Vm::read_vector)?.length(),
        Word::Asc => arguments(vm, Vm::read_string)?.chars().next().map_or(0.0, |c| f64::from(u32::from(c))),
        Word::Strlen => arguments(vm, Vm::read_string)?.chars().count() as f64,
        Word::Strcmp => arguments(vm, |vm| {
            let a = vm.read_string()?;
            vm.comma()?;
            Ok(super::string::compare(&a, &vm.read_string()?))
        })?,
        Word::Val => super::string::leading_number(&arguments(vm, Vm::read_string)?),
        Word::FileExists => {
            let name = arguments(vm, Vm::read_file_name)?;
            f64::from(u8::from(vm.sources.library.exists(&name)))
        }
        Word::Defined => {
            let open = vm.expect(Punct::OpenParen)?;
            let found = vm.read_defined(Word::Defined)?;
            vm.close_paren(open)?;
            f64::from(u8::from(found))
        }
        Word::Dimensions => array_sizes(vm, |_, sizes| Ok(sizes.len() as f64))?,
        Word::DimensionSize => array_sizes(vm, |vm, sizes| {
            vm.comma()?;
            let n = vm.read_int()?;
            Ok(usize::try_from(n)
                .ok()
                .and_then(|n| sizes.get(n.wrapping_sub(1)))
                .map_or(0.0, |&size| size as f64))
        })?,
        Word::Inside => super::probe::inside(vm, span)?,
        Word::Rand => {
            let k = one(vm)?;
            match vm.random.next(to_int(k)) {
                Some(value) => value,
                None => {
                    let fault = vm.error(span.to(vm.last), format!("there is no random stream {k}"));
                    return Err(
                        fault.help("`rand` needs a stream made by `seed`, such as `#declare R = seed(1);`")
                    );
                }
            }
        }
        Word::Seed => {
            let seed = to_int(one(vm)?);
            vm.random.seed(seed)
        }
        _ => return Err(vm.error(span, format!("`{name}` cannot be called here"))),
    })
}

/// What happens when a function has no value for an argument.
fn outside(vm: &mut Vm, word: Word, a: f64, span: Span) -> Result<f64> {
    let name = word.text();
    match word {
        Word::Asin | Word::Acos => {
            let message = format!("`{name}` of {a}, which is outside -1 to 1");
            vm.warn(span, message, "the nearer end is taken");
            let a = a.clamp(-1.0, 1.0);
            Ok(if word == Word::Asin { a.asin() } else { a.acos() })
        }
        Word::Sqrt => Err(vm.error(span, format!("`sqrt` of a negative number, {a}"))),
        _ => Err(vm.error(span, format!("`{name}` of {a}")).help("logarithms need a number above zero")),
    }
}

/// The argument of a function of one float: comparisons are allowed in it.
fn one(vm: &mut Vm) -> Result<f64> {
    arguments(vm, |vm| {
        let start = vm.peek_raw().span;
        let tuple = vm.full(1)?;
        single(vm, tuple, start)
    })
}

fn single(vm: &mut Vm, tuple: Tuple, start: Span) -> Result<f64> {
    Ok(vm.fit(tuple, 1, "a float", start)?.c[0])
}

fn several<const N: usize>(vm: &mut Vm) -> Result<[f64; N]> {
    arguments(vm, |vm| {
        let mut values = [0.0; N];
        for (i, slot) in values.iter_mut().enumerate() {
            if i > 0 {
                vm.comma()?;
            }
            *slot = vm.read_float()?;
        }
        Ok(values)
    })
}

/// One or more arguments with commas between them, put together from the left.
fn fold(vm: &mut Vm, f: impl Fn(f64, f64) -> f64) -> Result<f64> {
    arguments(vm, |vm| {
        let mut value = vm.read_float()?;
        while vm.accept_punct(Punct::Comma)? {
            value = f(value, vm.read_float()?);
        }
        Ok(value)
    })
}

fn select(vm: &mut Vm) -> Result<f64> {
    let choice = vm.read_float()?;
    vm.comma()?;
    let negative = vm.read_float()?;
    vm.comma()?;
    let zero = vm.read_float()?;
    let positive = if vm.accept_punct(Punct::Comma)? { vm.read_float()? } else { zero };
    Ok(if choice < 0.0 {
        negative
    } else if choice == 0.0 {
        zero
    } else {
        positive
    })
}

/// Reads the array between the parentheses of `dimensions` and its kin.
fn array_sizes(vm: &mut Vm, rest: impl FnOnce(&mut Vm, &[usize]) -> Result<f64>) -> Result<f64> {
    arguments(vm, |vm| {
        let token = vm.peek()?;
        let sizes = match (token.kind, vm.place.as_ref().and_then(Place::get)) {
            (TokenKind::Name(_), Some(Value::Array(array))) => array.sizes.clone(),
            _ => return Err(vm.expected("the name of an array")),
        };
        vm.take(token);
        rest(vm, &sizes)
    })
}

impl Vm<'_> {
    /// Reads the name, and perhaps subscripts, of which `#ifdef` and `defined` ask whether it has
    /// a value.
    pub(in crate::interp) fn read_defined(&mut self, asking: Word) -> Result<bool> {
        let token = self.next_raw();
        let symbol = match token.kind {
            TokenKind::Word(_) => return Ok(false),
            TokenKind::Name(symbol) => symbol,
            _ => return Err(self.expected_at(token, &format!("a name after `{}(`", asking.text()))),
        };
        let bracket = self.at_bracket();
        match self.scopes.find(symbol).cloned() {
            None => Ok(false),
            Some(place) if bracket => {
                let array = matches!(place.get(), Some(Value::Array(_)));
                if !array {
                    return Err(
                        self.error(token.span, format!("`{}` is no array", self.symbols.name(symbol)))
                    );
                }
                let place = self.element(place, symbol, token.span)?;
                Ok(place.look().is_some())
            }
            Some(_) => Ok(true),
        }
    }
}
