//! `#fopen`, `#fclose`, `#read`, `#write`, docs/spec/language.md 2.13.

use crate::interp::file::FileHandle;
use crate::interp::format::general;
use crate::interp::scope::Place;
use crate::interp::stream::TokenKind;
use crate::interp::tuple::Tuple;
use crate::interp::value::Value;
use crate::interp::{Fault, Result, Vm, Word};
use crate::source::{FileKind, Source, Span};
use crate::syntax::{NodeKind, Punct, Symbol, Tree, parse};
use std::cell::{Cell, RefCell};
use std::io::{BufWriter, Write};
use std::rc::Rc;

/// Bytes that are written in the time of a step.
const BYTES_A_STEP: u64 = 16;

impl Vm<'_> {
    /// `#fopen`, just read.
    pub(super) fn open_file(&mut self) -> Result<()> {
        let token = self.next_raw();
        let TokenKind::Name(symbol) = token.kind else {
            return Err(self.expected_at(token, "a name for the file"));
        };
        if let Some(value) = self.lookup(symbol) {
            let name = self.symbols.name(symbol).clone();
            let fault = self.error(token.span, format!("`{name}` is {} already", value.kind()));
            return Err(fault.help("a file handle needs a name of its own; `#fclose` an open one first"));
        }
        let start = self.peek()?.span;
        let name = self.read_file_name()?;
        let place = start.to(self.last);
        let mode = self.peek()?;
        let handle = match mode.kind {
            TokenKind::Word(Word::Read) => self.open_for_reading(&name, place)?,
            TokenKind::Word(word @ (Word::Write | Word::Append)) => {
                match self.sources.library.create(&name, word == Word::Append) {
                    Ok(file) => FileHandle::Write(RefCell::new(BufWriter::new(file))),
                    Err(error) => return Err(self.error(place, format!("cannot write to `{name}`: {error}"))),
                }
            }
            _ => return Err(self.expected("`read`, `write` or `append`")),
        };
        self.take(mode);
        self.scopes.bind_global(symbol, Place::new(Value::File(Rc::new(handle))));
        Ok(())
    }

    fn open_for_reading(&mut self, name: &str, place: Span) -> Result<FileHandle> {
        let (path, bytes) = match self.sources.library.open(name, FileKind::Other(&[])) {
            Ok(found) => found,
            Err(missing) => return Err(self.missing_file(name, place, missing)),
        };
        let file = self.sources.add(Source::new(name, path, bytes));
        let tree = parse(file, self.sources.get(file), &mut self.symbols);
        Ok(FileHandle::Read(Rc::new(tree), Cell::new(0)))
    }

    /// `#fclose`, just read. What is no file is left alone.
    pub(super) fn close_file(&mut self) -> Result<()> {
        let token = self.next_raw();
        let TokenKind::Name(symbol) = token.kind else {
            return Err(self.expected_at(token, "the name of a file"));
        };
        match self.lookup(symbol) {
            Some(Value::File(handle)) => {
                self.scopes.unbind(symbol);
                self.flush(&handle, token.span)
            }
            _ => Ok(()),
        }
    }

    fn flush(&mut self, handle: &FileHandle, span: Span) -> Result<()> {
        let FileHandle::Write(file) = handle else { return Ok(()) };
        let written = file.borrow_mut().flush();
        written.map_err(|error| self.error(span, format!("cannot write to this file: {error}")))
    }

    fn read_handle(&mut self) -> Result<(Symbol, Rc<FileHandle>, Span)> {
        let token = self.peek()?;
        let TokenKind::Name(symbol) = token.kind else {
            return Err(self.expected("the name of an open file"));
        };
        match self.lookup(symbol) {
            Some(Value::File(handle)) => {
                self.take(token);
                Ok((symbol, handle, token.span))
            }
            _ => Err(self.expected("the name of an open file").help("open it with `#fopen` first")),
        }
    }

    /// `#write`, just read.
    pub(super) fn write_file(&mut self, span: Span) -> Result<()> {
        let open = self.expect(Punct::OpenParen)?;
        let (_, handle, at) = self.read_handle()?;
        let FileHandle::Write(file) = &*handle else {
            return Err(self
                .error(at, "this file was opened for reading")
                .help("open it with `write` or `append`"));
        };
        let mut bytes = Vec::new();
        self.comma()?;
        while self.peek()?.kind != TokenKind::Punct(Punct::CloseParen) {
            if let TokenKind::Word(word) = self.peek()?.kind
                && let Some((size, signed, big)) = layout(word)
            {
                self.next()?;
                while self.at_number()? {
                    let value = self.arith(1)?;
                    value.components().iter().for_each(|&c| bytes.extend(encode(c, size, signed, big)));
                }
            } else if self.at_string()? {
                let text = self.read_string()?;
                bytes.extend(text.chars().map(|c| if c.is_ascii() { c as u8 } else { b' ' }));
            } else if self.at_color()? {
                let fault = self.expected("a string or an expression");
                return Err(fault.help("a color cannot be written as it is; multiply it: `1*Color`"));
            } else {
                bytes.extend(text_of(self.arith(1)?).bytes());
            }
            self.comma()?;
        }
        self.close_paren(open)?;
        self.work(bytes.len() as u64 / BYTES_A_STEP, span)?;
        let written = file.borrow_mut().write_all(&bytes);
        written.map_err(|error| self.error(span, format!("cannot write to this file: {error}")))
    }

    /// `#read`, just read.
    pub(super) fn read_file(&mut self, span: Span) -> Result<()> {
        let open = self.expect(Punct::OpenParen)?;
        let (symbol, handle, at) = self.read_handle()?;
        let FileHandle::Read(tree, position) = &*handle else {
            return Err(self.error(at, "this file was opened for writing").help("open it with `read`"));
        };
        let mut ended = false;
        self.comma()?;
        while self.peek()?.kind != TokenKind::Punct(Punct::CloseParen) {
            let target = self.read_destination()?;
            self.comma()?;
            if ended {
                continue;
            }
            let mut data = Data { tree, at: position.get() };
            let item = data.item(self);
            // The token after an item is lost, comma or not.
            ended = matches!(item, Ok(None)) || data.skip();
            position.set(data.at);
            if let Some(value) = item.map_err(|fault| fault.see(span, "read here"))? {
                self.made_something();
                match target {
                    Ok(place) => place.set(value).map_err(|message| self.error(at, message))?,
                    Err(name) => self.scopes.bind_global(name, Place::new(value)),
                }
            }
        }
        self.close_paren(open)?;
        if ended {
            self.scopes.unbind(symbol);
        }
        Ok(())
    }

    /// Reads where a datum goes: a place, or a name that is new.
    fn read_destination(&mut self) -> Result<std::result::Result<Place, Symbol>> {
        let token = self.peek()?;
        let TokenKind::Name(symbol) = token.kind else {
            return Err(self.expected("a variable to read into"));
        };
        let Some(place) = self.place.clone() else {
            self.take(token);
            return Ok(Err(symbol));
        };
        match place.get() {
            Some(Value::Float(_) | Value::Vector3(_) | Value::Text(_) | Value::Poisoned) => {
                self.take(token);
                Ok(Ok(place))
            }
            None => Err(self.unset_element(token.span)),
            Some(_) => Err(self.expected("a float, vector or string variable to read into")),
        }
    }
}

