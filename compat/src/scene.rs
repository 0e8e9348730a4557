//! The scenes to compare: where they are, what they are called, how they are rendered.

use std::collections::BTreeSet;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use walkdir::WalkDir;

/// Where Debian's `povray-examples` puts its scenes.
pub const DEBIAN_EXAMPLES: &str = "/usr/share/doc/povray/examples";

/// The switches every scene is rendered with: small, no antialiasing, no jitter, 8-bit PNG.
pub const SWITCHES: [&str; 6] = ["+W160", "+H120", "-A", "-J", "-D", "+FN8"];

/// The comment that opens a scene with switches of its own; they come after [`SWITCHES`].
const OWN_SWITCHES: &str = "// povista-compat:";

/// A scene that POV-Ray needs longer for, in seconds, is left out of the quick set.
const QUICK_SECONDS: u32 = 6;

/// The quick set takes one example in so many.
const QUICK_STEP: usize = 6;

/// One scene file and how it is rendered.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scene {
    /// The name in reports and lists: `examples/…` for Debian's, else relative to the repository.
    pub name: String,
    /// The file itself.
    pub path: PathBuf,
    /// All switches but the thread count, the input and the output.
    pub switches: Vec<String>,
    /// About how long POV-Ray takes, in seconds; 0 where nobody measured.
    pub seconds: u32,
}

impl Scene {
    /// The folder the scene lives in, which both programs see a copy of.
    pub fn folder(&self) -> &Path {
        match self.path.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        }
    }

    /// The scene's own file name.
    pub fn file_name(&self) -> String {
        self.path.file_name().unwrap_or_default().to_string_lossy().into_owned()
    }
}

/// The places scenes are found in.
#[derive(Clone, Debug)]
pub struct Places {
    /// povista's repository.
    pub repository: PathBuf,
    /// Debian's example scenes.
    pub examples: PathBuf,
}

impl Places {
    /// This repository, and the examples at `POVISTA_EXAMPLES` or where Debian installs them.
    pub fn here() -> Self {
        let repository = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let examples = std::env::var_os("POVISTA_EXAMPLES").unwrap_or(DEBIAN_EXAMPLES.into());
        Places { repository: repository.canonicalize().unwrap_or(repository), examples: examples.into() }
    }

    /// A file of the `compat` folder, such as `examples.txt`.
    pub fn list(&self, name: &str) -> PathBuf {
        self.repository.join("compat").join(name)
    }

    /// Every example that POV-Ray itself renders, from `compat/examples.txt`, then our own scenes.
    pub fn all(&self) -> io::Result<Vec<Scene>> {
        let mut scenes = self.ours()?;
        for (name, seconds) in self.example_list()? {
            scenes.push(self.example(&name, seconds)?);
        }
        Ok(scenes)
    }

    /// Our own scenes, every sixth example that is not slow, and whatever once regressed.
    pub fn quick(&self) -> io::Result<Vec<Scene>> {
        let regressed = self.regressed()?;
        let mut scenes = self.ours()?;
        for (index, (name, seconds)) in self.example_list()?.into_iter().enumerate() {
            let sampled = index % QUICK_STEP == 0 && seconds <= QUICK_SECONDS;
            if sampled || regressed.contains(&format!("examples/{name}")) {
                scenes.push(self.example(&name, seconds)?);
            }
        }
        Ok(scenes)
    }

    /// The names in `compat/regressions.txt`: scenes that matched once and then didn't.
    pub fn regressed(&self) -> io::Result<BTreeSet<String>> {
        match fs::read_to_string(self.list("regressions.txt")) {
            Ok(text) => Ok(lines(&text).map(str::to_owned).collect()),
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(BTreeSet::new()),
            Err(error) => Err(error),
        }
    }

    /// `scenes/` and `tests/render/` of this repository.
    pub fn ours(&self) -> io::Result<Vec<Scene>> {
        let mut scenes = Vec::new();
        for folder in ["scenes", "tests/render"] {
            let folder = self.repository.join(folder);
            if folder.is_dir() {
                scenes.extend(self.under(&folder)?);
            }
        }
        Ok(scenes)
    }

    /// The scene at `path`, or every scene below it, sorted by path.
    pub fn under(&self, path: &Path) -> io::Result<Vec<Scene>> {
        let path = path.canonicalize()?;
        if path.is_file() {
            return Ok(vec![self.scene(&path, 0)?]);
        }
        let mut files = Vec::new();
        for entry in WalkDir::new(&path).sort_by_file_name() {
            let file = entry?.into_path();
            if file.extension().is_some_and(|e| e.eq_ignore_ascii_case("pov")) {
                files.push(file);
            }
        }
        files.sort();
        files.iter().map(|file| self.scene(file, 0)).collect()
    }

