//! Trees in, who declares which name and who uses it out: without running anything.
//!
//! What a name stands for is known for certain only while a scene runs. Still the text tells most of it, and of a
//! scene with mistakes, or of an arm that is never read, nothing else does.

mod declaration;

use crate::interp::Word;
use crate::source::Span;
use crate::syntax::{Directive, NodeKind, Punct, Symbol, Symbols, Tree};

/// How a name is declared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// `#declare`.
    Declare,
    /// `#local`.
    Local,
    /// `#macro`.
    Macro,
    /// In the parentheses of a `#macro`.
    Parameter,
    /// In the parentheses of a `#for`.
    Counter,
}

/// One place where a name is declared.
#[derive(Clone, Debug)]
pub struct Declaration {
    /// The name.
    pub name: Symbol,
    /// How.
    pub kind: Kind,
    /// Where the name stands.
    pub span: Span,
    /// From the directive to the end of the value, or of the macro's body; a parameter's is its name.
    pub whole: Span,
    /// What is declared: the first token after the `=`. For a macro its parentheses.
    pub value: Span,
    /// The macro it stands in, by its place among the declarations.
    pub within: Option<usize>,
}

/// One place where a name is used.
#[derive(Clone, Copy, Debug)]
pub struct Use {
    /// The name.
    pub name: Symbol,
    /// Where.
    pub span: Span,
    /// The macro it stands in, by its place among the declarations.
    pub within: Option<usize>,
}

/// The names of one file, in the order of the text.
#[derive(Clone, Debug, Default)]
pub struct Index {
    /// Where names are declared.
    pub declarations: Vec<Declaration>,
    /// Where names are used, as far as they aren't reserved.
    pub uses: Vec<Use>,
    /// Names in strings: `Parse_String` and its kin make code of strings.
    pub mentioned: Vec<Symbol>,
}

impl Index {
    /// Reads the names of a file. The symbols are those it was parsed with, and started with the reserved words.
    pub fn new(tree: &Tree, text: &str, symbols: &Symbols) -> Index {
        let mut reader = Reader { tree, index: Index::default(), macros: Vec::new(), at: 0 };
        reader.read();
        let mut index = reader.index;
        for node in tree.nodes.iter().filter(|node| node.kind == NodeKind::Text) {
            let string = &text[node.start as usize..node.end as usize];
            let words = string.split(|c: char| !c.is_ascii_alphanumeric() && c != '_');
            index
                .mentioned
                .extend(words.filter_map(|word| symbols.find(word)).filter(|&word| Word::of(word).is_none()));
        }
        index
    }

    /// The declaration a name at some place in this file refers to, as far as the text tells: of the macro it stands in,
    /// or else the last before it, or else the first.
    pub fn find(&self, name: Symbol, at: u32) -> Option<&Declaration> {
        let named = || self.declarations.iter().filter(move |declaration| declaration.name == name);
        let around = |declaration: &&Declaration| {
            declaration.kind == Kind::Macro && declaration.whole.start <= at && at <= declaration.whole.end
        };
        // The innermost macro comes last.
        let within = self.declarations.iter().rposition(|declaration| around(&declaration));
        let own = |declaration: &&Declaration| {
            within.is_some() && declaration.within == within && declaration.kind != Kind::Declare
        };
        let is_global = |declaration: &&Declaration| {
            declaration.within.is_none() || matches!(declaration.kind, Kind::Declare | Kind::Macro)
        };
        named()
            .filter(own)
            .rfind(|declaration| declaration.span.start <= at)
            .or_else(|| named().filter(is_global).rfind(|declaration| declaration.span.start <= at))
            .or_else(|| named().find(is_global))
            .or_else(|| named().next())
    }
}

struct Reader<'a> {
    tree: &'a Tree,
    index: Index,
    /// The macros around, by their places, and the nodes of their `#end`s.
    macros: Vec<(usize, usize)>,
    at: usize,
}