/// A file of data while it is read.
struct Data<'a> {
    tree: &'a Tree,
    at: usize,
}

impl Data<'_> {
    /// The next item; `None` at the end of the file.
    fn item(&mut self, vm: &mut Vm) -> Result<Option<Value>> {
        let Some(node) = self.tree.nodes.get(self.at) else { return Ok(None) };
        let span = self.tree.span(self.at);
        self.at += 1;
        match node.kind {
            NodeKind::Number(index) => Ok(Some(Value::Float(self.tree.numbers[index as usize]))),
            NodeKind::Punct(sign @ (Punct::Minus | Punct::Plus)) => {
                Ok(Some(Value::Float(self.signed(vm, sign)?)))
            }
            NodeKind::Vector(len, first) => Ok(Some(Tuple::new(self.tree.vector(len, first)).into())),
            NodeKind::Punct(Punct::Less) => self.vector(vm).map(Some),
            NodeKind::Text => vm.literal(span).map(|text| Some(Value::Text(text))),
            NodeKind::Error(index) => {
                let diagnostic = self.tree.errors[index as usize].clone();
                Err(Fault::from_diagnostic(diagnostic))
            }
            _ => Err(self.wrong(vm, self.at - 1)),
        }
    }

    fn signed(&mut self, vm: &mut Vm, sign: Punct) -> Result<f64> {
        match self.tree.nodes.get(self.at).map(|node| node.kind) {
            Some(NodeKind::Number(index)) => {
                self.at += 1;
                let value = self.tree.numbers[index as usize];
                Ok(if sign == Punct::Minus { -value } else { value })
            }
            _ => Err(self.wrong(vm, self.at)),
        }
    }

    /// A vector that is not one token: its commas are missing.
    fn vector(&mut self, vm: &mut Vm) -> Result<Value> {
        let mut components = Vec::new();
        loop {
            let kind = self.tree.nodes.get(self.at).map(|node| node.kind);
            match kind {
                Some(NodeKind::Number(index)) => components.push(self.tree.numbers[index as usize]),
                Some(NodeKind::Punct(sign @ (Punct::Minus | Punct::Plus))) => {
                    self.at += 1;
                    components.push(self.signed(vm, sign)?);
                    continue;
                }
                Some(NodeKind::Punct(Punct::Comma)) => {}
                Some(NodeKind::Punct(Punct::Greater)) if (2..=5).contains(&components.len()) => {
                    self.at += 1;
                    return Ok(Tuple::new(&components).into());
                }
                _ => return Err(self.wrong(vm, self.at)),
            }
            self.at += 1;
        }
    }

    /// Passes the token after an item; whether that was the end.
    fn skip(&mut self) -> bool {
        let ended = self.at >= self.tree.nodes.len();
        self.at += 1;
        ended
    }

    fn wrong(&self, vm: &mut Vm, at: usize) -> Fault {
        let fault = vm.error(self.tree.span(at), "a data file holds numbers, vectors of numbers and strings");
        fault.help("separate them with commas")
    }
}

