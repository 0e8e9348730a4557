//! `#declare`, `#local`, `#undef` and the values they and macro calls take,
//! docs/spec/language.md 2.3.

use crate::interp::builtin::{self, color, string};
use crate::interp::scope::{Deprecation, Place};
use crate::interp::stream::{Token, TokenKind};
use crate::interp::value::Value;
use crate::interp::{Fault, Result, Vm, Word, statement};
use crate::source::Span;
use crate::syntax::{Punct, Symbol};
use std::rc::Rc;
use std::sync::Arc;

/// A value that was read, and whether a semicolon has to follow it in a declaration.
struct Read {
    value: Value,
    ends_with_semicolon: bool,
}

/// What is declared: a name, or an element of an array.
struct Target {
    symbol: Symbol,
    span: Span,
    /// The scope it was named in: the value may end inside a macro, which has a scope of its own.
    scope: u32,
    /// The element, where subscripts were written.
    element: Option<Place>,
    /// What the name stood for before the value was read, for the value may end the macro it
    /// stands in or leave one it called.
    bound: Option<Place>,
}

impl Vm<'_> {
    /// `#declare` or `#local`, just read. When the value has an error the name is poisoned, so
    /// that its uses are no further errors.
    pub(in crate::interp) fn declare(&mut self, local: bool) -> Result<()> {
        let depth = self.depth;
        let blocks = self.blocks.len();
        let note = match self.read_deprecation() {
            Ok(note) => note,
            Err(fault) => return self.give_up(fault, depth),
        };
        let target = match self.read_target(local) {
            Ok(target) => target,
            Err(fault) => return self.give_up(fault, depth),
        };
        let fresh = !self.scopes.is_bound(target.symbol);
        let value = match self.read_value(&target) {
            Ok(value) => value,
            Err(fault) => {
                let result = self.give_up(fault, depth);
                // An element keeps what it had, and so does what may not be declared.
                if target.element.is_none() && !self.is_protected(target.symbol) {
                    drop(self.assign(&target, Value::Poisoned, local));
                }
                return result;
            }
        };
        let ends = value.ends_with_semicolon;
        let value = if ends && self.goes_on() { Value::Poisoned } else { value.value };
        self.note_declared(target.span, &value);
        self.assign(&target, value, local)?;
        if let (Some(note), true) = (note, fresh) {
            let message = note.message.unwrap_or_else(|| {
                format!("`{}` is deprecated and may go away", self.symbols.name(target.symbol)).into()
            });
            self.scopes.deprecate(target.symbol, Deprecation { message, once: note.once });
        }
        self.end_declaration(ends, blocks)
    }

    /// Whether what follows a number that was declared seems to belong to it, so that it is not what was meant.
    fn goes_on(&mut self) -> bool {
        use Punct::{And, Comma, Equal, Greater, Less, Or, Question};
        let marks = [And, Comma, Equal, Greater, Less, Or, Question];
        self.version >= 350
            && match self.peek_raw().kind {
                TokenKind::Number(_) | TokenKind::Vector(..) => true,
                TokenKind::Punct(mark) => marks.contains(&mark),
                _ => false,
            }
    }

    /// Ends a directive that has an error: what belongs to it is skipped.
    fn give_up(&mut self, fault: Fault, depth: i32) -> Result<()> {
        self.settle(fault);
        self.skip_declaration(depth);
        Ok(())
    }

    fn is_protected(&self, symbol: Symbol) -> bool {
        matches!(self.lookup(symbol), Some(Value::Macro(_) | Value::File(_) | Value::Function(_)))
    }

    fn read_deprecation(&mut self) -> Result<Option<Note>> {
        if self.peek_raw().kind != TokenKind::Word(Word::Deprecated) {
            return Ok(None);
        }
        self.next_raw();
        let once = self.peek_raw().kind == TokenKind::Word(Word::Once);
        if once {
            self.next_raw();
        }
        let message = if self.peek_raw().kind == TokenKind::Text { Some(self.read_string()?) } else { None };
        Ok(Some(Note { once, message }))
    }

    /// Reads the name, subscripts and `=` of a declaration.
    fn read_target(&mut self, local: bool) -> Result<Target> {
        let token = self.peek_raw();
        if token.kind == TokenKind::Punct(Punct::Hash) {
            return Err(self.expected_at(token, "a name to declare"));
        }
        self.next_raw();
        let symbol = match token.kind {
            TokenKind::Name(symbol) => symbol,
            TokenKind::Word(word) => {
                let message = format!("`{}` is a reserved word and cannot be declared", word.text());
                return Err(self
                    .error(token.span, message)
                    .help("names with a capital letter are never reserved"));
            }
            _ => {
                let fault = self.expected_at(token, "a name to declare");
                if let TokenKind::Name(symbol) = self.peek_raw().kind {
                    self.poison(symbol);
                }
                return Err(fault);
            }
        };
        match self.lookup(symbol) {
            Some(Value::Macro(called)) => {
                let fault = self.error(token.span, format!("`{}` is a macro", self.symbols.name(symbol)));
                return Err(fault
                    .see(called.span, "defined here")
                    .help("`#undef` it first, or take another name"));
            }
            Some(Value::File(_)) => {
                let fault =
                    self.error(token.span, format!("`{}` is an open file", self.symbols.name(symbol)));
                return Err(fault.help("`#fclose` it first, or take another name"));
            }
            _ => {}
        }
        let element = self.target_element(symbol, token.span)?;
        let equal = self.peek_raw();
        if equal.kind != TokenKind::Punct(Punct::Equal) {
            let name = self.symbols.name(symbol).clone();
            let fault = self.expected_at(equal, &format!("`=` after `{name}`"));
            self.poison(symbol);
            return Err(fault);
        }
        let bound = if local { self.scopes.find_local(symbol) } else { self.scopes.find(symbol) }.cloned();
        self.next_raw();
        let scope = self.scopes.depth();
        Ok(Target { symbol, span: token.span, scope, element, bound })
    }

    /// The element of an array a declaration names by subscripts.
    fn target_element(&mut self, symbol: Symbol, span: Span) -> Result<Option<Place>> {
        let bracket = self.at_bracket();
        let place = self.scopes.find(symbol).cloned();
        match place.as_ref().and_then(Place::get) {
            Some(Value::Array(_)) if bracket => {}
            Some(Value::Poisoned) if bracket => return Err(Fault::reported()),
            _ if bracket => {
                let name = self.symbols.name(symbol).clone();
                let fault = self.error(span, format!("`{name}` is no array"));
                return Err(fault.help(format!("declare it first: `#declare {name} = array[10];`")));
            }
            _ => return Ok(None),
        }
        match place {
            Some(place) => self.element(place, symbol, span).map(Some),
            None => Ok(None),
        }
    }

    fn read_value(&mut self, target: &Target) -> Result<Read> {
        let old = match &target.element {
            Some(place) => place.get(),
            None => self.lookup(target.symbol),
        };
        self.declaring = target.element.is_none().then_some(target.symbol);
        let read = self.read_rvalue(None);
        self.declaring = None;
        let mut read = read?;
        if let Value::Function(function) = &mut read.value {
            Arc::make_mut(function).name = (&**self.symbols.name(target.symbol)).into();
        }
        let name = self.symbols.name(target.symbol);
        let is_function = matches!(read.value, Value::Function(_));
        match old {
            Some(Value::Function(_)) => {
                let fault = self.error(target.span, format!("function `{name}` cannot be declared again"));
                Err(fault.help(format!("write `#undef {name}` before it")))
            }
            Some(old) if is_function && target.element.is_none() && !matches!(old, Value::Poisoned) => {
                let message = format!("`{name}` is {} and cannot become a function", old.kind());
                Err(self.error(target.span, message).help(format!("write `#undef {name}` before it")))
            }
            _ => Ok(read),
        }
    }

    /// Binds the value to what is declared.
    fn assign(&mut self, target: &Target, value: Value, local: bool) -> Result<()> {
        let known = target.element.as_ref().or(target.bound.as_ref()).or_else(|| {
            if local {
                self.scopes.find_in(target.scope, target.symbol)
            } else {
                self.scopes.find(target.symbol)
            }
        });
        let known = known.cloned();
        if target.element.as_ref().is_some_and(|place| place.look().is_none()) {
            self.made_something();
        }
        let copied = known.as_ref().map_or(0, Place::copied_elements);
        self.reserve(copied * size_of::<Option<Value>>(), target.span)?;
        match known {
            Some(place) => place.set(value).map_err(|message| {
                self.error(target.span, message).help("all elements of an array are of one kind")
            }),
            None if local => {
                // A scope that the value ended takes no more names.
                if target.scope <= self.scopes.depth() {
                    self.scopes.bind_in(target.scope, target.symbol, Place::new(value));
                }
                Ok(())
            }
            None => {
                self.scopes.bind_global(target.symbol, Place::new(value));
                Ok(())
            }
        }
    }

    /// The `;` after a declaration, before which `blocks` directives were open.
    fn end_declaration(&mut self, needed: bool, blocks: usize) -> Result<()> {
        let mut found = false;
        for _ in 0..if needed { 2 } else { 1 } {
            if self.peek_raw().kind == TokenKind::Punct(Punct::Semicolon) {
                self.next_raw();
                found = true;
            }
        }
        if found || !needed || self.version < 310 {
            return Ok(());
        }
        let token = self.peek_raw();
        let help = "add a `;` here";
        if self.version < 350 {
            self.missing_semicolon("this declaration needs a `;` at its end");
            return Ok(());
        }
        let found = self.describe(token);
        let fault =
            self.error(self.last.after(), format!("this declaration needs a `;` at its end, found {found}"));
        let fault = fault.label("a `;` is missing here");
        let fault = match token.kind {
            TokenKind::Punct(Punct::Hash) if self.blocks.len() > blocks => {
                fault.help("in the value of a declaration directives can only stand inside parentheses")
            }
            TokenKind::Punct(
                Punct::Less | Punct::Greater | Punct::Equal | Punct::Question | Punct::And | Punct::Or,
            ) => fault.help("put a comparison or `?` in parentheses: `#declare A = (1 < 2);`"),
            _ => fault.help(help),
        };
        self.settle(fault);
        while self.blocks.len() > blocks && self.skip_token().is_some() {}
        if self.peek_raw().kind != TokenKind::Punct(Punct::Hash) {
            self.skip_declaration(self.depth);
        }
        Ok(())
    }

    /// Reads a macro argument: a single name is handed over by reference, anything else by value.
    pub(in crate::interp) fn read_argument(&mut self) -> Result<Place> {
        let mut alias = None;
        let read = self.read_rvalue(Some(&mut alias))?;
        Ok(alias.unwrap_or_else(|| Place::new(read.value)))
    }

    /// Reads a value for an array.
    pub(in crate::interp) fn read_element(&mut self) -> Result<Value> {
        let token = self.peek()?;
        let n = if let TokenKind::Vector(len, _) = token.kind { len } else { 1 };
        if let Some(tuple) = self.take_literal(token, n) {
            return Ok(tuple.into());
        }
        Ok(self.read_rvalue(None)?.value)
    }

    /// Reads whatever can stand to the right of `=`. With `alias`, a lone name of a variable
    /// leaves its place there.
    fn read_rvalue(&mut self, alias: Option<&mut Option<Place>>) -> Result<Read> {
        let token = self.peek()?;
        match token.kind {
            TokenKind::Name(symbol) => self.read_named(token, symbol, alias),
            TokenKind::Number(_) | TokenKind::Vector(..) | TokenKind::Punct(_) => self.read_numbers(),
            TokenKind::Text => self.read_text(),
            TokenKind::Word(Word::T) => {
                let fault = self.expected("a value");
                Err(fault.help("`t` cannot come first here: write `1*t`"))
            }
            TokenKind::Word(word) if builtin::is_numeric(word) => self.read_numbers(),
            TokenKind::Word(word) if string::is_function(word) => self.read_text(),
            TokenKind::Word(word) if color::is_keyword(word) => {
                self.blocked = true;
                let color = self.read_color();
                self.blocked = false;
                Ok(Read { value: Value::Color(color?.map(|c| c as f32)), ends_with_semicolon: true })
            }
            TokenKind::Word(word) => {
                let value = match word {
                    Word::Array => Some(self.read_array()?),
                    Word::Function => Some(self.read_function_value()?),
                    Word::Spline => Some(self.read_spline_value()?),
                    _ => statement::read_rvalue(self, word)?,
                };
                match value {
                    Some(value) => Ok(Read { value, ends_with_semicolon: false }),
                    None => {
                        let fault = self.expected("a value");
                        Err(fault.help("a value is an expression, a color, a string, or a whole statement with its braces"))
                    }
                }
            }
            TokenKind::Bad | TokenKind::End => Err(self.expected("a value")),
        }
    }

    fn read_text(&mut self) -> Result<Read> {
        let value = Value::Text(self.read_string()?);
        Ok(Read { value, ends_with_semicolon: false })
    }

    fn read_numbers(&mut self) -> Result<Read> {
        self.blocked = true;
        let tuple = self.arith(1);
        self.blocked = false;
        Ok(Read { value: tuple?.into(), ends_with_semicolon: true })
    }

    /// Reads a value that starts with a name.
    fn read_named(
        &mut self,
        token: Token,
        symbol: Symbol,
        alias: Option<&mut Option<Place>>,
    ) -> Result<Read> {
        let Some(place) = self.place.clone() else { return Err(self.expected("a value")) };
        let numeric = match place.look() {
            None => return Err(self.unset_element(token.span)),
            Some(value) => match &*value {
                Value::Poisoned => return Err(Fault::reported()),
                Value::Macro(_) | Value::File(_) => None,
                value => {
                    Some(value.tuple().is_some() || matches!(value, Value::Function(_) | Value::Spline(_)))
                }
            },
        };
        let Some(numeric) = numeric else { return Err(self.expected("a value")) };
        if !numeric {
            self.note_use(symbol, token.span);
            self.take(token);
            let value = place.get().unwrap_or(Value::Poisoned);
            if let Value::Array(array) = &value {
                self.check_depth(&**array, token.span)?;
            }
            if let Some(alias) = alias {
                *alias = Some(place);
            }
            return Ok(Read { value, ends_with_semicolon: false });
        }
        // A number's name may be the start of an expression: look one token further.
        self.ahead = None;
        let next = self.peek_raw();
        let callable = matches!(place.get(), Some(Value::Function(_) | Value::Spline(_)));
        let alone = match next.kind {
            TokenKind::Punct(Punct::OpenParen) => !callable,
            TokenKind::Punct(Punct::Plus | Punct::Minus | Punct::Star | Punct::Slash | Punct::Point) => {
                callable
            }
            _ => true,
        };
        if alone {
            self.last = token.span;
            self.note_use(symbol, token.span);
            let value = place.get().unwrap_or(Value::Poisoned);
            if let Some(alias) = alias
                && !matches!(value, Value::Function(_))
            {
                *alias = Some(place);
            }
            return Ok(Read { value, ends_with_semicolon: true });
        }
        if self.ahead.is_some() {
            self.ahead = None;
            self.frame.pos -= 1;
        }
        self.ahead = Some(token);
        self.place = Some(place);
        self.read_numbers()
    }

    /// `#undef`, just read.
    pub(super) fn undef(&mut self) -> Result<()> {
        let token = self.next_raw();
        let symbol = match token.kind {
            TokenKind::Name(symbol) => symbol,
            TokenKind::Word(word) => {
                return Err(self.error(
                    token.span,
                    format!("`{}` is a reserved word and stays what it is", word.text()),
                ));
            }
            _ => return Err(self.expected_at(token, "a name to forget")),
        };
        if let Some(element) = self.target_element(symbol, token.span)? {
            element.clear();
        } else if self.scopes.unbind(symbol).is_none() {
            let message =
                format!("`{}` is not declared, so there is nothing to forget", self.symbols.name(symbol));
            self.warn(token.span, message, "");
        }
        Ok(())
    }
}

/// What was said about a deprecated name.
struct Note {
    once: bool,
    message: Option<Rc<str>>,
}
