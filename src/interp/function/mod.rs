//! User functions: `function (parameters) { body }` becomes a tree, docs/spec/language.md 4.

mod body;
mod table;

use super::limits::MOST_FUNCTION_PARAMETERS;
use super::stream::{Token, TokenKind};
use super::value::Value;
use super::{Fault, Result, Vm, Word, statement};
use crate::scene::Function;
use crate::scene::depth::Nested;
use crate::scene::function::FunctionBody;
use crate::syntax::{Punct, Symbol};
use body::Body;
use std::sync::Arc;
use table::INTERNAL;

/// A name in the body of a function.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Variable {
    /// `x`, `y`, `z`; `u` is `x`, and `v` is `y`.
    Axis(u8),
    Name(Symbol),
}

impl Vm<'_> {
    /// Reads `function {..}` as a value; the word is peeked.
    pub(super) fn read_function_value(&mut self) -> Result<Value> {
        let name = self.declaring.take();
        let keyword = self.next()?;
        Ok(Value::Function(Arc::new(self.read_named_function(keyword, true, name)?)))
    }

    /// Reads `function (..) {..}`; the word is peeked. Without a list the parameters are x, y, z.
    pub fn read_function(&mut self) -> Result<Function> {
        let keyword = self.next()?;
        self.read_function_after(keyword, true)
    }

    /// Reads what follows the word `function`. Bodies that are no expressions may be refused.
    pub(super) fn read_function_after(&mut self, keyword: Token, special: bool) -> Result<Function> {
        self.read_named_function(keyword, special, None)
    }

    /// The same for a function that may call itself by a name.
    fn read_named_function(
        &mut self,
        keyword: Token,
        special: bool,
        name: Option<Symbol>,
    ) -> Result<Function> {
        let listed = self.peek()?.kind == TokenKind::Punct(Punct::OpenParen);
        let parameters = match listed {
            true => self.read_parameters()?,
            false => (0..3).map(Variable::Axis).collect(),
        };
        let count = parameters.len();
        let block = self.open(keyword)?;
        let word = self.peek_word()?;
        let special = match word {
            _ if !special => None,
            Some(word @ (Word::Pattern | Word::Pigment | Word::Transform | Word::Spline)) if listed => {
                let fault = self.expected("an expression");
                let word = word.text();
                return Err(
                    fault.help(format!("`{word}` in a function has parameters of its own: remove the list"))
                );
            }
            Some(Word::Internal) => Some(self.read_internal()?),
            Some(Word::Spline) => Some((FunctionBody::Spline(Arc::new(self.read_spline()?)), 1)),
            Some(word) => statement::read_function_body(self, word)?.map(|body| (body, 3)),
            None => None,
        };
        let (body, parameters) = match special {
            Some(special) => special,
            None => {
                let mut body = Body { name, parameters, running: Vec::new(), folds: true };
                (FunctionBody::Expression(body.expression(self, 0)?.expr), count)
            }
        };
        let end = self.close(block)?;
        let body = Nested::new(body);
        let function = Function { span: keyword.span.to(end), name: "".into(), parameters, body };
        self.check_depth(&function, keyword.span)?;
        Ok(function)
    }

    fn read_parameters(&mut self) -> Result<Vec<Variable>> {
        let open = self.next()?.span;
        let mut parameters = Vec::new();
        loop {
            let token = self.peek_raw();
            let parameter = match token.kind {
                TokenKind::Punct(Punct::CloseParen) if !parameters.is_empty() => {
                    self.next_raw();
                    return Ok(parameters);
                }
                TokenKind::Word(word) => axis(word).map(Variable::Axis),
                TokenKind::Name(symbol) => match self.lookup(symbol) {
                    None => Some(Variable::Name(symbol)),
                    Some(Value::Poisoned) => return Err(Fault::reported()),
                    Some(value) => {
                        let name = self.symbols.name(symbol).clone();
                        let message =
                            format!("the parameter `{name}` is the name of {} already", value.kind());
                        return Err(self
                            .error(token.span, message)
                            .help("parameters of functions need names of their own"));
                    }
                },
                _ => None,
            };
            let Some(parameter) = parameter else {
                let fault = self.expected_at(token, "the name of a parameter");
                return Err(fault.see(open, "in these parentheses"));
            };
            if parameters.len() == MOST_FUNCTION_PARAMETERS {
                let message = format!("a function has at most {MOST_FUNCTION_PARAMETERS} parameters");
                return Err(self.error(token.span, message));
            }
            self.next_raw();
            parameters.push(parameter);
            if self.peek_raw().kind == TokenKind::Punct(Punct::Comma) {
                self.next_raw();
            }
        }
    }

    fn read_internal(&mut self) -> Result<(FunctionBody, usize)> {
        self.next()?;
        let open = self.expect(Punct::OpenParen)?;
        let start = self.peek()?.span;
        let number = self.read_float()?;
        let known = INTERNAL.get(number as usize).filter(|_| number >= 0.0);
        let Some(&parameters) = known else {
            let last = INTERNAL.len() - 1;
            return Err(self.error(
                start.to(self.last),
                format!("there is no internal function {number}; the last is {last}"),
            ));
        };
        self.close_paren(open)?;
        Ok((FunctionBody::Internal(number as u8), 3 + usize::from(parameters)))
    }
}

fn axis(word: Word) -> Option<u8> {
    Some(match word {
        Word::X | Word::U => 0,
        Word::Y | Word::V => 1,
        Word::Z => 2,
        _ => return None,
    })
}
