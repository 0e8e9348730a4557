//! Numeric expressions, docs/spec/language.md 3.1 to 3.3.
//!
//! Every method takes the number of components the place wants: a float read where a vector is
//! wanted is repeated at once, so `<1,2>+1` and `1+<1,2>` differ.

use super::scope::Place;
use super::stream::TokenKind;
use super::tuple::{Tuple, divide, test, truth};
use super::value::Value;
use super::{Fault, Result, Vm, Word, builtin};
use crate::source::Span;
use crate::syntax::{Punct, Symbol};

impl Vm<'_> {
    /// Reads FULL: comparisons, logic and `?:` as well.
    pub(super) fn full(&mut self, n: u8) -> Result<Tuple> {
        match self.replay(true, n) {
            Some(value) => Ok(value),
            None => self.choice(n),
        }
    }

    fn choice(&mut self, n: u8) -> Result<Tuple> {
        let start = self.peek_raw().span;
        let condition = self.logic(n)?;
        if self.operator()? != Some(Punct::Question) {
            return Ok(condition);
        }
        self.next()?;
        if condition.n != 1 && n <= 1 {
            return Err(self
                .error(start.to(self.last), "the condition of `?` is a vector")
                .help("compare one component"));
        }
        let yes = self.nested(start, |vm| vm.full(n))?;
        if self.operator()? != Some(Punct::Colon) {
            return Err(self.expected("`:` of the `?` before it"));
        }
        self.next()?;
        let no = self.nested(start, |vm| vm.full(n))?;
        Ok(if truth(condition.c[0]) { yes } else { no })
    }

    fn logic(&mut self, n: u8) -> Result<Tuple> {
        let mut left = self.relation(n)?;
        loop {
            let f = match self.operator()? {
                Some(Punct::And) => test::and,
                Some(Punct::Or) => test::or,
                _ => return Ok(left),
            };
            self.next()?;
            let right = self.relation(left.n)?;
            left = left.zip(right, f);
        }
    }

    fn relation(&mut self, n: u8) -> Result<Tuple> {
        if self.at_string()? {
            return self.compare_strings();
        }
        let mut left = self.sum(n)?;
        loop {
            let f = match self.operator()?.and_then(comparison) {
                Some(f) => f,
                None => return Ok(left),
            };
            self.next()?;
            let right = self.sum(left.n)?;
            left = left.zip(right, f);
        }
    }

    fn compare_strings(&mut self) -> Result<Tuple> {
        let a = self.read_string()?;
        let f = match self.operator()?.and_then(comparison) {
            Some(f) => f,
            None => return Err(self.expected("a comparison after the string")),
        };
        self.next()?;
        let b = self.read_string()?;
        Ok(Tuple::float(f(builtin::string::compare(&a, &b), 0.0)))
    }

    /// Reads ARITH: sums of products.
    pub(super) fn arith(&mut self, n: u8) -> Result<Tuple> {
        match self.replay(false, n) {
            Some(value) => Ok(value),
            None => self.sum(n),
        }
    }

    fn sum(&mut self, n: u8) -> Result<Tuple> {
        let mut left = self.term(n)?;
        loop {
            match self.operator()? {
                Some(Punct::Plus) => {
                    self.next()?;
                    left = left.zip(self.term(left.n)?, |a, b| a + b);
                }
                Some(Punct::Minus) => {
                    self.next()?;
                    left = left.zip(self.term(left.n)?, |a, b| a - b);
                }
                _ => return Ok(left),
            }
        }
    }

    fn term(&mut self, n: u8) -> Result<Tuple> {
        let mut left = self.factor(n)?;
        loop {
            match self.operator()? {
                Some(Punct::Star) => {
                    self.next()?;
                    left = left.zip(self.factor(left.n)?, |a, b| a * b);
                }
                Some(Punct::Slash) => {
                    let sign = self.next()?.span;
                    let right = self.factor(left.n)?;
                    if right.promoted(left.n).components().contains(&0.0) {
                        self.warn(sign.to(self.last), "division by zero", "the result is infinite");
                    }
                    left = left.zip(right, divide);
                }
                _ => return Ok(left),
            }
        }
    }

    fn factor(&mut self, n: u8) -> Result<Tuple> {
        let token = self.peek()?;
        match token.kind {
            TokenKind::Punct(Punct::Plus) => {
                self.take(token);
                self.nested(token.span, |vm| vm.factor(n))
            }
            TokenKind::Punct(Punct::Minus) => {
                self.take(token);
                Ok(self.nested(token.span, |vm| vm.factor(n))?.map(|c| -c))
            }
            TokenKind::Punct(Punct::Not) => {
                self.take(token);
                Ok(self.nested(token.span, |vm| vm.factor(n))?.map(test::not))
            }
            _ => {
                let value = self.primary(n)?;
                if self.operator()? == Some(Punct::Point) {
                    return self.member(value, n);
                }
                Ok(value)
            }
        }
    }

    /// Reads `.member` after an operand.
    fn member(&mut self, value: Tuple, n: u8) -> Result<Tuple> {
        let point = self.next()?.span;
        let token = self.peek()?;
        let TokenKind::Word(word) = token.kind else {
            return Err(self.expected("a component such as `x` or `red` after the `.`"));
        };
        let index = match component(word) {
            Some(index) => index,
            None if word == Word::Gray => {
                self.take(token);
                return Ok(Tuple::float(value.gray()).promoted(n));
            }
            None => return Err(self.expected("a component such as `x` or `red` after the `.`")),
        };
        self.take(token);
        if index >= usize::from(value.n) {
            let found = Value::from(value).kind();
            return Err(
                self.error(point.to(token.span), format!("{found} has no component `{}`", word.text()))
            );
        }
        Ok(Tuple::float(value.c[index]).promoted(n))
    }

    fn primary(&mut self, n: u8) -> Result<Tuple> {
        let token = self.peek()?;
        match token.kind {
            TokenKind::Number(value) => {
                self.take(token);
                Ok(Tuple::float(value).promoted(n))
            }
            TokenKind::Vector(len, first) => {
                let vector = Tuple::new(self.frame.tree.vector(len, first));
                self.take(token);
                Ok(vector)
            }
            TokenKind::Name(symbol) => self.named(symbol, token.span, n),
            TokenKind::Word(word) => match builtin::constant(word) {
                Some(value) => {
                    self.take(token);
                    Ok(value.promoted(n))
                }
                None => {
                    let value = self.inside(|vm| builtin::call(vm, word, token))?;
                    Ok(value.promoted(n))
                }
            },
            TokenKind::Punct(Punct::OpenParen) => {
                self.take(token);
                self.nested(token.span, |vm| {
                    vm.inside(|vm| {
                        let value = vm.full(n)?;
                        vm.close_paren(token.span)?;
                        Ok(value)
                    })
                })
            }
            TokenKind::Punct(Punct::Less) => {
                self.take(token);
                self.nested(token.span, |vm| vm.inside(|vm| vm.vector_literal(token.span)))
            }
            TokenKind::Text | TokenKind::Punct(_) | TokenKind::Bad | TokenKind::End => {
                Err(self.expected("a number or vector"))
            }
        }
    }

    /// Takes the `)` that closes a parenthesis.
    pub(super) fn close_paren(&mut self, open: Span) -> Result<()> {
        if self.accept_punct(Punct::CloseParen)? {
            return Ok(());
        }
        let fault = self.expected("`)`");
        Err(fault.see(open, "to close this"))
    }

    /// Reads the components of a vector after its `<`.
    fn vector_literal(&mut self, open: Span) -> Result<Tuple> {
        let mut tuple = Tuple { n: 0, c: [0.0; 5] };
        loop {
            let start = self.peek()?;
            if start.kind == TokenKind::Punct(Punct::Greater) {
                self.take(start);
                break;
            }
            if tuple.n == 5 {
                return Err(self.error(open.to(start.span), "a vector has at most five components"));
            }
            if tuple.n > 0 && matches!(start.kind, TokenKind::Punct(_)) && !self.at_number()? {
                let fault = self.expected("`,` or `>`");
                return Err(fault.see(open, "in the vector that starts here"));
            }
            let value = self.arith(1)?;
            if value.n != 1 {
                let fault = self.error(
                    start.span.to(self.last),
                    "a component of a vector has to be a float, not a vector",
                );
                return Err(fault.help("take one component of it, such as `.x`"));
            }
            tuple.c[usize::from(tuple.n)] = value.c[0];
            tuple.n += 1;
            if !self.accept_punct(Punct::Comma)?
                && tuple.n >= 2
                && self.peek()?.kind == TokenKind::Punct(Punct::GreaterEqual)
            {
                let fault = self.expected("`>`");
                return Err(fault.help("`>=` is one operator: put a space before the `=`"));
            }
        }
        if tuple.n < 2 {
            let fault = self.error(open.to(self.last), "a vector has at least two components");
            return Err(fault.help("write a single number without `< >`"));
        }
        Ok(tuple)
    }

    /// Reads a name as an operand: a variable, or the call of a function or spline.
    fn named(&mut self, symbol: Symbol, span: Span, n: u8) -> Result<Tuple> {
        let value = match &self.place {
            Some(Place::Variable(cell)) => match &*cell.borrow() {
                // By far the most frequent, so no copy is made for it.
                Value::Float(value) => Ok(*value),
                value => Err(Some(value.clone())),
            },
            Some(element) => Err(element.get()),
            None => return Err(self.expected("a number or vector")),
        };
        let tuple = match &value {
            Ok(value) => Tuple::float(*value).promoted(n),
            Err(None) => return Err(self.unset_element(span)),
            Err(Some(Value::Poisoned)) => return Err(Fault::reported()),
            Err(Some(called @ (Value::Function(_) | Value::Spline(_)))) => {
                self.used(symbol, span);
                return self
                    .inside(|vm| builtin::probe::call(vm, called, symbol, span))
                    .map(|value| value.promoted(n));
            }
            Err(Some(other)) => match other.tuple() {
                Some(tuple) => tuple.promoted(n),
                None => return Err(self.expected("a number or vector")),
            },
        };
        self.used(symbol, span);
        Ok(tuple)
    }

    /// Takes the name that was peeked.
    fn used(&mut self, symbol: Symbol, span: Span) {
        self.note_use(symbol, span);
        self.ahead = None;
        self.last = span;
    }

    pub(super) fn unset_element(&mut self, span: Span) -> Fault {
        self.error(span, "this element of the array was never set")
            .help("assign it with `#declare` first, or test it with `#ifdef`")
    }

    /// The operator at hand, if it is punctuation. In a blocked zone nothing runs to find it.
    #[inline]
    pub(super) fn operator(&mut self) -> Result<Option<Punct>> {
        let token = if self.blocked { self.peek_raw() } else { self.peek()? };
        Ok(match token.kind {
            TokenKind::Punct(punct) => Some(punct),
            _ => None,
        })
    }

    /// Reads something inside parentheses: directives are allowed everywhere in it.
    pub(super) fn inside<T>(&mut self, read: impl FnOnce(&mut Self) -> Result<T>) -> Result<T> {
        let blocked = std::mem::replace(&mut self.blocked, false);
        let result = read(self);
        self.blocked = blocked;
        result
    }
}

pub(super) fn comparison(punct: Punct) -> Option<fn(f64, f64) -> f64> {
    Some(match punct {
        Punct::Less => test::less,
        Punct::LessEqual => test::at_most,
        Punct::Equal => test::equal,
        Punct::NotEqual => test::not_equal,
        Punct::GreaterEqual => test::at_least,
        Punct::Greater => test::greater,
        _ => return None,
    })
}

/// Which component a member word names.
pub(super) fn component(word: Word) -> Option<usize> {
    Some(match word {
        Word::X | Word::U | Word::Red => 0,
        Word::Y | Word::V | Word::Green => 1,
        Word::Z | Word::Blue => 2,
        Word::T | Word::Filter => 3,
        Word::Transmit => 4,
        _ => return None,
    })
}
