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
    /// Keeps so many components from the top at a place of the bottom: an argument or a local name.
    Keep(u8, u16),
    /// Pushes so many components from a place of the bottom.
    Kept(u8, u16),
    /// Gives up when this name stands for something that may not be declared again.
    Free(Symbol),
    /// Does something with the text that was built so far.
    Text(TextOp),
}

/// One step on the text that is built.
#[derive(Clone, Copy, Debug)]
pub(super) enum TextOp {
    /// Appends a literal.
    Literal(u16),
    /// Appends the string a name stands for.
    Load(Symbol),
    /// Appends `str` of three numbers.
    Str,
    /// Appends the character of a number.
    Chr,
    /// Pushes where the text ends at present.
    Mark,
    /// Replaces a mark by the length of the text after it, which is removed.
    Strlen,
    /// Replaces two marks by the comparison of the texts after each.
    Strcmp,
    /// Replaces a mark by the number that the text after it begins with.
    Val,
}

/// A compiled expression.
#[derive(Debug)]
pub(super) struct Program {
    pub(super) ops: Box<[Op]>,
    /// The node after the expression.
    pub(super) end: usize,
    /// Components of the result; 0 for a string.
    pub(super) n: u8,
    /// What was asked for: with comparisons or not, and how many components.
    pub(super) asked: (bool, u8),
    /// The macros it has in it, by the names they were called by.
    pub(super) calls: Box<[(Symbol, Rc<Macro>)]>,
    /// The strings in it.
    pub(super) texts: Box<[Box<str>]>,
    /// How many numbers it keeps at the bottom of the stack.
    pub(super) places: u16,
    /// How often it gave up since it last did not.
    pub(super) failures: Cell<u8>,
}

/// A compiled `#declare` or `#local` of numbers or of a string.
#[derive(Debug)]
pub(super) struct Assignment {
    /// What is declared.
    pub(super) name: Symbol,
    /// Whether it is `#local`.
    pub(super) local: bool,
    /// How many subscripts of an array's element come before the value.
    pub(super) subscripts: u8,
    /// Subscripts, then the value; its end is that of the whole directive.
    pub(super) program: Program,
}

/// What is known of the expression that starts at a node, or the declaration.
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
    /// It is a declaration, and was compiled.
    Assign(Rc<Assignment>),
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
