//! Where a picture goes (docs/spec/camera-image.md 19).

use std::fs::{self, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use super::Format;
use crate::cli::{Problem, state};
use crate::source::Permissions;

/// Where a picture goes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Place {
    /// Standard output.
    Stdout,
    /// Standard error.
    Stderr,
    /// A file.
    File(PathBuf),
}

impl Place {
    /// Names the file of a picture as POV-Ray does.
    ///
    /// `input` is the scene as the user named it, `given` the output name if there is one, `digits`
    /// the frame's number.
    pub fn new(input: &str, given: Option<&str>, format: Format, digits: &str) -> Self {
        let extension = format.extension();
        match given {
            Some("-" | "stdout") => return Self::Stdout,
            Some("stderr") => return Self::Stderr,
            _ => {}
        }
        let input_name = stem(file_name(input));
        let base = match given.filter(|given| !given.is_empty()) {
            None => format!("{}{input_name}", folder(input)),
            Some(given) => {
                let name = file_name(given);
                let name = if name.is_empty() || name == extension {
                    input_name
                } else {
                    name.strip_suffix(extension).or_else(|| name.strip_suffix('.')).unwrap_or(name)
                };
                format!("{}{name}", folder(given))
            }
        };
        Self::File(PathBuf::from(format!("{base}{digits}{extension}")))
    }

    /// A file of exactly the name given, with a frame's number before the extension.
    pub fn exact(given: &str, digits: &str) -> Self {
        match given.rsplit_once('.') {
            _ if given == "-" => Self::Stdout,
            Some((stem, extension)) => Self::File(PathBuf::from(format!("{stem}{digits}.{extension}"))),
            None => Self::File(PathBuf::from(format!("{given}{digits}"))),
        }
    }

    /// What the console calls it.
    pub fn name(&self) -> String {
        match self {
            Self::Stdout => "stdout".to_owned(),
            Self::Stderr => "stderr".to_owned(),
            Self::File(path) => path.display().to_string(),
        }
    }

    /// Whether a picture is there already, and not one that is about to be replaced by one that was begun.
    pub fn is_finished(&self) -> bool {
        let Self::File(path) = self else { return false };
        fs::metadata(path).is_ok_and(|file| file.is_file() && file.len() > 0)
            && !state::path_beside(path).exists()
    }

    /// Makes sure that a picture can be written there, before anything is rendered.
    ///
    /// # Errors
    /// The folder is missing, may not be written, or the name belongs to a folder.
    pub fn open(&self, permissions: &Permissions) -> Result<Opened, Problem> {
        match self {
            Self::Stdout => Ok(Opened::Stream(Box::new(io::stdout()))),
            Self::Stderr => Ok(Opened::Stream(Box::new(io::stderr()))),
            Self::File(path) => {
                permissions.check_picture(path).map_err(|error| Problem::io("write", path, &error))?;
                open_file(path)
            }
        }
    }
}

/// A place that takes a picture.
pub enum Opened {
    /// A stream or device; what is written is gone.
    Stream(Box<dyn Write>),
    /// A file that can be written; it is left alone until there is a picture.
    File(PathBuf),
}

impl Opened {
    /// Writes the whole picture; a file appears complete or not at all.
    ///
    /// # Errors
    /// The disk is full, or the reader has gone.
    pub fn finish(self, bytes: &[u8]) -> io::Result<()> {
        match self {
            Self::Stream(mut stream) => {
                stream.write_all(bytes)?;
                stream.flush()
            }
            Self::File(path) => {
                let mut file = beside(&path)?;
                file.write_all(bytes)?;
                file.persist(path)?;
                Ok(())
            }
        }
    }
}

/// Opens what will become a file.
fn open_file(path: &Path) -> Result<Opened, Problem> {
    // Follow a link, so that it stays one and the file behind it changes.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let cannot = |error: &io::Error| Problem::io("write", path, error);
    match fs::metadata(&target) {
        Ok(kind) if kind.is_dir() => {
            return Err(Problem::new(format!("cannot write `{}`: it is a folder", path.display())));
        }
        Ok(kind) if !kind.is_file() => {
            let device = OpenOptions::new().write(true).open(&target).map_err(|error| cannot(&error))?;
            return Ok(Opened::Stream(Box::new(device)));
        }
        Ok(_) => drop(OpenOptions::new().write(true).open(&target).map_err(|error| cannot(&error))?),
        Err(_) => {}
    }
    beside(&target).map_err(|error| cannot(&error))?;
    Ok(Opened::File(target))
}