/// The bytes, signedness and order behind `uint16be` and its kin.
fn layout(word: Word) -> Option<(u32, bool, bool)> {
    Some(match word {
        Word::Uint8 => (8, false, true),
        Word::Sint8 => (8, true, true),
        Word::Uint16be => (16, false, true),
        Word::Uint16le => (16, false, false),
        Word::Sint16be => (16, true, true),
        Word::Sint16le => (16, true, false),
        Word::Sint32be => (32, true, true),
        Word::Sint32le => (32, true, false),
        _ => return None,
    })
}

/// A number in so many bits, rounded and limited to what fits.
fn encode(value: f64, bits: u32, signed: bool, big: bool) -> Vec<u8> {
    let (low, high) =
        if signed { (-(1_i64 << (bits - 1)), (1_i64 << (bits - 1)) - 1) } else { (0, (1_i64 << bits) - 1) };
    let number = ((value + 0.5).floor() as i64).clamp(low, high);
    let mut bytes = number.to_le_bytes()[..bits as usize / 8].to_vec();
    if big {
        bytes.reverse();
    }
    bytes
}

/// Numbers as `#write` writes them.
fn text_of(tuple: Tuple) -> String {
    let parts: Vec<String> = tuple.components().iter().map(|&c| general(c, 6)).collect();
    if tuple.n == 1 { parts.join(",") } else { format!("<{}> ", parts.join(",")) }
}
