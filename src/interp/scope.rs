//! Names and what they are bound to.
//!
//! Scoping is dynamic: a macro sees the names of whoever called it. So each name has a stack of
//! bindings of its own, the newest on top, and leaving a scope pops those it made.

use super::value::Value;
use crate::syntax::Symbol;
use rustc_hash::FxHashMap;
use std::cell::{Ref, RefCell};
use std::rc::Rc;

/// Where a value is kept. Several names can share one: parameters are passed by reference.
#[derive(Clone, Debug)]
pub enum Place {
    /// A variable.
    Variable(Rc<RefCell<Value>>),
    /// An element of the array in a variable, counted over all dimensions.
    Element(Rc<RefCell<Value>>, usize),
}

impl Place {
    /// A new variable.
    pub fn new(value: Value) -> Place {
        Place::Variable(Rc::new(RefCell::new(value)))
    }

    /// Whether changing one changes the other.
    pub fn shares_with(&self, other: &Place) -> bool {
        Rc::ptr_eq(self.cell(), other.cell())
    }

    /// Whether its name may be declared again, whatever the value.
    #[inline]
    pub fn is_free(&self) -> bool {
        match self {
            Place::Variable(cell) => {
                !matches!(*cell.borrow(), Value::Macro(_) | Value::File(_) | Value::Function(_))
            }
            Place::Element(..) => false,
        }
    }

    /// How many elements an assignment copies: those of an array that is shared.
    pub fn copied_elements(&self) -> usize {
        match (self, &*self.cell().borrow()) {
            (Place::Element(..), Value::Array(array)) if Rc::strong_count(array) > 1 => array.len(),
            _ => 0,
        }
    }

    fn cell(&self) -> &Rc<RefCell<Value>> {
        match self {
            Place::Variable(cell) | Place::Element(cell, _) => cell,
        }
    }

    /// Looks at the value; `None` for an element nothing was assigned to.
    pub fn look(&self) -> Option<Ref<'_, Value>> {
        match self {
            Place::Variable(cell) => Some(cell.borrow()),
            Place::Element(cell, index) => Ref::filter_map(cell.borrow(), |value| match value {
                Value::Array(array) => array.get(*index),
                _ => None,
            })
            .ok(),
        }
    }

    /// A copy of the value.
    pub fn get(&self) -> Option<Value> {
        self.look().map(|value| value.clone())
    }

    /// Replaces the value. The error says why an array does not take it.
    pub fn set(&self, value: Value) -> Result<(), String> {
        match self {
            Place::Variable(cell) => {
                cell.replace(value);
                Ok(())
            }
            Place::Element(cell, index) => match &mut *cell.borrow_mut() {
                Value::Array(array) => Rc::make_mut(array).set(*index, value),
                _ => Err("the array this element belonged to is gone".into()),
            },
        }
    }

    /// Forgets the value of an array element.
    pub fn clear(&self) {
        if let Place::Element(cell, index) = self
            && let Value::Array(array) = &mut *cell.borrow_mut()
        {
            Rc::make_mut(array).clear(*index);
        }
    }
}

#[derive(Debug)]
struct Binding {
    scope: u32,
    place: Place,
}

/// A note that a name should no longer be used.
#[derive(Clone, Debug)]
pub struct Deprecation {
    /// What to say about it.
    pub message: Rc<str>,
    /// Whether to say it only once.
    pub once: bool,
}

/// The bindings of every name.
#[derive(Debug, Default)]
pub struct Scopes {
    stacks: Vec<Vec<Binding>>,
    /// Names bound in scopes above the global one, oldest first.
    log: Vec<Symbol>,
    /// Where each scope above the global one starts in the log.
    starts: Vec<usize>,
    deprecated: FxHashMap<Symbol, Deprecation>,
}

impl Scopes {
    /// Enters a scope.
    pub fn enter(&mut self) {
        self.starts.push(self.log.len());
    }

    /// Leaves the newest scope: the names bound in it mean again what they meant before.
    pub fn leave(&mut self) {
        let scope = self.depth();
        let start = self.starts.pop().unwrap_or(0);
        while self.log.len() > start
            && let Some(symbol) = self.log.pop()
        {
            let stack = &mut self.stacks[symbol.0 as usize];
            if stack.last().is_some_and(|binding| binding.scope == scope) {
                stack.pop();
            }
        }
    }

    /// How many scopes there are above the global one.
    pub fn depth(&self) -> u32 {
        self.starts.len() as u32
    }

    /// What a name stands for at present.
    #[inline]
    pub fn find(&self, symbol: Symbol) -> Option<&Place> {
        self.stacks.get(symbol.0 as usize)?.last().map(|binding| &binding.place)
    }

    /// Whether a name is bound.
    pub fn is_bound(&self, symbol: Symbol) -> bool {
        self.find(symbol).is_some()
    }

    /// What a name stands for in the newest scope, if it was bound there.
    #[inline]
    pub fn find_local(&self, symbol: Symbol) -> Option<&Place> {
        let binding = self.stacks.get(symbol.0 as usize)?.last()?;
        (binding.scope == self.depth()).then_some(&binding.place)
    }

