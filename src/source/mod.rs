//! Files in, text with numbered positions out.
//!
//! - [`Sources`] holds every file read during a run and is the only part of the program that
//!   opens one; a [`Span`] names a stretch of text in one of them.
//! - Text is UTF-8 inside; how a file was encoded is kept, because the values of strings come
//!   from its bytes (docs/spec/language.md 1.6).

mod embedded;
mod permissions;
mod search;
pub mod span;

pub use permissions::{Folder, Permissions};
pub use search::{FileKind, Library, Missing};
pub use span::{FileId, Span};

use rustc_hash::FxHasher;
use std::borrow::Cow;
use std::hash::{Hash, Hasher};
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

/// How the bytes of a file became text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// The bytes are the text.
    Utf8,
    /// Not valid UTF-8: each byte is one character.
    Latin1,
}

/// One file of the scene.
#[derive(Debug)]
pub struct Source {
    /// The name as the scene (or the user) gave it, for messages.
    pub name: String,
    /// Where it was found; empty for text that comes from no file.
    pub path: PathBuf,
    /// The whole text, unless it was released and nobody has asked for it since.
    text: OnceLock<Arc<String>>,
    /// Its length in bytes.
    length: usize,
    fingerprint: OnceLock<u64>,
    /// How it was encoded.
    pub encoding: Encoding,
}

impl Source {
    /// Decodes bytes: UTF-8, or Latin-1 when they are not valid UTF-8.
    pub fn new(name: impl Into<String>, path: impl Into<PathBuf>, bytes: Vec<u8>) -> Source {
        let (text, encoding) = match String::from_utf8(bytes) {
            Ok(text) => (text, Encoding::Utf8),
            Err(error) => (error.as_bytes().iter().map(|&b| char::from(b)).collect(), Encoding::Latin1),
        };
        let (name, path, length) = (name.into(), path.into(), text.len());
        Source {
            name,
            path,
            text: OnceLock::from(Arc::new(text)),
            length,
            fingerprint: OnceLock::new(),
            encoding,
        }
    }

    /// The same file with another text.
    pub fn with_text(&self, text: &str) -> Source {
        Source {
            name: self.name.clone(),
            path: self.path.clone(),
            text: OnceLock::from(Arc::new(text.to_owned())),
            length: text.len(),
            encoding: self.encoding,
            fingerprint: OnceLock::new(),
        }
    }

    /// The whole text.
    pub fn text(&self) -> &Arc<String> {
        self.text.get_or_init(|| {
            let again = std::fs::read(&self.path).map(|bytes| Source::new("", "", bytes));
            match again {
                Ok(Source { text, length, .. }) if length == self.length => text.into_inner(),
                // The file has changed or is gone: places in it still are places.
                _ => None,
            }
            .unwrap_or_else(|| Arc::new(" ".repeat(self.length)))
        })
    }

    /// A number that differs when the text does.
    pub fn fingerprint(&self) -> u64 {
        *self.fingerprint.get_or_init(|| {
            let mut hasher = FxHasher::default();
            self.text().hash(&mut hasher);
            hasher.finish()
        })
    }

    /// The line and column (both from 1, the column in characters) of a byte position.
    pub fn position(&self, offset: u32) -> (usize, usize) {
        let before = &self.text()[..self.text().floor_char_boundary(offset as usize)];
        let line_start = before.rfind('\n').map_or(0, |at| at + 1);
        (before.bytes().filter(|&b| b == b'\n').count() + 1, before[line_start..].chars().count() + 1)
    }

    /// The bytes a piece of this file's text had in the file.
    pub fn bytes<'a>(&self, text: &'a str) -> Cow<'a, [u8]> {
        match self.encoding {
            Encoding::Utf8 => Cow::Borrowed(text.as_bytes()),
            Encoding::Latin1 => Cow::Owned(text.chars().map(|c| u8::try_from(c).unwrap_or(b'?')).collect()),
        }
    }

    /// Whether the file is something else than text, such as a picture.
    pub fn is_binary(&self) -> bool {
        let odd =
            |c: &char| c.is_control() && !matches!(c, '\t' | '\n' | '\r' | '\u{b}' | '\u{c}' | '\u{1a}');
        let (mut seen, mut controls) = (0, 0);
        for c in self.text().chars().take(512) {
            seen += 1;
            controls += usize::from(odd(&c));
        }
        controls * 10 > seen
    }
}

