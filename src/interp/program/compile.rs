//! Compiling expressions: the grammar of `expr`, over nodes, with sizes known.
//!
//! Whatever is rare is left to `expr`: then there is no program.

use super::inline::Bound;
use super::machine::fits;
use crate::interp::builtin::{self, float};
use crate::interp::code::{Assignment, Code, Macro, Op, Program};
use crate::interp::expr::{comparison, component};
use crate::interp::scope::Place;
use crate::interp::tuple::test;
use crate::interp::value::Value;
use crate::interp::{Vm, Word};
use crate::syntax::{Directive, NodeKind, Punct, Symbol};
use std::cell::Cell;
use std::rc::Rc;

/// Parentheses inside each other that are worth compiling.
const DEEPEST: u32 = 30;
/// What is asked for where a color in braces is.
pub(super) const COLOR: (bool, u8) = (true, 0);

impl Vm<'_> {
    /// Compiles the expression at a node, if it is of the plain kind.
    pub(super) fn compile(&self, at: usize, asked: (bool, u8)) -> Option<Program> {
        if asked == COLOR {
            return self.compile_color(at);
        }
        let mut compiler = Compiler::new(self, at);
        let n = if asked.0 { compiler.full(asked.1)? } else { compiler.arith(asked.1)? };
        let end = compiler.end()?;
        // What follows must not turn out to continue the expression once it has run.
        let ends = match compiler.kind()? {
            NodeKind::Punct(punct) => punct != Punct::Hash,
            NodeKind::Number(_) | NodeKind::Vector(..) | NodeKind::Text => true,
            NodeKind::Word(symbol) => Word::of(symbol).is_some(),
            NodeKind::Directive(..) | NodeKind::Error(_) => self.blocked,
        };
        if ends && end > at { compiler.program(end, n, asked) } else { None }
    }

    /// Compiles a `{ rgb … }` at a node, which may say `color` too.
    fn compile_color(&self, at: usize) -> Option<Program> {
        let mut compiler = Compiler::new(self, at);
        compiler.skip(Punct::OpenBrace)?;
        let mut word = compiler.reserved()?;
        if matches!(word, Word::Color | Word::Colour) {
            word = compiler.reserved()?;
        }
        (word == Word::Rgb && compiler.full(3)? == 3).then_some(())?;
        compiler.skip(Punct::CloseBrace)?;
        let end = compiler.end()?;
        compiler.program(end, 3, COLOR)
    }

    /// Compiles the `#declare` or `#local` at a node, if its value is numbers or a string.
    pub(super) fn compile_declaration(&self, at: usize) -> Option<Assignment> {
        let mut compiler = Compiler::new(self, at);
        let NodeKind::Directive(directive, _) = compiler.kind()? else { return None };
        let local = directive == Directive::Local;
        compiler.at += 1;
        let name = compiler.target()?;
        let mut subscripts = 0;
        if compiler.punct() == Some(Punct::OpenBracket) {
            let place = self.scopes.find(name)?;
            let Some(Value::Array(array)) = place.look().as_deref().cloned() else { return None };
            subscripts = array.sizes.len() as u8;
            for _ in 0..subscripts {
                compiler.subscript()?;
            }
        }
        compiler.skip(Punct::Equal)?;
        compiler.enter_macros()?;
        let n = if compiler.at_text() {
            compiler.text()?;
            // No semicolon is needed here, and one is taken.
            let _: Option<()> = compiler.skip(Punct::Semicolon);
            0
        } else {
            compiler.starts_value = true;
            let n = compiler.arith(1)?;
            compiler.semicolons()?;
            n
        };
        let end = compiler.end()?;
        Some(Assignment { name, local, subscripts, program: compiler.program(end, n, (false, 1))? })
    }
}