impl Reader<'_> {
    fn read(&mut self) {
        while let Some(node) = self.tree.nodes.get(self.at) {
            while self.macros.last().is_some_and(|&(_, end)| end <= self.at) {
                self.macros.pop();
            }
            match node.kind {
                NodeKind::Directive(Directive::Declare, _) => self.declaration(Kind::Declare),
                NodeKind::Directive(Directive::Local, _) => self.declaration(Kind::Local),
                NodeKind::Directive(Directive::Macro, link) => self.definition(link as usize),
                NodeKind::Directive(Directive::For, _) => self.counter(),
                NodeKind::Word(name) if Word::of(name).is_none() => {
                    let within = self.within();
                    self.index.uses.push(Use { name, span: self.tree.span(self.at), within });
                    self.at += 1;
                }
                _ => self.at += 1,
            }
        }
    }

    fn within(&self) -> Option<usize> {
        self.macros.last().map(|&(place, _)| place)
    }

    /// The kind of a node by its distance from the one at hand.
    fn kind(&self, ahead: usize) -> Option<NodeKind> {
        self.tree.nodes.get(self.at + ahead).map(|node| node.kind)
    }

    /// The name at a distance, if it is none that is reserved.
    fn name(&self, ahead: usize) -> Option<Symbol> {
        match self.kind(ahead) {
            Some(NodeKind::Word(name)) if Word::of(name).is_none() => Some(name),
            _ => None,
        }
    }

    fn push(&mut self, name: Symbol, kind: Kind, node: usize, whole: Span, value: Span) -> usize {
        let declaration =
            Declaration { name, kind, span: self.tree.span(node), whole, value, within: self.within() };
        self.index.declarations.push(declaration);
        self.index.declarations.len() - 1
    }

    /// `#declare` or `#local`. What is assigned to an element of an array declares nothing.
    fn declaration(&mut self, kind: Kind) {
        let directive = self.at;
        self.at += 1;
        while matches!(self.kind(0), Some(NodeKind::Text))
            || matches!(self.kind(0), Some(NodeKind::Word(word)) if matches!(Word::of(word), Some(Word::Deprecated | Word::Once)))
        {
            self.at += 1;
        }
        let Some(name) = self.name(0) else { return };
        let node = self.at;
        self.at += 1;
        if self.kind(0) == Some(NodeKind::Punct(Punct::Equal)) {
            let end = declaration::end(self.tree, node + 2);
            let whole = self.tree.span(directive).to(self.tree.span(end));
            self.push(name, kind, node, whole, self.tree.span(node + 2));
            self.at += 1;
        }
    }

    /// `#macro`.
    fn definition(&mut self, link: usize) {
        let directive = self.at;
        let Some(name) = self.name(1) else {
            self.at += 1;
            return;
        };
        let end = self.end_of(link);
        let whole = self.tree.span(directive).to(self.tree.span(end));
        let mut close = directive + 2;
        while !matches!(
            self.tree.nodes.get(close).map(|node| node.kind),
            None | Some(NodeKind::Punct(Punct::CloseParen) | NodeKind::Directive(..))
        ) {
            close += 1;
        }
        let value = self.tree.span(directive + 2).to(self.tree.span(close));
        let place = self.push(name, Kind::Macro, directive + 1, whole, value);
        self.macros.push((place, end));
        for node in directive + 2..close {
            self.at = node;
            if let Some(parameter) = self.name(0) {
                let span = self.tree.span(node);
                self.push(parameter, Kind::Parameter, node, span, span);
            }
        }
        self.at = close;
    }

    /// The node of the `#end` a chain of links leads to; the last node, if it leads out of the file.
    fn end_of(&self, mut link: usize) -> usize {
        while let Some(NodeKind::Directive(directive, next)) = self.tree.nodes.get(link).map(|node| node.kind)
        {
            if directive == Directive::End {
                return link;
            }
            link = next as usize;
        }
        self.tree.nodes.len().saturating_sub(1)
    }

    /// `#for`.
    fn counter(&mut self) {
        if let Some(name) = self.name(2) {
            let whole = self.tree.span(self.at).to(self.tree.span(self.at + 2));
            let value = self.tree.span(self.at + 4);
            self.push(name, Kind::Counter, self.at + 2, whole, value);
            self.at += 3;
        } else {
            self.at += 1;
        }
    }
}

#[cfg(test)]
mod tests;
