//! Loops that can be seen never to end: no `#break` leaves them, and nothing in them changes what
//! their condition asks for. Whether a loop ends can't be told in general, so this only looks for
//! the mistakes people make; `limits` stops the rest.

use crate::interp::code::{Code, Macro};
use crate::interp::scope::Place;
use crate::interp::value::Value;
use crate::interp::{Fault, Vm, Word};
use crate::source::Span;
use crate::syntax::{Directive, Node, NodeKind, Punct, Symbol};
use std::ops::Range;
use std::rc::Rc;

/// Turns of a `#while` before it is looked at: most loops are done by then.
pub(in crate::interp) const PATIENCE: u64 = 100;

impl Vm<'_> {
    /// The error for a `#while` between two nodes of the file at hand, if it never ends.
    pub(super) fn endless(&self, condition: usize, end: usize, span: Span) -> Option<Fault> {
        let code = Rc::clone(&self.frame.tree);
        let (names, body) = self.inputs(&code.nodes, condition)?;
        let places = names.iter().filter_map(|&name| self.scopes.find(name)).collect();
        let growth = self.growth(&code.nodes[condition..body]);
        let mut search = Search { vm: self, names: &names, places, growth, seen: Vec::new() };
        if !search.goes_on(&code, body..end) {
            return None;
        }
        let mut listed: Vec<String> =
            names.iter().map(|&name| format!("`{}`", self.symbols.name(name))).collect();
        listed.dedup();
        let label = match listed.as_slice() {
            [name] if self.growth(&code.nodes[condition..body]).is_some() => {
                format!("nothing in it brings {name} nearer to the end")
            }
            [] => "its condition is always true, and there is no `#break` in it".to_owned(),
            [name] => format!("nothing in it changes {name}"),
            [names @ .., last] => format!("nothing in it changes {} or {last}", names.join(", ")),
        };
        let help = match names.is_empty() {
            true => "leave it with `#break`, or let the condition ask for something that changes",
            false => {
                "change one of them in the loop, such as by `#declare I = I + 1;`, or leave it with `#break`"
            }
        };
        Some(self.error(span, "this `#while` never ends").label(label).help(help))
    }

    /// The names in the condition that starts at a node, and where the body starts. `None` when it
    /// depends on something else that may change.
    fn inputs(&self, nodes: &[Node], condition: usize) -> Option<(Vec<Symbol>, usize)> {
        let mut names = Vec::new();
        let mut depth = 0;
        for (index, node) in nodes.iter().enumerate().skip(condition) {
            match node.kind {
                NodeKind::Punct(Punct::OpenParen) => depth += 1,
                NodeKind::Punct(Punct::CloseParen) if depth == 1 => return Some((names, index + 1)),
                NodeKind::Punct(Punct::CloseParen) => depth -= 1,
                NodeKind::Punct(Punct::Hash) | NodeKind::Directive(..) | NodeKind::Error(_) => return None,
                NodeKind::Word(symbol) => match Word::of(symbol) {
                    Some(
                        Word::Rand | Word::Seed | Word::Now | Word::FileExists | Word::Trace | Word::Version,
                    ) => return None,
                    Some(_) => {}
                    None if self.macro_of(symbol).is_some() => return None,
                    None => names.push(symbol),
                },
                NodeKind::Number(_) | NodeKind::Vector(..) | NodeKind::Text | NodeKind::Punct(_) => {}
            }
        }
        None
    }

    /// The name a condition compares, and the sign of what may be added to it while the condition holds, and
    /// ever will: `I > 0` as long as `I` only grows. The nodes start with the opening parenthesis.
    fn growth(&self, condition: &[Node]) -> Option<(Symbol, Punct)> {
        let [_, left, mark, right, _] = condition else { return None };
        let NodeKind::Punct(mark) = mark.kind else { return None };
        let name = |node: &Node| match node.kind {
            NodeKind::Word(symbol) if Word::of(symbol).is_none() => Some(symbol),
            _ => None,
        };
        let either = |node: &Node, sign: Punct| name(node).map(|name| (name, sign));
        match mark {
            Punct::Greater | Punct::GreaterEqual if name(left) != name(right) => {
                either(left, Punct::Plus).or_else(|| either(right, Punct::Minus))
            }
            Punct::Less | Punct::LessEqual if name(left) != name(right) => {
                either(left, Punct::Minus).or_else(|| either(right, Punct::Plus))
            }
            _ => None,
        }
    }

    fn macro_of(&self, symbol: Symbol) -> Option<Rc<Macro>> {
        match self.lookup(symbol) {
            Some(Value::Macro(called)) => Some(called),
            _ => None,
        }
    }
}