    /// The lines of `compat/examples.txt`: a path below the examples and POV-Ray's seconds.
    fn example_list(&self) -> io::Result<Vec<(String, u32)>> {
        let list = self.list("examples.txt");
        let mut examples = Vec::new();
        for line in lines(&fs::read_to_string(&list)?) {
            let parsed = line.rsplit_once(' ').and_then(|(name, s)| Some((name, s.parse().ok()?)));
            let (name, seconds) =
                parsed.ok_or_else(|| invalid(format!("{}: want `PATH SECONDS`: {line}", list.display())))?;
            examples.push((name.to_owned(), seconds));
        }
        Ok(examples)
    }

    fn example(&self, name: &str, seconds: u32) -> io::Result<Scene> {
        let path = self.examples.join(name);
        if !path.is_file() {
            return Err(io::Error::new(
                io::ErrorKind::NotFound,
                format!("{} is missing: install Debian's povray-examples", path.display()),
            ));
        }
        self.scene(&path, seconds)
    }

    fn scene(&self, path: &Path, seconds: u32) -> io::Result<Scene> {
        let name = if let Ok(below) = path.strip_prefix(&self.examples) {
            Path::new("examples").join(below)
        } else {
            path.strip_prefix(&self.repository).unwrap_or(path).to_owned()
        };
        let mut switches: Vec<String> = SWITCHES.map(str::to_owned).to_vec();
        switches.extend(own_switches(&String::from_utf8_lossy(&fs::read(path)?)));
        Ok(Scene { name: name.to_string_lossy().into_owned(), path: path.to_owned(), switches, seconds })
    }
}

/// The lines of a list file without comments (`#`) and blanks.
pub(crate) fn lines(text: &str) -> impl Iterator<Item = &str> {
    text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#'))
}

pub(crate) fn invalid(message: String) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, message)
}

/// The switches a scene asks for in its first line.
fn own_switches(text: &str) -> Vec<String> {
    let first = text.lines().next().unwrap_or_default();
    first.strip_prefix(OWN_SWITCHES).unwrap_or_default().split_whitespace().map(str::to_owned).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn places(folder: &Path, examples: &str) -> Places {
        let root = folder.canonicalize().unwrap();
        fs::create_dir_all(root.join("repo/compat")).unwrap();
        fs::create_dir_all(root.join("repo/scenes/csg")).unwrap();
        fs::write(root.join("repo/compat/examples.txt"), examples).unwrap();
        Places { repository: root.join("repo"), examples: root.join("examples") }
    }

    fn names(scenes: &[Scene]) -> Vec<&str> {
        scenes.iter().map(|s| s.name.as_str()).collect()
    }

    #[test]
    fn first_line_carries_switches() {
        assert_eq!(own_switches("// povista-compat: +W80 +UA\nsphere{0,1}"), ["+W80", "+UA"]);
        assert!(own_switches("// a scene\n// povista-compat: +W80").is_empty());
    }

    #[test]
    fn quick_takes_every_sixth_that_is_not_slow_and_the_regressed() {
        let folder = tempfile::tempdir().unwrap();
        let list: String = (0..14).map(|i| format!("{i:02}.pov {}\n", if i == 6 { 99 } else { 1 })).collect();
        let places = places(folder.path(), &format!("# made by hand\n{list}"));
        fs::create_dir_all(&places.examples).unwrap();
        for i in 0..14 {
            fs::write(places.examples.join(format!("{i:02}.pov")), "").unwrap();
        }
        fs::write(places.list("regressions.txt"), "examples/03.pov # not a comment\nexamples/04.pov\n")
            .unwrap();
        fs::write(places.repository.join("scenes/csg/a.pov"), "").unwrap();
        fs::write(places.repository.join("scenes/csg/b.inc"), "").unwrap();
        assert_eq!(
            names(&places.quick().unwrap()),
            ["scenes/csg/a.pov", "examples/00.pov", "examples/04.pov", "examples/12.pov"]
        );
    }

    #[test]
    fn a_missing_example_names_the_package() {
        let folder = tempfile::tempdir().unwrap();
        let places = places(folder.path(), "gone.pov 1\n");
        let error = places.all().unwrap_err().to_string();
        assert!(error.contains("gone.pov is missing: install Debian's povray-examples"), "{error}");
    }

    #[test]
    fn a_list_line_without_seconds_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let error = places(folder.path(), "a.pov\n").all().unwrap_err().to_string();
        assert!(error.contains("want `PATH SECONDS`: a.pov"), "{error}");
    }
}
