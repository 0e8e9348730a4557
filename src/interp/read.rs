//! What readers of statements ask for again and again: braces, commas, words, numbers, names.

use super::limits::{MOST_NESTING, SUSPICIOUS_NESTING};
use super::scope::Place;
use super::stream::{Token, TokenKind};
use super::tuple::Tuple;
use super::value::Value;
use super::{Fault, Result, Vm, Word};
use crate::diag::closest;
use crate::math::{DVec2, DVec3, DVec4};
use crate::source::Span;
use crate::syntax::{NodeKind, Punct, Symbol};

/// A statement whose brace was opened and is still to be closed.
#[derive(Clone, Copy, Debug)]
#[must_use = "an opened block has to be closed"]
pub struct Block {
    /// The word the block belongs to.
    pub keyword: Word,
    /// Where that word stands.
    pub span: Span,
    /// The brace.
    open: Span,
}

impl Vm<'_> {
    /// Takes the next token if it is this word.
    pub fn accept(&mut self, word: Word) -> Result<bool> {
        let token = self.peek()?;
        let found = token.kind == TokenKind::Word(word);
        if found {
            self.take(token);
        }
        Ok(found)
    }

    /// Takes the next token if it is this mark.
    pub fn accept_punct(&mut self, punct: Punct) -> Result<bool> {
        let token = self.peek()?;
        let found = token.kind == TokenKind::Punct(punct);
        if found {
            self.take(token);
        }
        Ok(found)
    }

    /// The next token if it is a reserved word, without taking it.
    pub fn peek_word(&mut self) -> Result<Option<Word>> {
        Ok(match self.peek()?.kind {
            TokenKind::Word(word) => Some(word),
            _ => None,
        })
    }

    /// Takes this mark, or fails.
    pub fn expect(&mut self, punct: Punct) -> Result<Span> {
        let token = self.peek()?;
        if token.kind != TokenKind::Punct(punct) {
            return Err(self.expected(&format!("`{}`", punct.text())));
        }
        self.take(token);
        Ok(token.span)
    }

    /// Takes a comma if there is one.
    #[inline]
    pub fn comma(&mut self) -> Result<()> {
        let frame = &self.frame;
        if self.ahead.is_none()
            && frame.pos < frame.end
            && frame.tree.nodes[frame.pos].kind == NodeKind::Punct(Punct::Comma)
        {
            self.last = frame.tree.span(frame.pos);
            self.frame.pos += 1;
            return Ok(());
        }
        self.seek_comma()
    }

    fn seek_comma(&mut self) -> Result<()> {
        // Most often one look tells; what may run and leave a comma is found out by running it.
        let token = self.peek_raw();
        match token.kind {
            TokenKind::Punct(Punct::Comma) => {
                self.next_raw();
            }
            TokenKind::Punct(Punct::Hash) => drop(self.accept_punct(Punct::Comma)?),
            TokenKind::Name(symbol) if self.is_macro(symbol) => drop(self.accept_punct(Punct::Comma)?),
            _ => {}
        }
        Ok(())
    }

    /// Takes the `{` after a keyword; `keyword` is the token of that word, just taken.
    pub fn open(&mut self, keyword: Token) -> Result<Block> {
        let TokenKind::Word(word) = keyword.kind else { return Err(self.expected("a keyword")) };
        let token = self.peek()?;
        if token.kind != TokenKind::Punct(Punct::OpenBrace) {
            // Where the brace is forgotten its partner is not; where it only comes late, it will open by itself.
            let late = self.at_node(Punct::OpenBrace)
                && (token.kind == keyword.kind || !matches!(token.kind, TokenKind::Word(_)));
            self.depth += i32::from(!late);
            let found = self.describe(token);
            let fault = self.error(token.span, format!("`{}` needs a `{{` here, found {found}", word.text()));
            return Err(fault.see(keyword.span, format!("this `{}`", word.text())));
        }
        if self.depth == SUSPICIOUS_NESTING && !std::mem::replace(&mut self.warned_of_depth, true) {
            let message = format!("{SUSPICIOUS_NESTING} braces are open here");
            self.warn(token.span, message, "is one of them never closed?");
        }
        if self.depth >= MOST_NESTING as i32 {
            return Err(self.too_deep(keyword.span));
        }
        self.take(token);
        self.made_something();
        Ok(Block { keyword: word, span: keyword.span, open: token.span })
    }

    /// Takes the `}` of a block. Anything else is an error: it does not belong there.
    pub fn close(&mut self, block: Block) -> Result<Span> {
        let token = self.peek()?;
        if token.kind == TokenKind::Punct(Punct::CloseBrace) {
            self.take(token);
            return Ok(token.span);
        }
        Err(self.misplaced(block, token))
    }

    /// The error for a token that a block has no use for.
    pub fn misplaced(&mut self, block: Block, token: Token) -> Fault {
        let keyword = block.keyword.text();
        if token.kind == TokenKind::End {
            let fault = self.error(token.span, format!("`{keyword} {{` is never closed"));
            return fault
                .label("the scene ends here")
                .see(block.open, "this brace")
                .help("add the missing `}`");
        }
        if let TokenKind::Name(_) = token.kind
            && self.is_poisoned()
        {
            return Fault::reported();
        }
        let found = self.describe(token);
        let fault = self.error(token.span, format!("{found} does not belong here in `{keyword} {{ }}`"));
        let fault = fault.label("not expected").see(block.open, format!("`{keyword}` opened here"));
        match self.suggestion(token) {
            Some(help) => fault.help(help),
            None => fault,
        }
    }

    /// The error for a token that is not what is needed: `what` says what that is.
    pub fn expected(&mut self, what: &str) -> Fault {
        let token = match self.peek() {
            Ok(token) => token,
            Err(fault) => return fault,
        };
        self.expected_at(token, what)
    }

    /// The same for a given token.
    pub(super) fn expected_at(&mut self, token: Token, what: &str) -> Fault {
        if token.kind == TokenKind::Bad {
            return Fault::reported();
        }
        if let TokenKind::Name(symbol) = token.kind
            && self.scopes.find(symbol).and_then(Place::get).is_some_and(|v| matches!(v, Value::Poisoned))
        {
            return Fault::reported();
        }
        let message = match token.kind {
            TokenKind::Name(symbol) if self.is_unknown_call(token) => {
                format!("there is no macro or function `{}`", self.name(symbol))
            }
            _ => format!("expected {what}, found {}", self.describe(token)),
        };
        let fault = self.error(token.span, message);
        match self.suggestion(token) {
            Some(help) => fault.help(help),
            None => fault,
        }
    }

    /// Whether a name that stands for nothing is called like a macro.
    fn is_unknown_call(&self, token: Token) -> bool {
        let TokenKind::Name(symbol) = token.kind else { return false };
        let text = self.sources.get(token.span.file).text();
        let after = text.get(token.span.end as usize..).unwrap_or_default();
        !self.scopes.is_bound(symbol) && after.trim_start().starts_with('(')
    }

    /// What a token is, for messages.
    pub fn describe(&self, token: Token) -> String {
        match token.kind {
            TokenKind::Word(word) => format!("`{}`", word.text()),
            TokenKind::Name(symbol) => {
                let name = self.symbols.name(symbol);
                let place = self
                    .place
                    .as_ref()
                    .filter(|_| self.ahead == Some(token))
                    .or_else(|| self.scopes.find(symbol));
                match place.and_then(Place::get) {
                    Some(value) => format!("`{name}`, {}", value.kind()),
                    None => format!("the unknown name `{name}`"),
                }
            }
            TokenKind::Number(_) => format!("the number `{}`", self.sources.text(token.span)),
            TokenKind::Vector(..) => "a vector".to_owned(),
            TokenKind::Text => "a string".to_owned(),
            TokenKind::Punct(Punct::Hash) => format!("`{}`", self.sources.text(token.span)),
            TokenKind::Punct(punct) => format!("`{}`", punct.text()),
            TokenKind::Bad => "no token".to_owned(),
            TokenKind::End => "the end of the scene".to_owned(),
        }
    }

    /// The help for a name nobody knows: a word or a name spelt like it.
    pub(super) fn suggestion(&mut self, token: Token) -> Option<String> {
        if self.dropped_hash.is_some_and(|hash| hash.to(token.span) != hash && hash.end <= token.span.start) {
            let text = self.sources.text(token.span);
            let hash = self.dropped_hash.take()?;
            if hash.file == token.span.file && self.sources.text(hash.after().to(token.span)).trim() == text {
                let words = crate::syntax::DIRECTIVES.iter().map(|(word, _)| *word);
                return Some(match closest(text, words) {
                    Some(word) => format!("there is no directive `#{text}`; did you mean `#{word}`?"),
                    None => format!("there is no directive `#{text}`"),
                });
            }
        }
        let symbol = match token.kind {
            TokenKind::Name(symbol) => symbol,
            TokenKind::Punct(punct) => return self.foreign_operator(token, punct).map(str::to_owned),
            _ => return None,
        };
        if self.scopes.is_bound(symbol) {
            return None;
        }
        // A loop can make the same mistake ten thousand times.
        if !self.suggested.insert(token.span) {
            return None;
        }
        let name = self.symbols.name(symbol).clone();
        let bound: Vec<_> = self.scopes.names().map(|known| self.symbols.name(known).clone()).collect();
        let mut known: Vec<&str> = Word::spellings().collect();
        known.extend(bound.iter().map(|name| &**name));
        closest(&name, known).map(|word| format!("did you mean `{word}`?"))
    }

    /// The help for operators of other languages.
    fn foreign_operator(&self, token: Token, punct: Punct) -> Option<&'static str> {
        let text = self.sources.get(token.span.file).text();
        let before = text.get(..token.span.start as usize).unwrap_or_default();
        Some(match punct {
            Punct::Equal if before.ends_with('=') => "there is no `==`: a single `=` compares",
            Punct::And if before.ends_with('&') => "there is no `&&`: a single `&` means and",
            Punct::Or if before.ends_with('|') => "there is no `||`: a single `|` means or",
            Punct::Caret => "there is no operator `^`: write `pow(A, B)`",
            Punct::Percent => "there is no operator `%`: write `mod(A, B)`",
            Punct::Apostrophe => "strings stand between double quotes",
            Punct::CloseBrace if self.depth <= 0 => {
                "no brace is open here: remove it, or look for one too many above"
            }
            _ => return None,
        })
    }

    /// The value of the name that was peeked, if `pick` has a use for it; it is then taken.
    ///
    /// `vm.accept_value(|value| match value { Value::Object(o) => Some(o.clone()), _ => None })`
    pub fn accept_value<T>(&mut self, pick: impl FnOnce(&Value) -> Option<T>) -> Result<Option<T>> {
        let token = self.peek()?;
        let TokenKind::Name(symbol) = token.kind else { return Ok(None) };
        let Some(place) = self.place.clone() else { return Ok(None) };
        let picked = place.look().and_then(|value| pick(&value));
        if picked.is_some() {
            self.note_use(symbol, token.span);
            self.take(token);
        }
        Ok(picked)
    }

    /// Whether a name comes next that stands for numbers; nothing is run to find out.
    pub(super) fn names_number(&mut self) -> bool {
        match self.peek_raw().kind {
            TokenKind::Name(symbol) => {
                self.ahead.is_none()
                    && self
                        .scopes
                        .find(symbol)
                        .and_then(Place::look)
                        .is_some_and(|value| matches!(*value, Value::Float(_) | Value::Vector3(_)))
            }
            _ => false,
        }
    }

    /// Whether the name that was peeked has a value with an error.
    fn is_poisoned(&self) -> bool {
        self.place.as_ref().and_then(Place::get).is_some_and(|value| matches!(value, Value::Poisoned))
    }

    fn is_macro(&self, symbol: Symbol) -> bool {
        let place = self.scopes.find(symbol).and_then(Place::look);
        place.is_some_and(|value| matches!(*value, Value::Macro(_)))
    }

    /// How a name is written.
    pub fn name(&self, symbol: Symbol) -> &str {
        self.symbols.name(symbol)
    }

    /// What a name stands for at present.
    pub fn lookup(&self, symbol: Symbol) -> Option<Value> {
        self.scopes.find(symbol)?.get()
    }

    /// Reads a FLOAT.
    pub fn read_float(&mut self) -> Result<f64> {
        Ok(self.read_sized(1, "a float")?.c[0])
    }

    /// Reads a FLOAT and cuts it to an integer, as POV-Ray converts.
    pub fn read_int(&mut self) -> Result<i32> {
        Ok(super::tuple::to_int(self.read_float()?))
    }

    /// Reads a VECTOR; a float is repeated.
    pub fn read_vector(&mut self) -> Result<DVec3> {
        let [x, y, z, ..] = self.read_sized(3, "a vector")?.c;
        Ok(DVec3::new(x, y, z))
    }

    /// Reads a UV vector; a float is repeated.
    pub fn read_uv(&mut self) -> Result<DVec2> {
        let [u, v, ..] = self.read_sized(2, "a vector of two components")?.c;
        Ok(DVec2::new(u, v))
    }

    /// Reads a VEC4; a float is repeated.
    pub fn read_vec4(&mut self) -> Result<DVec4> {
        let [x, y, z, t, _] = self.read_sized(4, "a vector of four components")?.c;
        Ok(DVec4::new(x, y, z, t))
    }

    /// Reads an ARITH expression that has to have at most `n` components, and fills it up to `n`.
    fn read_sized(&mut self, n: u8, what: &str) -> Result<Tuple> {
        let start = self.peek_raw();
        if let Some(tuple) = self.take_literal(start, n) {
            return Ok(tuple);
        }
        let start = start.span;
        let blocked = std::mem::replace(&mut self.blocked, false);
        let tuple = self.arith(n);
        self.blocked = blocked;
        self.fit(tuple?, n, what, start)
    }

    /// Takes the token that was peeked if it is all of an expression with at most `n` components: a number
    /// or vector before a comma, a brace, or another one. Most of what meshes and arrays consist of is that.
    #[inline]
    pub(super) fn take_literal(&mut self, token: Token, n: u8) -> Option<Tuple> {
        if !matches!(token.kind, TokenKind::Number(_) | TokenKind::Vector(..))
            || self.frame.pos >= self.frame.end
        {
            return None;
        }
        let tree = &self.frame.tree;
        if !matches!(
            tree.nodes[self.frame.pos].kind,
            NodeKind::Punct(Punct::Comma | Punct::CloseBrace) | NodeKind::Number(_) | NodeKind::Vector(..)
        ) {
            return None;
        }
        let tuple = match token.kind {
            TokenKind::Number(value) => Tuple::float(value).promoted(n),
            TokenKind::Vector(len, first) if len <= n => Tuple::new(tree.vector(len, first)).padded(n),
            _ => return None,
        };
        self.take(token);
        Some(tuple)
    }

    /// Checks that a tuple has at most `n` components, and fills it up to `n`.
    pub(super) fn fit(&mut self, tuple: Tuple, n: u8, what: &str, start: Span) -> Result<Tuple> {
        if tuple.n > n {
            let found = Value::from(tuple).kind();
            let fault = self.error(start.to(self.last), format!("expected {what}, found {found}"));
            return Err(match n {
                1 => fault.help("take one component, such as `.x`"),
                _ if tuple.n == 5 => {
                    fault.help("a color cannot stand for a vector; write its components, or declare a vector")
                }
                _ => fault.help(format!("write {n} components")),
            });
        }
        Ok(tuple.padded(n))
    }

    /// Whether the next token can start a numeric expression.
    pub fn at_number(&mut self) -> Result<bool> {
        let token = self.peek()?;
        Ok(match token.kind {
            TokenKind::Number(_) | TokenKind::Vector(..) => true,
            TokenKind::Punct(punct) => {
                matches!(punct, Punct::OpenParen | Punct::Less | Punct::Plus | Punct::Minus | Punct::Not)
            }
            TokenKind::Word(word) => super::builtin::is_numeric(word),
            TokenKind::Name(_) => match self.place.as_ref().and_then(|place| place.look()) {
                Some(value) => {
                    value.tuple().is_some() || matches!(*value, Value::Function(_) | Value::Spline(_))
                }
                None => false,
            },
            TokenKind::Text | TokenKind::Bad | TokenKind::End => false,
        })
    }

    /// Reads a BOOL: on unless a number follows, and then on if that is above zero.
    pub fn read_flag(&mut self) -> Result<bool> {
        Ok(if self.at_number()? { self.read_float()? > 0.0 } else { true })
    }

    /// Warns if a name is marked as deprecated.
    pub(super) fn note_use(&mut self, symbol: Symbol, span: Span) {
        if let Some(message) = self.scopes.deprecation(symbol) {
            let text = message.to_string();
            self.deprecated(span, text, "");
        }
    }
}