/// A look at everything a loop runs.
struct Search<'s, 'a> {
    vm: &'s Vm<'a>,
    /// What has to stay as it is, by name and by place.
    names: &'s [Symbol],
    places: Vec<&'s Place>,
    /// The name that may grow, and the sign of its growth.
    growth: Option<(Symbol, Punct)>,
    /// The macros that were looked at.
    seen: Vec<Rc<Macro>>,
}

impl Search<'_, '_> {
    /// Whether the nodes neither leave the loop nor change a name that matters.
    fn goes_on(&mut self, code: &Code, range: Range<usize>) -> bool {
        range.into_iter().all(|index| match code.nodes[index].kind {
            NodeKind::Directive(directive, _) => match directive {
                Directive::Break | Directive::Include | Directive::Error | Directive::Macro => false,
                Directive::Fopen | Directive::Fclose | Directive::Read => self.names.is_empty(),
                Directive::Declare | Directive::Local | Directive::Undef | Directive::For => {
                    let rest = &code.nodes[index + 1..];
                    !target(rest).is_some_and(|name| self.matters(name)) || self.grows(rest)
                }
                _ => true,
            },
            NodeKind::Word(symbol) => match Word::of(symbol) {
                Some(Word::Declare | Word::Include) => false,
                // It can store a normal in a variable.
                Some(Word::Trace) => self.names.is_empty(),
                Some(_) => true,
                None => match self.vm.macro_of(symbol) {
                    Some(called) => self.call_goes_on(&called, &code.nodes[index + 1..]),
                    None => true,
                },
            },
            NodeKind::Error(_) => false,
            NodeKind::Number(_) | NodeKind::Vector(..) | NodeKind::Text | NodeKind::Punct(_) => true,
        })
    }

    /// The same for the call of a macro, which can change what it is given.
    fn call_goes_on(&mut self, called: &Rc<Macro>, arguments: &[Node]) -> bool {
        let mut depth = 0;
        for node in arguments {
            match node.kind {
                NodeKind::Punct(Punct::OpenParen) => depth += 1,
                NodeKind::Punct(Punct::CloseParen) if depth <= 1 => break,
                NodeKind::Punct(Punct::CloseParen) => depth -= 1,
                NodeKind::Word(symbol) if self.matters(symbol) => return false,
                _ => {}
            }
        }
        if self.seen.iter().any(|seen| Rc::ptr_eq(seen, called)) {
            return true;
        }
        self.seen.push(Rc::clone(called));
        // Macros that call each other may do so many levels deep.
        stacker::maybe_grow(64 << 10, 1 << 20, || self.goes_on(&called.tree, called.start..called.end))
    }

    /// Whether the nodes after `#declare` are `I = I + 1;`, for the name that may grow.
    fn grows(&self, declaration: &[Node]) -> bool {
        let Some((name, sign)) = self.growth else { return false };
        let kinds = [
            NodeKind::Word(name),
            NodeKind::Punct(Punct::Equal),
            NodeKind::Word(name),
            NodeKind::Punct(sign),
        ];
        declaration.iter().map(|node| node.kind).take(4).eq(kinds)
            && matches!(declaration.get(4).map(|node| node.kind), Some(NodeKind::Number(_)))
            && matches!(declaration.get(5).map(|node| node.kind), Some(NodeKind::Punct(Punct::Semicolon)))
    }

    fn matters(&self, symbol: Symbol) -> bool {
        self.names.contains(&symbol)
            || self
                .vm
                .scopes
                .find(symbol)
                .is_some_and(|place| self.places.iter().any(|other| other.shares_with(place)))
    }
}

/// The name that a directive before these nodes binds.
fn target(nodes: &[Node]) -> Option<Symbol> {
    nodes.iter().take(4).find_map(|node| match node.kind {
        NodeKind::Word(symbol) if !matches!(Word::of(symbol), Some(Word::Deprecated | Word::Once)) => {
            Some(symbol)
        }
        _ => None,
    })
}
