//! Finding files the way POV-Ray does, docs/spec/language.md 2.9: each candidate name first as it
//! stands, then in every folder of the library path in order; only then, povista's own addition,
//! in the folder of the scene and among the embedded includes.

use std::io;
use std::path::{Path, PathBuf};

use super::permissions::Permissions;

/// What a file is wanted for: decides the extensions that may be left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileKind {
    /// `#include`.
    Include,
    /// A scene.
    Scene,
    /// An image or another file of which the name says everything; the extensions to try.
    Other(&'static [&'static str]),
}

impl FileKind {
    fn extensions(self) -> &'static [&'static str] {
        match self {
            FileKind::Include => &[".inc", ".INC"],
            FileKind::Scene => &[".pov", ".POV"],
            FileKind::Other(extensions) => extensions,
        }
    }

    /// The names to try for a name, in order.
    fn candidates(self, name: &str) -> Vec<String> {
        let extensions = self.extensions();
        let longer = extensions.iter().map(|extension| format!("{name}{extension}"));
        if extensions.iter().any(|extension| name.ends_with(extension)) {
            std::iter::once(name.to_owned()).chain(longer).collect()
        } else {
            longer.chain(std::iter::once(name.to_owned())).collect()
        }
    }
}

/// Why a file could not be had.
#[derive(Debug)]
pub enum Missing {
    /// It is nowhere; the folders that were searched.
    NotFound(Vec<PathBuf>),
    /// It is there, but a folder.
    Folder(PathBuf),
    /// It is there, but cannot be read.
    Unreadable(PathBuf, io::Error),
}

/// The places where files are looked for.
#[derive(Clone, Debug, Default)]
pub struct Library {
    /// What relative names are relative to; empty for the current folder of the process.
    pub current: PathBuf,
    /// `+L`, `Library_Path`, `POVINC` and the installed includes, in order of search.
    pub paths: Vec<PathBuf>,
    /// The folder of the scene, searched last.
    pub scene: Option<PathBuf>,
    /// What may be read and written.
    pub permissions: Permissions,
}

impl Library {
    /// The folders in the order they are searched.
    pub fn folders(&self) -> impl Iterator<Item = &Path> {
        std::iter::once(self.current.as_path())
            .chain(self.paths.iter().map(PathBuf::as_path))
            .chain(self.scene.as_deref())
    }

    /// Where a file is, without opening it. `None` when it is nowhere.
    pub fn find(&self, name: &str, kind: FileKind) -> Option<PathBuf> {
        kind.candidates(name)
            .iter()
            .flat_map(|candidate| self.folders().map(move |folder| folder.join(candidate)))
            .find(|path| path.exists())
    }

    /// Whether `file_exists` says so: no extension is added.
    pub fn exists(&self, name: &str) -> bool {
        self.find(name, FileKind::Other(&[])).is_some_and(|path| path.is_file())
    }

    /// Opens a file for writing, relative to the current folder.
    pub fn create(&self, name: &str, append: bool) -> io::Result<std::fs::File> {
        let mut options = std::fs::OpenOptions::new();
        options.create(true).write(true).append(append).truncate(!append);
        options.open(self.permissions.check_write(&self.current.join(name))?)
    }

    /// Finds and reads a file.
    pub fn open(&self, name: &str, kind: FileKind) -> Result<(PathBuf, Vec<u8>), Missing> {
        let Some(path) = self.find(name, kind) else {
            let embedded = kind.candidates(name).into_iter().find_map(|name| super::embedded::find(&name));
            return match embedded {
                Some(text) if kind == FileKind::Include => Ok((PathBuf::new(), text.into())),
                _ => Err(Missing::NotFound(self.folders().map(Path::to_owned).collect())),
            };
        };
        if path.is_dir() {
            return Err(Missing::Folder(path));
        }
        match self.permissions.check_read(&path).and_then(|()| read(&path)) {
            Ok(bytes) => Ok((path, bytes)),
            Err(error) => Err(Missing::Unreadable(path, error)),
        }
    }
}

/// Bytes of the longest file that is read; text of more has no spans.
const LONGEST: u64 = u32::MAX as u64;

/// Reads a file that has an end.
fn read(path: &Path) -> io::Result<Vec<u8>> {
    let file = std::fs::metadata(path)?;
    if !file.is_file() {
        return Err(io::Error::new(io::ErrorKind::InvalidInput, "it is no ordinary file"));
    }
    if file.len() > LONGEST {
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, "it is longer than 4 GiB"));
    }
    std::fs::read(path)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_known_extension_is_tried_first_and_an_unknown_one_last() {
        assert_eq!(FileKind::Include.candidates("a.inc"), ["a.inc", "a.inc.inc", "a.inc.INC"]);
        assert_eq!(FileKind::Include.candidates("a"), ["a.inc", "a.INC", "a"]);
    }

    #[test]
    fn library_paths_are_searched_in_order_and_the_scene_folder_last() {
        let dir = tempfile::tempdir().unwrap();
        let folder = |name: &str| {
            let path = dir.path().join(name);
            std::fs::create_dir(&path).unwrap();
            path
        };
        let (current, first, scene) = (folder("current"), folder("first"), folder("scene"));
        std::fs::write(scene.join("b.inc"), "scene").unwrap();
        let library =
            Library { current, paths: vec![first.clone()], scene: Some(scene), ..Library::default() };
        assert_eq!(library.open("b", FileKind::Include).unwrap().1, b"scene");
        std::fs::write(first.join("b.inc"), "first").unwrap();
        assert_eq!(library.open("b.inc", FileKind::Include).unwrap().1, b"first");
        assert!(library.exists("b.inc") && !library.exists("b"));
    }
}