/// Makes a file beside another one, which it may replace; it is gone when dropped.
fn beside(path: &Path) -> io::Result<NamedTempFile> {
    let parent = path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
    // Created as any file of the user is, with the rights their system gives new files.
    tempfile::Builder::new()
        .prefix(".povista-")
        .make_in(parent, |path| OpenOptions::new().write(true).create_new(true).open(path))
}

/// What stands before the last `/`, with it.
fn folder(path: &str) -> &str {
    &path[..path.rfind('/').map_or(0, |slash| slash + 1)]
}

/// What stands after the last `/`.
fn file_name(path: &str) -> &str {
    &path[folder(path).len()..]
}

/// A file's name without its last extension.
fn stem(name: &str) -> &str {
    name.rsplit_once('.').map_or(name, |(stem, _)| stem)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The rows of docs/spec/camera-image.md 19.
    #[test]
    fn pictures_are_named_as_povray_names_them() {
        use Format::{Bmp, CompressedTarga, Exr, Hdr, Jpeg, Png, Ppm, Targa};
        let rows = [
            ("a.pov", None, Png, "", "a.png"),
            ("a", None, Png, "", "a.png"),
            ("a.pov", None, Targa, "", "a.tga"),
            ("a.pov", None, CompressedTarga, "", "a.tga"),
            ("a.pov", None, Ppm, "", "a.ppm"),
            ("a.pov", None, Bmp, "", "a.bmp"),
            ("a.pov", None, Jpeg, "", "a.jpg"),
            ("a.pov", None, Hdr, "", "a.hdr"),
            ("a.pov", None, Exr, "", "a.exr"),
            ("a.pov", Some("foo"), Png, "", "foo.png"),
            ("a.pov", Some("foo.tga"), Png, "", "foo.tga.png"),
            ("a.pov", Some(".png"), Png, "", "a.png"),
            ("a.pov", Some("foo."), Png, "", "foo.png"),
            ("a.pov", Some("foo.PNG"), Png, "", "foo.PNG.png"),
            ("sub/a.pov", None, Png, "", "sub/a.png"),
            ("sub/a.pov", Some("foo"), Png, "", "foo.png"),
            ("sub/a.pov", Some("out/"), Png, "", "out/a.png"),
            ("a.pov", None, Png, "07", "a07.png"),
            ("a.pov", Some("foo.png"), Png, "07", "foo07.png"),
            ("a.b.pov", None, Png, "", "a.b.png"),
        ];
        for (input, given, format, digits, expected) in rows {
            assert_eq!(Place::new(input, given, format, digits).name(), expected, "{input} {given:?}");
        }
        assert_eq!(Place::new("a.pov", Some("-"), Png, ""), Place::Stdout);
        assert_eq!(Place::new("a.pov", Some("stderr"), Png, ""), Place::Stderr);
    }

    #[test]
    fn a_file_appears_only_when_it_is_complete() {
        let folder = tempfile::tempdir().expect("a folder for the test");
        let path = folder.path().join("a.png");
        let opened = Place::File(path.clone()).open(&Permissions::default()).expect("the folder takes files");
        assert!(!path.exists());
        opened.finish(b"picture").expect("the disk has room");
        assert_eq!(fs::read(&path).expect("the file is there"), b"picture");

        drop(Place::File(path.clone()).open(&Permissions::default()).expect("the folder takes files"));
        assert_eq!(fs::read(&path).expect("the file is there"), b"picture");
        assert_eq!(fs::read_dir(folder.path()).expect("the folder is there").count(), 1);
    }

    #[test]
    fn a_place_that_takes_no_file_is_known_beforehand() {
        let folder = tempfile::tempdir().expect("a folder for the test");
        assert!(Place::File(folder.path().to_owned()).open(&Permissions::default()).is_err());
        assert!(Place::File(folder.path().join("missing/a.png")).open(&Permissions::default()).is_err());
    }

    #[cfg(unix)]
    #[test]
    fn a_link_stays_a_link() {
        let folder = tempfile::tempdir().expect("a folder for the test");
        let (target, link) = (folder.path().join("target"), folder.path().join("link"));
        fs::write(&target, "old").expect("the folder takes files");
        std::os::unix::fs::symlink(&target, &link).expect("the folder takes links");
        Place::File(link.clone())
            .open(&Permissions::default())
            .expect("a link to a file")
            .finish(b"new")
            .expect("room");
        assert_eq!(fs::read(&target).expect("the file is there"), b"new");
        assert!(fs::symlink_metadata(&link).expect("the link is there").is_symlink());
    }
}
