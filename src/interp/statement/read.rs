//! Small steps every reader of a statement takes.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::interp::stream::TokenKind;
use crate::interp::value::Value;
use crate::interp::{Block, Result, Vm};
use crate::scene::Function;
use crate::source::{FileKind, Missing, Span};
use crate::syntax::Punct;

impl Vm<'_> {
    /// Takes a keyword and the brace after it.
    pub(super) fn enter(&mut self) -> Result<Block> {
        let keyword = self.next()?;
        self.open(keyword)
    }

    /// Where the next token stands.
    pub(super) fn here(&mut self) -> Result<Span> {
        Ok(self.peek()?.span)
    }

    /// What `read` reads, and where it stands.
    pub(super) fn located<T>(&mut self, read: impl FnOnce(&mut Self) -> Result<T>) -> Result<(T, Span)> {
        let start = self.here()?;
        let value = read(self)?;
        Ok((value, start.to(self.last)))
    }

    /// Takes the word that was peeked and reads its value.
    pub(super) fn after_word<T>(&mut self, read: impl FnOnce(&mut Self) -> Result<T>) -> Result<T> {
        self.next()?;
        read(self)
    }

    /// Reads a whole number; a negative one counts as 0.
    pub(super) fn read_count(&mut self) -> Result<u32> {
        Ok(self.read_int()?.max(0) as u32)
    }

    /// Reads a whole number that is at most `most`: with more, a single point might never be done.
    pub(super) fn read_at_most(&mut self, what: &str, most: i32) -> Result<i32> {
        let (number, place) = self.located(Self::read_int)?;
        if number > most {
            self.warn(place, format!("`{what}` is at most {most}"), &format!("{most} is taken"));
        }
        Ok(number.min(most))
    }

    /// Reads `< F, F … >` with `count` components, more than a vector has.
    pub(super) fn read_components(&mut self, count: usize) -> Result<Vec<f64>> {
        let open = self.peek()?;
        if let TokenKind::Vector(..) = open.kind {
            let message = format!("{count} numbers are needed here, not a vector");
            return Err(self.error(open.span, message));
        }
        self.expect(Punct::Less)?;
        let mut numbers = Vec::with_capacity(count);
        for _ in 0..count {
            numbers.push(self.read_float()?);
            self.comma()?;
        }
        if !self.accept_punct(Punct::Greater)? {
            return Err(self
                .expected(&format!("`>` after {count} numbers"))
                .see(open.span, "the list begins here"));
        }
        Ok(numbers)
    }

    /// Reads `function { expression }` of x, y and z; its keyword comes next. A list of parameters and
    /// the bodies that are no expressions are refused.
    pub(super) fn read_plain_function(&mut self) -> Result<Arc<Function>> {
        let keyword = self.next()?;
        if self.peek()?.kind != TokenKind::Punct(Punct::OpenBrace) {
            let fault = self.expected("`{`");
            return Err(fault.help("the parameters of this function are x, y and z: leave the list out"));
        }
        Ok(Arc::new(self.read_function_after(keyword, false)?))
    }

    /// Whether a single number comes next, not a vector.
    pub(super) fn at_float(&mut self) -> Result<bool> {
        let token = self.peek()?;
        Ok(match token.kind {
            TokenKind::Vector(..) | TokenKind::Punct(Punct::Less) => false,
            TokenKind::Name(_) => {
                let name = self.place.as_ref().and_then(|place| place.look());
                matches!(name.as_deref(), Some(Value::Float(_) | Value::Function(_)))
            }
            _ => self.at_number()?,
        })
    }

    /// Finds a file the scene names. It has to be there.
    pub(super) fn find_file(&mut self, name: &str, kind: FileKind, place: Span) -> Result<PathBuf> {
        let missing = match self.sources.library.find(name, kind) {
            Some(path) if path.is_file() => match self.sources.library.permissions.check_read(&path) {
                Ok(()) => return Ok(path),
                Err(error) => Missing::Unreadable(path, error),
            },
            Some(path) => Missing::Folder(path),
            None => Missing::NotFound(self.sources.library.folders().map(Path::to_owned).collect()),
        };
        Err(self.missing_file(name, place, missing))
    }

    /// Finds and reads a file the scene names.
    pub(super) fn load_file(&mut self, name: &str, kind: FileKind, place: Span) -> Result<Vec<u8>> {
        match self.sources.library.open(name, kind) {
            Ok((_, bytes)) => Ok(bytes),
            Err(missing) => Err(self.missing_file(name, place, missing)),
        }
    }
}
