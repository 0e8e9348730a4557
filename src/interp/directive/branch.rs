//! `#if`, `#ifdef`, `#ifndef`, `#switch` and what belongs to them, docs/spec/language.md 2.4,
//! 2.6 and 2.7.
//!
//! Arms are linked to each other, so leaving out an arm is a jump. Where the link is missing the
//! `#end` is in another file: then the arm is left out token by token.

use super::Open;
use crate::interp::stream::TokenKind;
use crate::interp::tuple::truth;
use crate::interp::value::Value;
use crate::interp::{Fault, Result, Vm, Word};
use crate::source::Span;
use crate::syntax::{Directive, NO_LINK, NodeKind, Punct, Symbol};

/// What kind of directive is open, and what its `#end` has to know.
#[derive(Debug)]
pub(in crate::interp) enum BlockKind {
    /// An arm of a conditional runs; whether it is the `#else`.
    Arm { last: bool },
    /// A clause of a `#switch` runs.
    Clause { link: u32 },
    /// `#while`: where the condition starts, and the turns so far.
    While { condition: usize, end: usize, turns: u64 },
    /// `#for`: the running name, its last value and step, where the body starts, and the turns so far.
    For { name: Symbol, last: f64, step: f64, body: usize, end: usize, turns: u64 },
}

impl BlockKind {
    fn is_loop(&self) -> bool {
        matches!(self, BlockKind::While { .. } | BlockKind::For { .. })
    }
}

