//! Arrays, docs/spec/language.md 3.6.

use super::limits::{MOST_DIMENSIONS, MOST_ELEMENTS};
use super::scope::Place;
use super::stream::TokenKind;
use super::tuple::to_int;
use super::value::Value;
use super::{Fault, Result, Vm};
use crate::source::Span;
use crate::syntax::{Punct, Symbol};
use std::rc::Rc;

/// Values in one to five dimensions, all of one kind.
#[derive(Clone, Debug)]
pub struct Array {
    /// The size of each dimension.
    pub sizes: Vec<usize>,
    elements: Vec<Option<Value>>,
    /// An element that is set, which all others must resemble.
    sample: Option<usize>,
}

impl Array {
    /// An array of unset elements. The caller has checked that so many fit into memory.
    pub fn new(sizes: Vec<usize>) -> Array {
        let count = sizes.iter().product();
        Array { sizes, elements: vec![None; count], sample: None }
    }

    /// An element by its place over all dimensions.
    pub fn get(&self, index: usize) -> Option<&Value> {
        self.elements.get(index)?.as_ref()
    }

    /// An element that is set: all others are of its kind.
    pub fn sample(&self) -> Option<&Value> {
        self.get(self.sample?)
    }

    /// Sets an element. The error says what kind the array holds.
    pub fn set(&mut self, index: usize, value: Value) -> Result<(), String> {
        if let Some(sample) = self.sample()
            && !sample.same_kind(&value)
            && !matches!(value, Value::Poisoned)
        {
            return Err(format!("this array holds elements like {}, not {}", sample.kind(), value.kind()));
        }
        let poisoned = matches!(value, Value::Poisoned);
        if let Some(slot) = self.elements.get_mut(index) {
            *slot = Some(value);
            if !poisoned {
                self.sample.get_or_insert(index);
            }
        }
        Ok(())
    }

    /// Forgets an element; the kind the array holds stays that of the others.
    pub fn clear(&mut self, index: usize) {
        if let Some(slot) = self.elements.get_mut(index) {
            *slot = None;
        }
        if self.sample == Some(index) {
            self.sample = self.elements.iter().position(Option::is_some);
        }
    }

    /// The place of the element with these subscripts, one for each dimension. The error names
    /// what is out of range.
    pub fn index(&self, subscripts: &[f64]) -> Result<usize, String> {
        let mut index = 0;
        for (&subscript, &size) in subscripts.iter().zip(&self.sizes) {
            let at = to_int(subscript + 1e-10);
            if subscript < -1e-10 || at < 0 || at as usize >= size {
                let shown =
                    if subscript.fract() == 0.0 { format!("{subscript:.0}") } else { subscript.to_string() };
                return Err(format!("subscript {shown} is outside the array's 0 to {}", size - 1));
            }
            index = index * size + at as usize;
        }
        Ok(index)
    }
}

