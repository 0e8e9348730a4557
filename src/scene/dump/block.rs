//! Blocks of text: on one line where they are short, indented where they are not.

use std::fmt::Display;

/// The width a block on one line may have.
const WIDTH: usize = 100;

/// `head { lines and blocks }`.
pub(super) struct Block {
    head: String,
    items: Vec<Item>,
}

enum Item {
    Line(String),
    Block(Block),
}

impl Block {
    /// A block without content.
    pub(super) fn new(head: impl Into<String>) -> Self {
        Self { head: head.into(), items: Vec::new() }
    }

    /// Adds text.
    pub(super) fn line(mut self, text: impl Into<String>) -> Self {
        self.items.push(Item::Line(text.into()));
        self
    }

    /// Adds a word and its value.
    pub(super) fn field(self, word: &str, value: impl Display) -> Self {
        self.line(format!("{word} {value}"))
    }

    /// Adds a word and its value, if there is one.
    pub(super) fn optional(self, word: &str, value: Option<impl Display>) -> Self {
        match value {
            Some(value) => self.field(word, value),
            None => self,
        }
    }

    /// Adds a word if it holds.
    pub(super) fn flag(self, word: &str, on: bool) -> Self {
        if on { self.line(word) } else { self }
    }

    /// Adds a block.
    pub(super) fn block(mut self, block: Block) -> Self {
        self.items.push(Item::Block(block));
        self
    }

    /// Adds blocks.
    pub(super) fn blocks(mut self, blocks: impl IntoIterator<Item = Block>) -> Self {
        self.items.extend(blocks.into_iter().map(Item::Block));
        self
    }

    /// Adds the content of another block.
    pub(super) fn extend(mut self, other: Block) -> Self {
        self.items.extend(other.items);
        self
    }

    /// Writes the block and a line break.
    pub(super) fn write(&self, text: &mut String) {
        self.write_at(0, text);
    }

    fn write_at(&self, depth: usize, text: &mut String) {
        let indent = "  ".repeat(depth);
        if let Some(line) = self.short(WIDTH.saturating_sub(indent.len())) {
            text.push_str(&format!("{indent}{line}\n"));
            return;
        }
        text.push_str(&format!("{indent}{} {{\n", self.head));
        for item in &self.items {
            match item {
                Item::Line(line) => text.push_str(&format!("{indent}  {line}\n")),
                Item::Block(block) => block.write_at(depth + 1, text),
            }
        }
        text.push_str(&format!("{indent}}}\n"));
    }

    /// The block on one line, if that is at most `width` wide and holds at most one other block.
    fn short(&self, width: usize) -> Option<String> {
        let mut line = format!("{} {{", self.head);
        let mut blocks = 0;
        for item in &self.items {
            let item = match item {
                Item::Line(line) => line.clone(),
                Item::Block(block) => {
                    blocks += 1;
                    block.short(width)?
                }
            };
            line.push(' ');
            line.push_str(&item);
            if line.len() + 2 > width || blocks > 1 {
                return None;
            }
        }
        line.push_str(" }");
        Some(line)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_blocks_stand_on_one_line_and_long_ones_do_not() {
        let inner = |text: &str| Block::new("pigment").line(text);
        let mut text = String::new();
        Block::new("texture").block(inner("rgb 1")).write(&mut text);
        Block::new("texture").block(inner("rgb 1")).block(inner(&"long ".repeat(30))).write(&mut text);
        assert_eq!(text.lines().next(), Some("texture { pigment { rgb 1 } }"));
        assert_eq!(text.lines().nth(2), Some("  pigment { rgb 1 }"));
        assert_eq!(text.lines().count(), 7);
    }
}