/// Every file read in this run, and where to look for more.
#[derive(Debug, Default)]
pub struct Sources {
    files: Vec<Source>,
    /// Where included and other files are looked for.
    pub library: Library,
}

impl Sources {
    /// Starts with no file and the given places to look in.
    pub fn new(library: Library) -> Sources {
        Sources { files: Vec::new(), library }
    }

    /// Adds text that is already at hand, such as a scene from standard input.
    pub fn add(&mut self, source: Source) -> FileId {
        // A scene cannot open 2^32 files: the limit on open includes is far lower.
        let id = FileId(u32::try_from(self.files.len()).unwrap_or(u32::MAX));
        self.files.push(source);
        id
    }

    /// Reads a scene file named by the user. The error is the operating system's.
    pub fn read(&mut self, path: &Path) -> std::io::Result<FileId> {
        let bytes = std::fs::read(path)?;
        Ok(self.add(Source::new(path.display().to_string(), path, bytes)))
    }

    /// Finds and reads an included file. A file whose text was read before keeps its number.
    pub fn include(&mut self, name: &str) -> Result<FileId, Missing> {
        let (path, bytes) = self.library.open(name, FileKind::Include)?;
        let source = Source::new(name, path, bytes);
        let known = self
            .files
            .iter()
            .position(|f| f.path == source.path && f.name == source.name && f.text() == source.text());
        match known {
            Some(index) => Ok(FileId(index as u32)),
            None => Ok(self.add(source)),
        }
    }

    /// The file with this number.
    ///
    /// # Panics
    /// When the number comes from another `Sources`.
    pub fn get(&self, id: FileId) -> &Source {
        &self.files[id.0 as usize]
    }

    /// Every file read so far.
    pub fn all(&self) -> &[Source] {
        &self.files
    }

    /// Frees the memory of long files that can be read again: all that is needed of them from now on is the
    /// odd line in a message.
    pub fn release(&mut self) {
        /// Bytes of text that are worth reading again.
        const LONG: usize = 1 << 20;
        for file in self.files.iter_mut().filter(|file| file.length > LONG && file.path.is_file()) {
            file.fingerprint();
            file.text.take();
        }
    }

    /// The text under a span.
    pub fn text(&self, span: Span) -> &str {
        let text = self.get(span.file).text();
        &text[text.floor_char_boundary(span.start as usize)..text.floor_char_boundary(span.end as usize)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_that_are_not_utf8_are_read_as_latin1() {
        let source = Source::new("a.inc", "", vec![b'"', 0xe9, b'"']);
        assert_eq!(source.encoding, Encoding::Latin1);
        assert_eq!(&**source.text(), "\"é\"");
        assert_eq!(&*source.bytes("é"), [0xe9]);
    }

    #[test]
    fn positions_count_lines_and_characters_from_one() {
        let source = Source::new("a.pov", "", "ab\né=1".into());
        assert_eq!(source.position(0), (1, 1));
        assert_eq!(source.position(3), (2, 1));
        assert_eq!(source.position(5), (2, 2));
        assert_eq!(source.position(7), (2, 4));
    }

    #[test]
    fn a_picture_is_no_text() {
        assert!(Source::new("a.png", "", vec![0x89, b'P', 0, 0, 0, 1, 2, 3]).is_binary());
        assert!(!Source::new("a.pov", "", b"sphere { 0, 1 }\r\n\x1a".to_vec()).is_binary());
    }

    #[test]
    fn a_long_file_that_was_released_is_read_again_when_it_is_asked_for() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("long.inc");
        std::fs::write(&path, "1,\n".repeat(400_000)).unwrap();
        let mut sources = Sources::default();
        let file = sources.read(&path).unwrap();
        sources.release();
        assert!(sources.get(file).text.get().is_none());
        assert_eq!(sources.get(file).position(30), (11, 1));
        sources.release();
        std::fs::write(&path, "1").unwrap();
        assert_eq!(sources.get(file).text().len(), 1_200_000);
    }
}
