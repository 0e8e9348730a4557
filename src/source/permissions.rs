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
    /// Whether what is hidden in it counts too.
    hidden: bool,
}

/// The folders whose files may be used; all of them unless said otherwise.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Permissions {
    /// For reading; `None` for any.
    pub read: Option<Vec<Folder>>,
    /// For writing; `None` for any.
    pub write: Option<Vec<Folder>>,
    /// Whether the user wrote them down.
    pub written: bool,
    /// Whether they hold for pictures too, which go where the user says otherwise.
    pub pictures: bool,
}

impl Folder {
    /// A folder, with all in it if `deep`; a relative one is meant from the current folder.
    pub fn new(path: &Path, deep: bool) -> Self {
        Self { path: real(path), deep, hidden: true }
    }

    /// A folder a scene may write in without being asked: with all in it but what is hidden, such as `.ssh`.
    pub fn open(path: &Path) -> Self {
        Self { hidden: false, ..Self::new(path, true) }
    }

    fn holds(&self, file: &Path) -> bool {
        let Ok(below) = file.strip_prefix(&self.path) else { return false };
        let hides = |part: Component| part.as_os_str().as_encoded_bytes().starts_with(b".");
        (self.deep || below.components().count() == 1) && (self.hidden || !below.components().any(hides))
    }
}

impl Permissions {
    /// Writing in these folders only, reading anywhere.
    pub fn write_only_in(folders: Vec<Folder>) -> Self {
        Self { write: Some(folders), ..Self::default() }
    }

    /// Permits to write in one more folder.
    pub fn allow_write(&mut self, folder: &Path) {
        if let Some(folders) = &mut self.write {
            folders.push(Folder::new(folder, true));
        }
    }

    /// Refuses to read what may not be read.
    ///
    /// # Errors
    /// The file is in none of the folders for reading.
    pub fn check_read(&self, path: &Path) -> io::Result<()> {
        match &self.read {
            Some(folders) => self.check(folders, &real(path), "reading"),
            None => Ok(()),
        }
    }

    /// Refuses to write what may not be written, and follows links: what is to be written.
    ///
    /// # Errors
    /// The file is in none of the folders for writing, or is no ordinary file.
    pub fn check_write(&self, path: &Path) -> io::Result<PathBuf> {
        let Some(folders) = &self.write else { return Ok(path.to_owned()) };
        let file = real(path);
        self.check(folders, &file, "writing")?;
        match file.metadata() {
            Ok(found) if !found.is_file() => {
                Err(io::Error::new(io::ErrorKind::PermissionDenied, "it is no ordinary file"))
            }
            _ => Ok(file),
        }
    }

    /// Refuses a picture where the user did not put it: outside of the folder they named, by a link.
    ///
    /// # Errors
    /// A link leads out of the picture's folder to where nothing may be written.
    pub fn check_picture(&self, path: &Path) -> io::Result<()> {
        let folder = path.parent().map(real);
        let device = path.metadata().is_ok_and(|found| !found.is_file());
        if !self.pictures && (device || real(path).parent() == folder.as_deref()) {
            return Ok(());
        }
        self.check_write(path).map(drop)
    }

    fn check(&self, folders: &[Folder], file: &Path, what: &str) -> io::Result<()> {
        if folders.iter().any(|folder| folder.holds(file)) {
            return Ok(());
        }
        let message = match self.written {
            true => format!("{what} there is not permitted by povray.conf"),
            false => format!("{what} there is not permitted; permit a folder with `--allow-write`"),
        };
        Err(io::Error::new(io::ErrorKind::PermissionDenied, message))
    }
}

/// Links that are followed one after another.
const MOST_LINKS: u32 = 40;

/// A path without links as far as it exists, and without `..` beyond.
fn real(path: &Path) -> PathBuf {
    real_within(path, MOST_LINKS)
}

fn real_within(path: &Path, links: u32) -> PathBuf {
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
        } else if links > 0
            && let Ok(target) = real.read_link()
        {
            // What a link leads to need not exist yet.
            real.pop();
            real = real_within(&real.join(target), links - 1);
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
        let folders = vec![
            Folder::new(&root.join("flat"), false),
            Folder::new(&root.join("deep"), true),
            Folder::open(&root.join("open")),
        ];
        let permissions = Permissions::write_only_in(folders);
        let rows = [
            ("flat/a.txt", true),
            ("flat/inner/a.txt", false),
            ("flat/inner/../a.txt", true),
            ("flat/../a.txt", false),
            ("flat/.a", true),
            ("deep/inner/a.txt", true),
            ("deep/.inner/a.txt", true),
            ("open/inner/a.txt", true),
            ("open/.a", false),
            ("open/.ssh/config", false),
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
        use std::os::unix::fs::symlink;
        let folder = tempfile::tempdir().unwrap();
        let inside = folder.path().join("inside");
        std::fs::create_dir(&inside).unwrap();
        std::fs::write(folder.path().join("secret"), "").unwrap();
        let rows = [
            ("link", "../secret"),
            ("dangling", "../new"),
            ("folder", ".."),
            ("loop", "loop"),
            ("ok", "a.txt"),
        ];
        for (name, target) in rows {
            symlink(target, inside.join(name)).unwrap();
        }
        let allowed = vec![Folder::open(&inside)];
        let permissions =
            Permissions { read: Some(allowed.clone()), write: Some(allowed), ..Permissions::default() };
        assert!(permissions.check_read(&inside.join("link")).is_err());
        for (name, permitted) in [
            ("link", false),
            ("dangling", false),
            ("folder/new", false),
            ("folder/inside/new", true),
            ("ok", true),
            ("none", true),
        ] {
            assert_eq!(permissions.check_write(&inside.join(name)).is_ok(), permitted, "{name}");
        }
        // A picture may go anywhere the user says, but not where a link there leads.
        assert!(permissions.check_picture(&folder.path().join("picture.png")).is_ok());
        assert!(permissions.check_picture(&inside.join("link")).is_err());
        assert!(permissions.check_picture(&inside.join("dangling")).is_err());
        assert!(permissions.check_picture(Path::new("/dev/null")).is_ok());
        assert_eq!(permissions.check_write(&inside.join("ok")).unwrap().file_name(), Some("a.txt".as_ref()));
    }
}
