//! What is run: files as nodes with the programs of their expressions, and the stretches of them that
//! are macros. Plain data; `program` compiles and runs, `macros` calls.

use crate::source::Span;
use crate::syntax::{Symbol, Tree};
use std::cell::{Cell, RefCell};
use std::ops::Deref;
use std::rc::Rc;

/// One step on the stack of floats. Sizes are numbers of components.
#[derive(Clone, Copy, Debug)]
pub(super) enum Op {
    /// Pushes a number.
    Number(f64),
    /// Pushes the components of a variable that has so many.
    Load(Symbol, u8),
    /// Replaces subscripts by the components of an array's element: subscripts, components.
    Element(Symbol, u8, u8),
    /// Repeats the number on top so that there are so many.
    Repeat(u8),
    /// Applies to each of so many components.
    Each(fn(f64) -> f64, u8),
    /// Applies to a number; gives up where there is no answer.
    Checked(fn(f64) -> Option<f64>),
    /// Combines numbers.
    Both(fn(f64, f64) -> f64),
    /// Combines so many components with as many.
    Zip(fn(f64, f64) -> f64, u8),
    /// Combines one number with each of so many components.
    Spread(fn(f64, f64) -> f64, u8),
    /// Divides so many by so many; gives up on zero.
    Divide(u8, u8),
    /// Combines numbers; gives up where there is no answer.
    CheckedBoth(fn(f64, f64) -> Option<f64>),
    /// Keeps one component of so many.
    Member(u8, u8),
    /// Condition, then two values of so many components: keeps one.
    Choose(u8),
    /// `select` of four.
    Select,
    /// The next number of a random stream.
    Rand,
}

/// A compiled expression.
#[derive(Debug)]
pub(super) struct Program {
    pub(super) ops: Box<[Op]>,
    /// The node after the expression.
    pub(super) end: usize,
    /// Components of the result.
    pub(super) n: u8,
    /// What was asked for: with comparisons or not, and how many components.
    pub(super) asked: (bool, u8),
    /// How often it gave up.
    pub(super) failures: Cell<u8>,
}

/// What is known of the expression that starts at a node.
#[derive(Clone, Debug, Default)]
pub(super) enum Slot {
    /// It was never read.
    #[default]
    New,
    /// It was read once.
    Seen,
    /// It cannot be compiled.
    Never,
    /// It was compiled.
    Ready(Rc<Program>),
}

/// A file as it is run: its nodes, and the programs of its expressions by the node they start at.
#[derive(Debug)]
pub(super) struct Code {
    tree: Tree,
    /// Empty until the first expression is read again.
    pub(super) slots: RefCell<Vec<Slot>>,
}

impl Code {
    /// The nodes alone.
    pub(super) fn new(tree: Tree) -> Rc<Code> {
        Rc::new(Code { tree, slots: RefCell::default() })
    }
}

impl Deref for Code {
    type Target = Tree;

    fn deref(&self) -> &Tree {
        &self.tree
    }
}

/// A macro: a stretch of nodes that is read again at each call.
#[derive(Debug)]
pub struct Macro {
    /// The names of its parameters.
    pub parameters: Vec<Symbol>,
    /// The file it was written in.
    pub(super) tree: Rc<Code>,
    /// The first node of the body.
    pub(super) start: usize,
    /// The node of its `#end`.
    pub(super) end: usize,
    /// Where its name stands in the definition.
    pub span: Span,
}
