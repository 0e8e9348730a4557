//! Functions that give a float, docs/spec/language.md 3.8.

use super::arguments;
use crate::interp::scope::Place;
use crate::interp::stream::TokenKind;
use crate::interp::tuple::{to_int, truth};
use crate::interp::value::Value;
use crate::interp::{Result, Vm, Word, tuple::Tuple};
use crate::source::Span;
use crate::syntax::Punct;

/// Whether a word is a function or changing constant that gives a float.
pub fn is_function(word: Word) -> bool {
    use Word::*;
    of_one(word).is_some()
        || matches!(
            word,
            Asin | Acos
                | Sqrt
                | Ln
                | Log
                | Atan2
                | Pow
                | Div
                | Mod
                | Min
                | Max
                | Select
                | BitwiseAnd
                | BitwiseOr
                | BitwiseXor
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

/// Functions of one float that work for every number.
fn of_one(word: Word) -> Option<fn(f64) -> f64> {
    Some(match word {
        Word::Abs => f64::abs,
        Word::Sin => f64::sin,
        Word::Cos => f64::cos,
        Word::Tan => f64::tan,
        Word::Sinh => f64::sinh,
        Word::Cosh => f64::cosh,
        Word::Tanh => f64::tanh,
        Word::Asinh => f64::asinh,
        Word::Acosh => f64::acosh,
        Word::Atanh => f64::atanh,
        Word::Atan => f64::atan,
        Word::Exp => f64::exp,
        Word::Ceil => f64::ceil,
        Word::Floor => f64::floor,
        Word::Int => |a| f64::from(to_int(a)),
        Word::Degrees => |a| a / (std::f64::consts::PI / 180.0),
        Word::Radians => |a| a * (std::f64::consts::PI / 180.0),
        _ => return None,
    })
}

/// Reads the arguments of a function whose name was just taken, and computes it.
pub fn call(vm: &mut Vm, word: Word, span: Span) -> Result<f64> {
    if let Some(f) = of_one(word) {
        return Ok(f(one(vm)?));
    }
    let name = word.text();
    Ok(match word {
        Word::Clock => vm.options.clock.value,
        Word::ClockOn => f64::from(u8::from(vm.options.clock.chosen)),
        Word::Version => f64::from(vm.version) / 100.0,
        Word::Now => super::string::days_now(),
        Word::Asin | Word::Acos => {
            let mut a = one(vm)?;
            if a.abs() > 1.0 {
                vm.warn(
                    span.to(vm.last),
                    format!("`{name}` of {a}, which is outside -1 to 1"),
                    "the nearer end is taken",
                );
                a = a.clamp(-1.0, 1.0);
            }
            if word == Word::Asin { a.asin() } else { a.acos() }
        }
        Word::Sqrt => match one(vm)? {
            a if a < 0.0 => {
                return Err(vm.error(span.to(vm.last), format!("`sqrt` of a negative number, {a}")));
            }
            a => a.sqrt(),
        },
        Word::Ln | Word::Log => match one(vm)? {
            a if a <= 0.0 => {
                let fault = vm.error(span.to(vm.last), format!("`{name}` of {a}"));
                return Err(fault.help("logarithms need a number above zero"));
            }
            a if word == Word::Ln => a.ln(),
            a => a.log10(),
        },
        Word::Atan2 => {
            let [a, b] = several(vm)?;
            if !truth(a) && !truth(b) {
                return Err(vm
                    .error(span.to(vm.last), "`atan2` of zero and zero")
                    .help("a point at the origin has no angle"));
            }
            a.atan2(b)
        }
        Word::Pow => {
            let [a, b] = several(vm)?;
            if a == 0.0 && b == 0.0 {
                return Err(vm.error(span.to(vm.last), "`pow` of zero and zero"));
            }
            a.powf(b)
        }
        Word::Div => {
            let [a, b] = several(vm)?;
            f64::from(to_int(a / b))
        }
        Word::Mod => {
            let [a, b] = several(vm)?;
            // What the C library gives here prints as `-nan`, and scenes may print it.
            if b == 0.0 { -f64::NAN } else { a % b }
        }
        Word::Min => fold(vm, f64::min)?,
        Word::Max => fold(vm, f64::max)?,
        Word::BitwiseAnd => fold(vm, |a, b| f64::from(to_int(a) & to_int(b)))?,
        Word::BitwiseOr => fold(vm, |a, b| f64::from(to_int(a) | to_int(b)))?,
        Word::BitwiseXor => fold(vm, |a, b| f64::from(to_int(a) ^ to_int(b)))?,
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

/// The argument of a function of one float: comparisons are allowed in it.
fn one(vm: &mut Vm) -> Result<f64> {
    arguments(vm, |vm| {
        let start = vm.peek()?.span;
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