pub(super) struct Compiler<'a, 'b> {
    pub(super) vm: &'a Vm<'b>,
    pub(super) code: Rc<Code>,
    /// The next node of the code, and where it ends.
    pub(super) at: usize,
    pub(super) stop: usize,
    pub(super) depth: u32,
    pub(super) ops: Vec<Op>,
    /// Where to go on after the macros it is in: code, node, end, and how many names were bound.
    pub(super) outer: Vec<(Rc<Code>, usize, usize, usize)>,
    /// Arguments and local names of those macros.
    pub(super) bound: Vec<Bound>,
    pub(super) calls: Vec<(Symbol, Rc<Macro>)>,
    pub(super) texts: Vec<Box<str>>,
    pub(super) places: u16,
    /// A value of any kind may stand here, in which `t` has another meaning.
    pub(super) starts_value: bool,
}

/// The methods give the size of what they compiled.
impl<'a, 'b> Compiler<'a, 'b> {
    fn new(vm: &'a Vm<'b>, at: usize) -> Compiler<'a, 'b> {
        Compiler {
            vm,
            code: Rc::clone(&vm.frame.tree),
            at,
            stop: vm.frame.end,
            depth: 0,
            ops: Vec::new(),
            outer: Vec::new(),
            bound: Vec::new(),
            calls: Vec::new(),
            texts: Vec::new(),
            places: 0,
            starts_value: false,
        }
    }

    fn program(self, end: usize, n: u8, asked: (bool, u8)) -> Option<Program> {
        fits(&self.ops, self.places).then_some(())?;
        let (ops, calls) = (self.ops.into_boxed_slice(), self.calls.into_boxed_slice());
        let texts = self.texts.into_boxed_slice();
        Some(Program { ops, end, n, asked, calls, texts, places: self.places, failures: Cell::new(0) })
    }

    /// The node after what was compiled, if that is not in a macro.
    fn end(&mut self) -> Option<usize> {
        self.leave_macros();
        self.outer.is_empty().then_some(self.at)
    }

    pub(super) fn kind(&mut self) -> Option<NodeKind> {
        self.leave_macros();
        (self.at < self.stop).then(|| self.code.nodes[self.at].kind)
    }

    pub(super) fn punct(&mut self) -> Option<Punct> {
        match self.kind()? {
            NodeKind::Punct(punct) => Some(punct),
            _ => None,
        }
    }

    pub(super) fn skip(&mut self, punct: Punct) -> Option<()> {
        let found = self.punct()? == punct;
        self.at += usize::from(found);
        found.then_some(())
    }

    /// Whether a string that is no name begins here.
    fn at_text(&mut self) -> bool {
        match self.kind() {
            Some(NodeKind::Text) => true,
            Some(NodeKind::Word(symbol)) => Word::of(symbol).is_some_and(builtin::string::is_function),
            _ => false,
        }
    }

    fn reserved(&mut self) -> Option<Word> {
        let NodeKind::Word(symbol) = self.kind()? else { return None };
        self.at += 1;
        Word::of(symbol)
    }

    fn subscript(&mut self) -> Option<()> {
        self.skip(Punct::OpenBracket)?;
        (self.deeper(|compiler| compiler.arith(1))? == 1).then_some(())?;
        self.skip(Punct::CloseBracket)
    }

    fn promote(&mut self, size: u8, n: u8) -> u8 {
        if size != 1 || n <= 1 {
            return size;
        }
        self.ops.push(Op::Repeat(n));
        n
    }

    fn full(&mut self, n: u8) -> Option<u8> {
        let size = self.logic(n)?;
        if self.punct() != Some(Punct::Question) {
            return Some(size);
        }
        self.at += 1;
        // The condition alone may be promoted, which only its first component survives.
        if size != 1 {
            return None;
        }
        let yes = self.full(n)?;
        self.skip(Punct::Colon)?;
        let no = self.full(n)?;
        self.ops.push(Op::Choose(yes));
        (yes == no).then_some(yes)
    }

