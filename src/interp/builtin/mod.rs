//! The functions and constants expressions can use, docs/spec/language.md 3.7 to 3.11.

pub mod color;
pub mod float;
pub mod probe;
pub mod random;
pub mod string;
pub mod vector;

use super::stream::Token;
use super::tuple::Tuple;
use super::{Result, Vm, Word};
use crate::syntax::Punct;

/// Whether a word can start a numeric expression.
pub fn is_numeric(word: Word) -> bool {
    constant(word).is_some() || float::is_function(word) || vector::is_function(word)
}

/// The value of a word that stands for itself.
#[inline]
pub fn constant(word: Word) -> Option<Tuple> {
    Some(match word {
        Word::X => Tuple::new(&[1.0, 0.0, 0.0]),
        Word::Y => Tuple::new(&[0.0, 1.0, 0.0]),
        Word::Z => Tuple::new(&[0.0, 0.0, 1.0]),
        Word::T => Tuple::new(&[0.0, 0.0, 0.0, 1.0]),
        Word::U => Tuple::new(&[1.0, 0.0]),
        Word::V => Tuple::new(&[0.0, 1.0]),
        Word::Pi => Tuple::float(std::f64::consts::PI),
        Word::On | Word::Yes | Word::True => Tuple::float(1.0),
        Word::Off | Word::No | Word::False => Tuple::float(0.0),
        _ => return None,
    })
}

/// Reads a word as an operand that has to be computed; `token` is that word, not yet taken.
pub fn call(vm: &mut Vm, word: Word, token: Token) -> Result<Tuple> {
    if float::is_function(word) {
        vm.take(token);
        return Ok(Tuple::float(float::call(vm, word, token.span)?));
    }
    if vector::is_function(word) {
        vm.take(token);
        return vector::call(vm, word, token.span);
    }
    if color::is_keyword(word) {
        let fault = vm.expected("a number or vector");
        return Err(fault.help("a color keyword cannot stand inside an expression; declare the color first, then calculate with its name"));
    }
    Err(vm.expected("a number or vector"))
}

/// Reads the arguments of a function between parentheses: `read` gets to read what is inside.
pub(super) fn arguments<'a, T>(vm: &mut Vm<'a>, read: impl FnOnce(&mut Vm<'a>) -> Result<T>) -> Result<T> {
    let open = vm.expect(Punct::OpenParen)?;
    vm.nested(open, |vm| {
        let value = vm.inside(read)?;
        vm.close_paren(open)?;
        Ok(value)
    })
}
