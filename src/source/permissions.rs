//! Which files a scene may read and write (docs/spec/camera-image.md 18).

use std::io;
use std::path::{Component, Path, PathBuf};

/// A folder whose files may be used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Folder {
    /// The folder, as absolute and as real as it can be said.
    path: PathBuf,
    /// Whether the folders in it count too.
    deep: bool,
}

/// The folders whose files may be used; all of them unless said otherwise.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Permissions {
    /// For reading; `None` for any.
    pub read: Option<Vec<Folder>>,
    /// For writing; `None` for any.
    pub write: Option<Vec<Folder>>,
}

impl Folder {
    /// A folder, with all in it if `deep`; a relative one is meant from the current folder.
    pub fn new(path: &Path, deep: bool) -> Self {
        Self { path: real(path), deep }
    }

    fn holds(&self, file: &Path) -> bool {
        if self.deep { file.starts_with(&self.path) } else { file.parent() == Some(&self.path) }
    }
}

impl Permissions {
    /// Refuses to read what may not be read.
    ///
    /// # Errors
    /// The file is in none of the folders for reading.
    pub fn check_read(&self, path: &Path) -> io::Result<()> {
        check(self.read.as_deref(), path, "reading")
    }

    /// Refuses to write what may not be written.
    ///
    /// # Errors
    /// The file is in none of the folders for writing.
    pub fn check_write(&self, path: &Path) -> io::Result<()> {
        check(self.write.as_deref(), path, "writing")
    }
}

fn check(folders: Option<&[Folder]>, path: &Path, what: &str) -> io::Result<()> {
    let Some(folders) = folders else { return Ok(()) };
    let file = real(path);
    if folders.iter().any(|folder| folder.holds(&file)) {
        return Ok(());
    }
    let message = format!("{what} there is not permitted by povray.conf");
    Err(io::Error::new(io::ErrorKind::PermissionDenied, message))
}

/// A path without links as far as it exists, and without `..` beyond.
fn real(path: &Path) -> PathBuf {
    let absolute = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    let mut real = PathBuf::new();
    for component in absolute.components() {
        match component {
            Component::ParentDir => {
                real.pop();
            }
            other => real.push(other),
        }
        if let Ok(found) = real.canonicalize() {
            real = found;
        }
    }
    real
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_permitted_by_their_folder() {
        let folder = tempfile::tempdir().unwrap();
        let root = folder.path();
        std::fs::create_dir_all(root.join("flat/inner")).unwrap();
        std::fs::create_dir_all(root.join("deep/inner")).unwrap();
        let permissions = Permissions {
            read: None,
            write: Some(vec![Folder::new(&root.join("flat"), false), Folder::new(&root.join("deep"), true)]),
        };
        let rows = [
            ("flat/a.txt", true),
            ("flat/inner/a.txt", false),
            ("flat/inner/../a.txt", true),
            ("flat/../a.txt", false),
            ("deep/inner/a.txt", true),
            ("deep/new/../../a.txt", false),
            ("deeper/a.txt", false),
        ];
        for (name, permitted) in rows {
            assert_eq!(permissions.check_write(&root.join(name)).is_ok(), permitted, "{name}");
            assert!(permissions.check_read(&root.join(name)).is_ok());
        }
    }

    #[cfg(unix)]
    #[test]
    fn a_link_does_not_lead_out_of_a_folder() {
        let folder = tempfile::tempdir().unwrap();
        let inside = folder.path().join("inside");
        std::fs::create_dir(&inside).unwrap();
        std::fs::write(folder.path().join("secret"), "").unwrap();
        std::os::unix::fs::symlink(folder.path().join("secret"), inside.join("link")).unwrap();
        let permissions = Permissions { read: Some(vec![Folder::new(&inside, true)]), write: None };
        assert!(permissions.check_read(&inside.join("link")).is_err());
    }
}