impl Vm<'_> {
    /// The element that the subscripts at hand name in the array of a place; the place itself
    /// when no subscripts follow, or it holds no array.
    pub(super) fn element(&mut self, place: Place, symbol: Symbol, span: Span) -> Result<Place> {
        let mut place = place;
        loop {
            if !self.at_bracket() {
                return Ok(place);
            }
            let array = match place.get() {
                Some(Value::Array(array)) => array,
                Some(Value::Poisoned) => return Err(Fault::reported()),
                _ => return Ok(place),
            };
            let index = self.read_subscripts(&array, symbol, span)?;
            place = match place {
                Place::Variable(cell) => Place::Element(cell, index),
                // An array inside an array is changed through a copy of its own.
                Place::Element(..) => match array.get(index) {
                    Some(value) => Place::new(value.clone()),
                    None => return Err(self.unset_element(span)),
                },
            };
        }
    }

    fn read_subscripts(&mut self, array: &Array, symbol: Symbol, span: Span) -> Result<usize> {
        let mut subscripts = Vec::with_capacity(array.sizes.len());
        let start = self.frame.tree.span(self.frame.pos);
        for _ in &array.sizes {
            if !self.at_bracket() {
                let name = self.symbols.name(symbol);
                let (wanted, given) = (array.sizes.len(), subscripts.len());
                let message = format!("array `{name}` needs {wanted} subscripts, but has {given} here");
                return Err(self.error(span.to(self.last), message));
            }
            let open = self.next_raw().span;
            let value = self.nested(open, |vm| vm.inside(Vm::read_float))?;
            if self.peek()?.kind != TokenKind::Punct(Punct::CloseBracket) {
                return Err(self.expected("`]`").see(open, "to close this"));
            }
            self.next()?;
            subscripts.push(value);
        }
        array
            .index(&subscripts)
            .map_err(|message| self.error(start.to(self.last), message).help("subscripts count from 0"))
    }

    /// Reads `array[..] {..}`; the word is peeked.
    pub(super) fn read_array(&mut self) -> Result<Value> {
        let keyword = self.next()?.span;
        let mut sizes = Vec::new();
        while self.peek_raw().kind == TokenKind::Punct(Punct::OpenBracket) {
            let open = self.next_raw().span;
            if sizes.len() == MOST_DIMENSIONS {
                return Err(self.error(open, format!("an array has at most {MOST_DIMENSIONS} dimensions")));
            }
            let value = self.inside(Vm::read_float)?;
            let size = to_int(value + 1e-10);
            if size < 1 {
                return Err(self.error(open.to(self.last), format!("an array cannot have {size} elements")));
            }
            self.expect(Punct::CloseBracket)?;
            sizes.push(size as usize);
        }
        if sizes.is_empty() {
            let fault = self.expected("`[` and the size of the array");
            return Err(fault.help("an array has a fixed size: `array[3] {1, 2, 3}`"));
        }
        let count = sizes.iter().try_fold(1_usize, |count, &size| count.checked_mul(size));
        if count.is_none_or(|count| count > MOST_ELEMENTS) {
            return Err(self.error(keyword.to(self.last), "this array is too large for memory"));
        }
        let mut array = Array::new(sizes);
        if self.peek_raw().kind == TokenKind::Punct(Punct::OpenBrace) {
            let mut next = 0;
            self.read_elements(&mut array, 0, &mut next)?;
        }
        Ok(Value::Array(Rc::new(array)))
    }

    /// Reads the elements of one dimension with the braces around them.
    fn read_elements(&mut self, array: &mut Array, dimension: usize, next: &mut usize) -> Result<()> {
        let open = self.peek()?;
        if open.kind != TokenKind::Punct(Punct::OpenBrace) {
            return Err(self.expected("`{` around the elements of each dimension"));
        }
        self.take(open);
        let size = array.sizes[dimension];
        for given in 0..size {
            let token = self.peek()?;
            if token.kind == TokenKind::Punct(Punct::CloseBrace) {
                let message = format!("this array has room for {size} elements, but {given} are given");
                return Err(self.error(open.span.to(token.span), message).help("give all of them, or none"));
            }
            if dimension + 1 < array.sizes.len() {
                self.read_elements(array, dimension + 1, next)?;
            } else {
                let value = self.read_element()?;
                array.set(*next, value).map_err(|message| self.error(token.span.to(self.last), message))?;
                *next += 1;
            }
            self.comma()?;
        }
        if self.peek()?.kind != TokenKind::Punct(Punct::CloseBrace) {
            let fault = self.expected(&format!("`}}` after {size} elements"));
            return Err(fault.see(open.span, "to close this"));
        }
        self.next()?;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn subscripts_are_cut_with_a_little_tolerance() {
        let array = Array::new(vec![3]);
        let at = |s: f64| array.index(&[s]);
        assert_eq!([at(1.9), at(1.0 - 1e-11), at(-1e-11)], [Ok(1), Ok(1), Ok(0)]);
        assert!(at(3.0).is_err() && at(-1.0).is_err());
    }

    #[test]
    fn the_first_element_fixes_the_kind() {
        let mut array = Array::new(vec![2, 2]);
        assert!(array.set(3, Value::Float(1.0)).is_ok());
        assert!(array.set(0, Value::Vector3([0.0; 3])).is_err());
        assert!(array.get(0).is_none());
    }
}
