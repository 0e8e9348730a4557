//! Strings in compiled expressions: what builds one appends to a buffer, so joining costs nothing.

use super::compile::Compiler;
use crate::interp::Word;
use crate::interp::code::{Op, TextOp};
use crate::interp::value::Value;
use crate::source::Span;
use crate::syntax::{NodeKind, Punct};

impl Compiler<'_, '_> {
    /// Compiles a string: a plain literal, the name of one, `concat`, `str`, or `chr`.
    pub(super) fn text(&mut self) -> Option<()> {
        self.enter_macros()?;
        let kind = self.kind()?;
        self.at += 1;
        match kind {
            NodeKind::Text => {
                let node = self.code.nodes[self.at - 1];
                let span = Span { file: self.code.file, start: node.start, end: node.end };
                let text = self.vm.sources.text(span);
                let inner = &text[1..text.len() - 1];
                (inner.is_ascii() && !inner.contains('\\')).then_some(())?;
                self.ops.push(Op::Text(TextOp::Literal(self.texts.len() as u16)));
                self.texts.push(inner.into());
                u16::try_from(self.texts.len()).ok().map(drop)
            }
            NodeKind::Word(symbol) => match Word::of(symbol) {
                Some(word) => self.deeper(|compiler| compiler.text_call(word)),
                None if self.find_bound(symbol).is_some() => None,
                None => {
                    let place = self.vm.scopes.find(symbol)?;
                    matches!(place.look().as_deref(), Some(Value::Text(_))).then_some(())?;
                    self.ops.push(Op::Text(TextOp::Load(symbol)));
                    Some(())
                }
            },
            _ => None,
        }
    }

    fn text_call(&mut self, word: Word) -> Option<()> {
        self.skip(Punct::OpenParen)?;
        match word {
            Word::Concat => {
                self.text()?;
                loop {
                    let _: Option<()> = self.skip(Punct::Comma);
                    if self.punct() == Some(Punct::CloseParen) {
                        break;
                    }
                    self.text()?;
                }
            }
            Word::Str => {
                self.arguments(3)?;
                self.ops.push(Op::Text(TextOp::Str));
            }
            Word::Chr => {
                self.arguments(1)?;
                self.ops.push(Op::Text(TextOp::Chr));
            }
            _ => return None,
        }
        self.skip(Punct::CloseParen)
    }

    /// Compiles a float that is computed from strings.
    pub(super) fn measure(&mut self, word: Word) -> Option<()> {
        let op = match word {
            Word::Strlen => TextOp::Strlen,
            Word::Strcmp => TextOp::Strcmp,
            Word::Val => TextOp::Val,
            _ => return None,
        };
        self.ops.push(Op::Text(TextOp::Mark));
        self.text()?;
        if word == Word::Strcmp {
            let _: Option<()> = self.skip(Punct::Comma);
            self.ops.push(Op::Text(TextOp::Mark));
            self.text()?;
        }
        self.ops.push(Op::Text(op));
        self.skip(Punct::CloseParen)
    }
}
