//! Counts what a run does, and stops a scene that would never be done.
//!
//! What counts is steps: directives, calls of macros, and what costs as much. A step that makes something
//! (a statement's block, a new element of an array, a datum read) starts the count of idle steps anew:
//! memory bounds that. Text and files do not: a loop can write for ever. A scene may be idle for
//! [`LanguageOptions::max_steps`](crate::options::LanguageOptions::max_steps) in a row, and longer while
//! its outermost loop that turns is seen to come to its end.

use super::code::Code;
use super::directive::BlockKind;
use super::value::Value;
use super::{Result, Vm};
use crate::source::Span;
use crate::syntax::{Node, NodeKind, Punct, Symbol};

/// How many times more steps are allowed in all than in a row without making anything.
const BUSY: u64 = 50;
/// Steps between two looks at the limits.
const UNNOTICED: u64 = 1024;

/// What a run has done.
#[derive(Debug, Default)]
pub(super) struct Effort {
    /// Steps so far.
    steps: u64,
    /// The steps at which something was last made.
    made: u64,
    /// The steps at which it is looked at the limits again.
    look: u64,
    /// Where the open loops were some time ago.
    marks: Option<Marks>,
}

/// Where the open loops were at some step.
#[derive(Debug)]
struct Marks {
    steps: u64,
    /// How far the scene and a file it includes were read.
    read: Vec<usize>,
    loops: Vec<Mark>,
}

/// Where a loop was.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Mark {
    /// The step at which it was entered.
    since: u64,
    /// Turns it had made.
    turns: u64,
    /// How far what it counts was from its end; `None` where that cannot be told.
    distance: Option<f64>,
}

impl Effort {
    /// The steps so far.
    pub(super) fn steps(&self) -> u64 {
        self.steps
    }
}

impl Vm<'_> {
    /// Notes that something was made.
    #[inline]
    pub(super) fn made_something(&mut self) {
        self.effort.made = self.effort.steps;
    }

    /// Counts so many steps; it is looked at the limits with the next.
    #[inline]
    pub(super) fn count(&mut self, steps: u64) {
        self.effort.steps = self.effort.steps.saturating_add(steps);
    }

    /// Counts so many steps.
    #[inline]
    pub(super) fn work(&mut self, steps: u64, span: Span) -> Result<()> {
        self.effort.steps = self.effort.steps.saturating_add(steps);
        if self.effort.steps < self.effort.look { Ok(()) } else { self.check_effort(span) }
    }

    /// Looks at the limits.
    #[cold]
    fn check_effort(&mut self, span: Span) -> Result<()> {
        let steps = self.effort.steps;
        self.effort.look = steps + UNNOTICED;
        self.check_memory(0, span)?;
        let most = self.options.max_steps;
        let all = most.saturating_mul(BUSY);
        let idle = steps - self.effort.made;
        let message = if steps > all {
            format!("still not done after {all} steps")
        } else if idle <= most / 2 {
            return Ok(());
        } else if self.effort.marks.as_ref().is_none_or(|marks| marks.steps <= self.effort.made) {
            self.mark_loops();
            return Ok(());
        } else if idle <= most {
            return Ok(());
        } else if self.steps_left().is_some_and(|left| steps as f64 + left <= all as f64) {
            // Half of the time is left for the next look.
            self.effort.made = steps - most / 2;
            self.mark_loops();
            return Ok(());
        } else {
            format!("loops and macros went on for {most} steps here without making anything")
        };
        let fault = self.fatal(span, message).label("what was running");
        Err(fault.help("does it ever end? otherwise allow more with `--max-steps`"))
    }

    fn mark_loops(&mut self) {
        let loops = self.marks().collect();
        self.effort.marks = Some(Marks { steps: self.effort.steps, read: self.positions(), loops });
    }

    /// How far the scene and a file it includes are read: what is not repeated comes to its end.
    fn positions(&self) -> Vec<usize> {
        let frames = self.frames.iter().chain(std::iter::once(&self.frame));
        let files = frames.take_while(|frame| frame.entered.is_none_or(|entered| entered.name.is_none()));
        files.take(2).map(|frame| frame.pos).collect()
    }

    /// Where the open loops are, the outermost first.
    fn marks(&self) -> impl Iterator<Item = Mark> {
        self.blocks.iter().enumerate().filter_map(|(index, open)| {
            let (turns, distance) = match &open.kind {
                BlockKind::While { turns, condition, .. } => {
                    let inside = self.frames.iter().rev().find(|frame| frame.blocks <= index);
                    let frame = if self.frame.blocks <= index { Some(&self.frame) } else { inside };
                    (*turns, frame.and_then(|frame| self.distance(&frame.tree, *condition)))
                }
                BlockKind::For { name, last, step, turns, .. } => {
                    (*turns, self.number(*name).map(|value| (last - value) / step))
                }
                _ => return None,
            };
            Some(Mark { since: open.since, turns, distance })
        })
    }

    /// How far what a condition compares is apart, if that is no more than two numbers; the node where it
    /// starts is given.
    fn distance(&self, code: &Code, condition: usize) -> Option<f64> {
        let [open, left, mark, right, _] = code.nodes.get(condition..condition + 5)? else { return None };
        let compares = [Punct::Less, Punct::LessEqual, Punct::Greater, Punct::GreaterEqual, Punct::NotEqual];
        let NodeKind::Punct(mark) = mark.kind else { return None };
        if open.kind != NodeKind::Punct(Punct::OpenParen) || !compares.contains(&mark) {
            return None;
        }
        let side = |node: &Node| match node.kind {
            NodeKind::Number(index) => Some(code.numbers[index as usize]),
            NodeKind::Word(symbol) => self.number(symbol),
            _ => None,
        };
        Some((side(left)? - side(right)?).abs())
    }

    fn number(&self, name: Symbol) -> Option<f64> {
        match self.lookup(name) {
            Some(Value::Float(value)) => Some(value),
            _ => None,
        }
    }

    /// How many steps the outermost loop that turns will take to its end, going on as it did. `None` when
    /// nothing is seen to come to its end.
    fn steps_left(&self) -> Option<f64> {
        let before = self.effort.marks.as_ref()?;
        for (now, then) in self.marks().zip(&before.loops) {
            if now.since != then.since {
                break;
            }
            if now.turns > then.turns {
                let (from, to) = (then.distance?, now.distance?);
                let passed = (self.effort.steps - before.steps) as f64;
                return (to < from).then(|| passed * to / (from - to));
            }
        }
        (self.positions() > before.read).then_some(0.0)
    }
}