    fn logic(&mut self, n: u8) -> Option<u8> {
        let mut size = self.relation(n)?;
        loop {
            let f = match self.punct() {
                Some(Punct::And) => test::and,
                Some(Punct::Or) => test::or,
                _ => return Some(size),
            };
            self.at += 1;
            let right = self.relation(size)?;
            size = self.zip(f, size, right)?;
        }
    }

    fn relation(&mut self, n: u8) -> Option<u8> {
        let mut size = self.arith(n)?;
        while let Some(f) = self.punct().and_then(comparison) {
            self.at += 1;
            let right = self.arith(size)?;
            size = self.zip(f, size, right)?;
        }
        Some(size)
    }

    pub(super) fn arith(&mut self, n: u8) -> Option<u8> {
        let mut size = self.term(n)?;
        loop {
            let f: fn(f64, f64) -> f64 = match self.punct() {
                Some(Punct::Plus) => |a, b| a + b,
                Some(Punct::Minus) => |a, b| a - b,
                _ => return Some(size),
            };
            self.at += 1;
            let right = self.term(size)?;
            size = self.zip(f, size, right)?;
        }
    }

    fn term(&mut self, n: u8) -> Option<u8> {
        let mut size = self.factor(n)?;
        loop {
            let star = match self.punct() {
                Some(Punct::Star) => true,
                Some(Punct::Slash) => false,
                _ => return Some(size),
            };
            self.at += 1;
            let right = self.factor(size)?;
            size = if star {
                self.zip(|a, b| a * b, size, right)?
            } else {
                self.ops.push(Op::Divide(size, right));
                (size == right || size == 1).then_some(right)?
            };
        }
    }

    fn zip(&mut self, f: fn(f64, f64) -> f64, left: u8, right: u8) -> Option<u8> {
        self.ops.push(match (left, right) {
            (1, 1) => Op::Both(f),
            (left, right) if left == right => Op::Zip(f, left),
            (1, right) => Op::Spread(f, right),
            _ => return None,
        });
        Some(right)
    }

    fn factor(&mut self, n: u8) -> Option<u8> {
        self.enter_macros()?;
        let starts_value = std::mem::take(&mut self.starts_value);
        let f: Option<fn(f64) -> f64> = match self.punct() {
            Some(Punct::Plus) => None,
            Some(Punct::Minus) => Some(|a| -a),
            Some(Punct::Not) => Some(test::not),
            _ => {
                let size = self.primary(n, starts_value)?;
                return if self.punct() == Some(Punct::Point) { self.member(size, n) } else { Some(size) };
            }
        };
        self.at += 1;
        let size = self.deeper(|compiler| compiler.factor(n))?;
        if let Some(f) = f {
            self.ops.push(Op::Each(f, size));
        }
        Some(size)
    }

    fn member(&mut self, size: u8, n: u8) -> Option<u8> {
        self.at += 1;
        let NodeKind::Word(symbol) = self.kind()? else { return None };
        let index = component(Word::of(symbol)?)?;
        self.at += 1;
        self.ops.push(Op::Member(index as u8, size));
        (index < usize::from(size)).then(|| self.promote(1, n))
    }

    fn primary(&mut self, n: u8, starts_value: bool) -> Option<u8> {
        let kind = self.kind()?;
        self.at += 1;
        match kind {
            NodeKind::Number(index) => {
                self.ops.push(Op::Number(self.code.numbers[index as usize]));
                Some(self.promote(1, n))
            }
            NodeKind::Vector(len, first) => {
                self.ops.extend(self.code.vector(len, first).iter().map(|&value| Op::Number(value)));
                Some(len)
            }
            NodeKind::Punct(Punct::OpenParen) => {
                let size = self.deeper(|compiler| compiler.full(n))?;
                self.skip(Punct::CloseParen)?;
                Some(size)
            }
            NodeKind::Punct(Punct::Less) => self.deeper(Compiler::vector),
            NodeKind::Word(symbol) => match Word::of(symbol) {
                None => self.named(symbol, n),
                Some(Word::T) if starts_value => None,
                Some(word) => match builtin::constant(word) {
                    Some(value) => {
                        self.ops.extend(value.components().iter().map(|&value| Op::Number(value)));
                        Some(self.promote(value.n, n))
                    }
                    None => {
                        self.deeper(|compiler| compiler.call(word))?;
                        Some(self.promote(1, n))
                    }
                },
            },
            _ => None,
        }
    }

