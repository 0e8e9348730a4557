//! Reading arrays and their subscripts, docs/spec/language.md 3.6.

use super::limits::{MOST_DIMENSIONS, MOST_ELEMENTS};
use super::scope::Place;
use super::stream::TokenKind;
use super::tuple::to_int;
use super::value::{Array, Value};
use super::{Fault, Result, Vm};
use crate::source::Span;
use crate::syntax::{Punct, Symbol};
use std::rc::Rc;

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
            if value > MOST_ELEMENTS as f64 {
                return Err(self.error(open.to(self.last), "this array is too large for memory"));
            }
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
        let bytes = count.unwrap_or(0) * size_of::<Option<Value>>();
        self.reserve(bytes, keyword.to(self.last))?;
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