    /// What a name stands for in a scope, if it was bound there.
    pub fn find_in(&self, scope: u32, symbol: Symbol) -> Option<&Place> {
        let stack = self.stacks.get(symbol.0 as usize)?;
        stack
            .iter()
            .rev()
            .find(|binding| binding.scope <= scope)
            .filter(|b| b.scope == scope)
            .map(|b| &b.place)
    }

    /// Binds a name in the newest scope.
    pub fn bind_local(&mut self, symbol: Symbol, place: Place) {
        self.bind_in(self.depth(), symbol, place);
    }

    /// Binds a name in a scope that is still active, perhaps under newer ones.
    pub fn bind_in(&mut self, scope: u32, symbol: Symbol, place: Place) {
        if scope == self.depth() {
            if scope > 0 {
                self.log.push(symbol);
            }
            self.stack(symbol).push(Binding { scope, place });
            return;
        }
        if scope > 0 {
            // The log of a scope ends where that of the next begins.
            let end = self.starts.get(scope as usize).copied().unwrap_or(self.log.len());
            self.log.insert(end, symbol);
            for start in self.starts.iter_mut().skip(scope as usize) {
                *start += 1;
            }
        }
        let stack = self.stack(symbol);
        let above = stack.iter().rev().take_while(|binding| binding.scope > scope).count();
        stack.insert(stack.len() - above, Binding { scope, place });
    }

    /// Binds a name for the whole rest of the scene; newer bindings still hide it.
    pub fn bind_global(&mut self, symbol: Symbol, place: Place) {
        let stack = self.stack(symbol);
        match stack.first_mut().filter(|binding| binding.scope == 0) {
            Some(binding) => binding.place = place,
            None => stack.insert(0, Binding { scope: 0, place }),
        }
    }

    /// Takes away what a name stands for at present.
    pub fn unbind(&mut self, symbol: Symbol) -> Option<Place> {
        self.deprecated.remove(&symbol);
        self.stacks.get_mut(symbol.0 as usize)?.pop().map(|binding| binding.place)
    }

    /// Every name that is bound.
    pub fn names(&self) -> impl Iterator<Item = Symbol> {
        self.stacks
            .iter()
            .enumerate()
            .filter(|(_, stack)| !stack.is_empty())
            .map(|(index, _)| Symbol(index as u32))
    }

    /// Marks a name as deprecated.
    pub fn deprecate(&mut self, symbol: Symbol, note: Deprecation) {
        self.deprecated.insert(symbol, note);
    }

    /// Whether any name is marked as deprecated.
    pub fn has_deprecated(&self) -> bool {
        !self.deprecated.is_empty()
    }

    /// The note to give when a name is used, if there is one.
    #[inline]
    pub fn deprecation(&mut self, symbol: Symbol) -> Option<Rc<str>> {
        if self.deprecated.is_empty() {
            return None;
        }
        let note = self.deprecated.get(&symbol)?.clone();
        if note.once {
            self.deprecated.remove(&symbol);
        }
        Some(note.message)
    }

    fn stack(&mut self, symbol: Symbol) -> &mut Vec<Binding> {
        let index = symbol.0 as usize;
        if self.stacks.len() <= index {
            self.stacks.resize_with(index + 1, Vec::new);
        }
        &mut self.stacks[index]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn float(scopes: &Scopes, symbol: Symbol) -> Option<f64> {
        match scopes.find(symbol)?.get()? {
            Value::Float(f) => Some(f),
            _ => None,
        }
    }

    #[test]
    fn leaving_a_scope_uncovers_what_it_hid() {
        let (mut scopes, name) = (Scopes::default(), Symbol(3));
        scopes.bind_local(name, Place::new(Value::Float(1.0)));
        scopes.enter();
        assert_eq!(float(&scopes, name), Some(1.0));
        scopes.bind_local(name, Place::new(Value::Float(2.0)));
        assert_eq!(float(&scopes, name), Some(2.0));
        scopes.leave();
        assert_eq!(float(&scopes, name), Some(1.0));
    }

    #[test]
    fn a_name_can_be_bound_in_a_scope_below_the_newest() {
        let (mut scopes, name, other) = (Scopes::default(), Symbol(3), Symbol(4));
        scopes.enter();
        scopes.enter();
        scopes.bind_local(other, Place::new(Value::Float(5.0)));
        scopes.bind_in(1, name, Place::new(Value::Float(1.0)));
        assert!(scopes.find_in(1, name).is_some() && scopes.find_local(name).is_none());
        scopes.leave();
        assert_eq!((float(&scopes, name), float(&scopes, other)), (Some(1.0), None));
        scopes.leave();
        assert_eq!(float(&scopes, name), None);
    }

    #[test]
    fn a_name_unbound_in_its_scope_stays_unbound_when_the_scope_ends() {
        let (mut scopes, name) = (Scopes::default(), Symbol(0));
        scopes.bind_local(name, Place::new(Value::Float(1.0)));
        scopes.enter();
        scopes.bind_local(name, Place::new(Value::Float(2.0)));
        scopes.unbind(name);
        scopes.leave();
        assert_eq!(float(&scopes, name), Some(1.0));
    }
}