impl Vm<'_> {
    /// `#if`, `#ifdef`, `#ifndef`, just read.
    pub(super) fn branch(&mut self, directive: Directive, link: u32, span: Span) -> Result<()> {
        let holds = self.condition(directive);
        self.choose(holds, link, span)
    }

    /// Goes on in the arm a condition asks for.
    pub(in crate::interp) fn choose(&mut self, holds: Result<bool>, link: u32, span: Span) -> Result<()> {
        let mut link = link;
        let mut holds = match holds {
            Ok(holds) => holds,
            Err(fault) => return self.give_up_block(fault, link, span),
        };
        let mut last = false;
        while !holds {
            let Some((directive, at, next)) = self.skip_to(link, span)? else {
                return Ok(());
            };
            link = next;
            match directive {
                Directive::Elseif => match self.condition(directive) {
                    Ok(value) => holds = value,
                    Err(fault) => return self.give_up_block(fault, link, span),
                },
                Directive::Else => (holds, last) = (true, true),
                Directive::End => return Ok(()),
                _ => return Err(self.stray(directive, at)),
            }
        }
        self.push_block(BlockKind::Arm { last }, span)
    }

    /// Leaves out a whole block because its condition has an error.
    fn give_up_block(&mut self, fault: Fault, link: u32, span: Span) -> Result<()> {
        self.settle(fault);
        self.ahead = None;
        self.skip_block(link, span)
    }

    /// Leaves out what remains of a block, its `#end` included.
    pub(super) fn skip_block(&mut self, link: u32, span: Span) -> Result<()> {
        let mut link = link;
        while let Some((directive, _, next)) = self.skip_to(link, span)? {
            link = next;
            if directive == Directive::End {
                break;
            }
        }
        Ok(())
    }

    /// Jumps behind the directive a link leads to; gives that directive, its place and its own
    /// link. `None` at the end of the scene, which is reported.
    fn skip_to(&mut self, link: u32, opener: Span) -> Result<Option<(Directive, Span, u32)>> {
        if link != NO_LINK {
            self.frame.pos = link as usize;
        } else if !self.skip_unlinked() {
            let word = self.sources.text(opener).to_owned();
            let fault = self.error(opener, format!("`{word}` without `#end`"));
            return Err(fault.help("add `#end` where its last arm ends"));
        }
        match self.node() {
            Some((node, span)) => {
                self.frame.pos += 1;
                match node.kind {
                    NodeKind::Directive(directive, next) => Ok(Some((directive, span, next))),
                    _ => Ok(None),
                }
            }
            None => Ok(None),
        }
    }

    /// Looks for the next directive of the current block, across the end of include files.
    fn skip_unlinked(&mut self) -> bool {
        let mut inner = 0;
        while let Some((node, _)) = self.node() {
            if let NodeKind::Directive(directive, link) = node.kind {
                if directive.opens() && link == NO_LINK {
                    inner += 1;
                } else if directive.opens() {
                    self.frame.pos = self.end_of(link as usize);
                } else if inner == 0 && (directive.continues() || directive == Directive::End) {
                    return true;
                } else if directive == Directive::End {
                    inner -= 1;
                }
            }
            self.frame.pos += 1;
        }
        false
    }

    /// The node of the `#end` a chain of arms leads to, or the end of the file.
    pub(in crate::interp) fn end_of(&self, link: usize) -> usize {
        let mut at = link;
        while let Some(node) = self.frame.tree.nodes.get(at) {
            match node.kind {
                NodeKind::Directive(Directive::End, _) => return at,
                NodeKind::Directive(_, next) if next != NO_LINK => at = next as usize,
                _ => break,
            }
        }
        self.frame.tree.nodes.len()
    }

    /// Reads the condition of a conditional.
    fn condition(&mut self, directive: Directive) -> Result<bool> {
        match directive {
            Directive::Ifdef | Directive::Ifndef => {
                let open = self.open_condition(directive)?;
                let found = self.read_defined(Word::Ifdef)?;
                self.close_paren(open)?;
                Ok(found == (directive == Directive::Ifdef))
            }
            _ => Ok(truth(self.condition_value(directive)?)),
        }
    }

    fn open_condition(&mut self, directive: Directive) -> Result<Span> {
        let token = self.next_raw();
        if token.kind != TokenKind::Punct(Punct::OpenParen) {
            let fault = self.expected_at(token, &format!("`(` after `#{}`", directive.text()));
            return Err(fault.help(format!("conditions stand in parentheses: `#{} (...)`", directive.text())));
        }
        Ok(token.span)
    }

    /// Reads the float in parentheses after a directive.
    pub(super) fn condition_value(&mut self, directive: Directive) -> Result<f64> {
        let open = self.open_condition(directive)?;
        self.blocked = true;
        let start = self.peek_raw().span;
        let value = self.full(1)?;
        let value = self.fit(value, 1, "a float", start)?.c[0];
        if self.operator()? != Some(Punct::CloseParen) {
            let token = self.peek_raw();
            return Err(self.expected_at(token, "`)`").see(open, "to close this"));
        }
        self.next_raw();
        self.blocked = false;
        Ok(value)
    }

    /// `#elseif`, `#else`, `#case`, `#range`: the end of the arm that ran.
    pub(in crate::interp) fn next_arm(&mut self, directive: Directive, link: u32, span: Span) -> Result<()> {
        if self.blocks.len() <= self.frame.blocks && self.in_macro() {
            return Err(self.stray(directive, span));
        }
        let Some(open) = self.blocks.last_mut() else { return Err(self.stray(directive, span)) };
        let opener = open.span;
        match (&mut open.kind, directive) {
            (BlockKind::Arm { last: false }, Directive::Elseif | Directive::Else) => {
                self.pop_block();
                self.skip_block(link, opener)
            }
            (BlockKind::Arm { last: true }, Directive::Elseif | Directive::Else) => {
                let word = directive.text();
                let fault = self.error(span, format!("`#{word}` after `#else`"));
                self.settle(fault.see(opener, "of this directive").help("`#else` is the last arm"));
                self.pop_block();
                self.skip_block(link, opener)
            }
            // One clause runs on into the next, until `#break`.
            (BlockKind::Clause { link: next }, Directive::Else) => {
                *next = link;
                Ok(())
            }
            (BlockKind::Clause { link: next }, Directive::Case | Directive::Range) => {
                *next = link;
                self.clause_holds(directive, 0.0).map(|_| ())
            }
            _ => Err(self.stray(directive, span)),
        }
    }

    /// The error for a directive whose partner is missing.
    pub(super) fn stray(&mut self, directive: Directive, span: Span) -> Fault {
        let word = directive.text();
        let partner = match directive {
            Directive::Case | Directive::Range => "`#switch`",
            Directive::End => "a directive to end",
            _ => "`#if`",
        };
        let fault = self.error(span, format!("`#{word}` without {partner}"));
        match self.blocks.last().map(|open| open.span) {
            Some(open) => fault.see(open, "the directive that is open here"),
            None => fault.help(format!("remove it, or add {partner} before it")),
        }
    }

    /// `#switch`, just read.
    pub(super) fn switch(&mut self, link: u32, span: Span) -> Result<()> {
        let value = match self.condition_value(Directive::Switch) {
            Ok(value) => value,
            Err(fault) => return self.give_up_block(fault, link, span),
        };
        let first = self.node().map(|(node, _)| node.kind);
        if !matches!(first, Some(NodeKind::Directive(Directive::Case | Directive::Range, _))) {
            return self.late_clause(link, span, value);
        }
        self.find_clause(link, span, value)
    }

    /// Directives and macros that leave no tokens may stand before the first `#case`.
    fn late_clause(&mut self, link: u32, span: Span, value: f64) -> Result<()> {
        loop {
            match self.node() {
                Some((node, at)) => match node.kind {
                    NodeKind::Directive(Directive::Case | Directive::Range, _) => {
                        return self.find_clause(link, span, value);
                    }
                    NodeKind::Directive(directive, next)
                        if !directive.continues() && !matches!(directive, Directive::End) =>
                    {
                        self.frame.pos += 1;
                        self.run(directive, next, at)?;
                    }
                    NodeKind::Word(symbol) if matches!(self.lookup(symbol), Some(Value::Macro(_))) => {
                        self.frame.pos += 1;
                        self.resolve(symbol, at)?;
                    }
                    _ => {
                        let fault = self.error(at, "`#switch` has to be followed by `#case` or `#range`");
                        self.settle(fault.see(span, "this `#switch`"));
                        return self.skip_block(link, span);
                    }
                },
                None => return Err(self.error(span, "`#switch` without `#end`")),
            }
        }
    }

    fn find_clause(&mut self, link: u32, span: Span, value: f64) -> Result<()> {
        let mut link = link;
        loop {
            let Some((directive, _, next)) = self.skip_to(link, span)? else { return Ok(()) };
            link = next;
            let holds = match directive {
                Directive::Case | Directive::Range => match self.clause_holds(directive, value) {
                    Ok(holds) => holds,
                    Err(fault) => return self.give_up_block(fault, link, span),
                },
                Directive::Else => true,
                _ => return Ok(()),
            };
            if holds {
                return self.push_block(BlockKind::Clause { link }, span);
            }
        }
    }

    /// Reads the value of `#case` or the two of `#range`, and compares.
    fn clause_holds(&mut self, directive: Directive, value: f64) -> Result<bool> {
        if directive == Directive::Case {
            return Ok((self.condition_value(directive)? - value).abs() < 1e-10);
        }
        let open = self.open_condition(directive)?;
        let low = self.read_float()?;
        self.comma()?;
        let high = self.read_float()?;
        self.close_paren(open)?;
        Ok(low <= value && value <= high)
    }

    /// `#break`.
    pub(super) fn break_out(&mut self, span: Span) -> Result<()> {
        loop {
            if self.blocks.len() <= self.frame.blocks && self.in_macro() {
                self.frame.pos = self.frame.end;
                return Ok(());
            }
            match self.pop_block().map(|open| (open.kind, open.span)) {
                Some((BlockKind::Arm { .. }, _)) => {}
                Some((BlockKind::While { end, .. } | BlockKind::For { end, .. }, _)) => {
                    self.frame.pos = end + 1;
                    return Ok(());
                }
                Some((BlockKind::Clause { link }, opener)) => return self.skip_block(link, opener),
                None => {
                    let fault = self.error(span, "`#break` outside of a loop, `#case` or macro");
                    return Err(fault.help(
                        "it leaves `#while`, `#for`, a `#case` or a macro; an `#if` alone is none of these",
                    ));
                }
            }
        }
    }

    /// `#end` of whatever is open.
    pub(super) fn end(&mut self, span: Span) -> Result<()> {
        if self.blocks.len() <= self.frame.blocks && self.in_macro() {
            return Err(self.stray(Directive::End, span));
        }
        let Some(open) = self.blocks.last() else { return Err(self.stray(Directive::End, span)) };
        match open.kind {
            BlockKind::Arm { .. } | BlockKind::Clause { .. } => {
                self.pop_block();
                Ok(())
            }
            BlockKind::While { .. } => self.end_while(),
            BlockKind::For { .. } => self.end_for(),
        }
    }

    fn in_macro(&self) -> bool {
        self.frame.entered.is_some_and(|entered| entered.name.is_some())
    }

    /// Opens a block that some `#end` will close.
    pub(in crate::interp) fn push_block(&mut self, kind: BlockKind, span: Span) -> Result<()> {
        if self.blocks.len() >= crate::interp::limits::MOST_BLOCKS {
            return Err(self.fatal(span, "too many directives are open inside each other"));
        }
        self.loops += u32::from(kind.is_loop());
        self.blocks.push(Open { kind, span, since: self.effort.steps() });
        Ok(())
    }

    /// Closes the innermost block.
    pub(in crate::interp) fn pop_block(&mut self) -> Option<Open> {
        let open = self.blocks.pop()?;
        self.loops -= u32::from(open.kind.is_loop());
        Some(open)
    }
}
