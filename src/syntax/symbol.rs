//! Names, interned: a word of the scene is a number from the moment it is read.

use rustc_hash::FxHashMap;
use std::rc::Rc;

/// A word of the scene. Words given to [`Symbols::new`] have the first numbers, in their order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Symbol(pub u32);

/// All words met so far.
#[derive(Debug)]
pub struct Symbols {
    names: Vec<Rc<str>>,
    numbers: FxHashMap<Rc<str>, Symbol>,
}

impl Symbols {
    /// Starts with these words, which must differ from each other.
    pub fn new<'a>(words: impl IntoIterator<Item = &'a str>) -> Symbols {
        let mut symbols = Symbols { names: Vec::new(), numbers: FxHashMap::default() };
        for word in words {
            symbols.intern(word);
        }
        symbols
    }

    /// The number of a word.
    pub fn intern(&mut self, word: &str) -> Symbol {
        if let Some(&symbol) = self.numbers.get(word) {
            return symbol;
        }
        let name: Rc<str> = word.into();
        let symbol = Symbol(self.names.len() as u32);
        self.names.push(Rc::clone(&name));
        self.numbers.insert(name, symbol);
        symbol
    }

    /// The number of a word that was met before.
    pub fn find(&self, word: &str) -> Option<Symbol> {
        self.numbers.get(word).copied()
    }

    /// The word with this number.
    pub fn name(&self, symbol: Symbol) -> &Rc<str> {
        &self.names[symbol.0 as usize]
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.names.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.names.is_empty()
    }
}