    fn vector(&mut self) -> Option<u8> {
        let mut size = 0;
        while self.skip(Punct::Greater).is_none() {
            if size == 5 || self.arith(1)? != 1 {
                return None;
            }
            size += 1;
            // Commas are optional.
            let _: Option<()> = self.skip(Punct::Comma);
        }
        (size >= 2).then_some(size)
    }

    fn named(&mut self, symbol: Symbol, n: u8) -> Option<u8> {
        if let Some(bound) = self.find_bound(symbol) {
            let (size, place) = (bound.size, bound.place);
            self.ops.push(Op::Kept(size, place));
            return Some(self.promote(size, n));
        }
        let Place::Variable(cell) = self.vm.scopes.find(symbol)? else {
            let size = self.vm.lookup(symbol)?.tuple()?.n;
            self.ops.push(Op::Load(symbol, size));
            return Some(self.promote(size, n));
        };
        let value = cell.borrow();
        let size = match &*value {
            Value::Array(array) => {
                let size = array.sample()?.tuple()?.n;
                for _ in &array.sizes {
                    self.subscript()?;
                }
                self.ops.push(Op::Element(symbol, array.sizes.len() as u8, size));
                size
            }
            value => {
                let size = value.tuple()?.n;
                self.ops.push(Op::Load(symbol, size));
                size
            }
        };
        Some(self.promote(size, n))
    }

    fn call(&mut self, word: Word) -> Option<()> {
        self.skip(Punct::OpenParen)?;
        let op = match word {
            Word::Strlen | Word::Strcmp | Word::Val => return self.measure(word),
            Word::Rand => Op::Rand,
            Word::Select => {
                self.arguments(4)?;
                Op::Select
            }
            _ => match float::pure(word)? {
                float::Pure::One(f) => Op::Each(f, 1),
                float::Pure::OneChecked(f) => Op::Checked(f),
                float::Pure::Two(f) => Op::Both(f),
                float::Pure::TwoChecked(f) => Op::CheckedBoth(f),
                float::Pure::Fold(f) => {
                    self.fold(f)?;
                    return self.skip(Punct::CloseParen);
                }
            },
        };
        match op {
            Op::Select => {}
            Op::Both(_) | Op::CheckedBoth(_) => self.arguments(2)?,
            _ => (self.full(1)? == 1).then_some(())?,
        }
        self.ops.push(op);
        self.skip(Punct::CloseParen)
    }

    /// So many floats with optional commas between them. `select` of three takes its last for two.
    pub(super) fn arguments(&mut self, count: usize) -> Option<()> {
        for given in 0..count {
            if given > 0 {
                let comma = self.skip(Punct::Comma);
                if given == 3 && comma.is_none() {
                    return None;
                }
            }
            (self.arith(1)? == 1).then_some(())?;
        }
        Some(())
    }

    fn fold(&mut self, f: fn(f64, f64) -> f64) -> Option<()> {
        (self.arith(1)? == 1).then_some(())?;
        while self.skip(Punct::Comma).is_some() {
            (self.arith(1)? == 1).then_some(())?;
            self.ops.push(Op::Both(f));
        }
        Some(())
    }

    pub(super) fn deeper<T>(&mut self, read: impl FnOnce(&mut Self) -> Option<T>) -> Option<T> {
        self.depth += 1;
        let result = if self.depth > DEEPEST { None } else { read(self) };
        self.depth -= 1;
        result
    }
}
