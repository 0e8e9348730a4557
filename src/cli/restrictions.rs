//! `povray.conf`: what scenes and INI files may do to the system (docs/spec/camera-image.md 18).
//!
//! Shell-outs run only if each `povray.conf` there is allows them, and one is there. POV-Ray reads the
//! restrictions of files and paths, but enforces none; here those count that users set for themselves.
//! The system's don't: as Debian ships them, no picture could be written beside its scene. A user who sets
//! none gets [`defaults`]: scenes read anything, and write in the current folder, their own and the picture's.

use std::path::{Path, PathBuf};

use super::settings::value;
use crate::source::{Folder, Permissions};

/// Folders under which POV-Ray's packages put its include files.
pub(super) const INSTALLED: [&str; 2] = ["/usr/share/povray-3.7", "/usr/local/share/povray-3.7"];

/// The file for all users.
const SYSTEM: &str = "/etc/povray/3.7/povray.conf";

/// The file of a user, from home.
const USER: &str = ".povray/3.7/povray.conf";

/// What scenes and INI files may do.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Restrictions {
    /// Whether INI files may run programs.
    pub shellouts: bool,
    /// Which files a scene may read and write, if the user says so.
    pub files: Option<Permissions>,
    /// What is odd about the `povray.conf` files.
    pub warnings: Vec<String>,
}

impl Restrictions {
    /// Reads the restrictions of this machine and the user with this home.
    pub fn read(home: Option<&Path>) -> Self {
        let mut warnings = Vec::new();
        let mut read = |path: &Path| {
            let text = std::fs::read_to_string(path).ok()?;
            Some(Conf::read(&text, home, &mut |line, message| {
                warnings.push(format!("{}, line {line}: {message}", path.display()));
            }))
        };
        let system = read(Path::new(SYSTEM));
        let user = home.and_then(|home| read(&home.join(USER)));
        let all = [&system, &user];
        let shellouts =
            all.iter().any(|conf| conf.is_some()) && all.into_iter().flatten().all(|conf| conf.shellouts);
        Self { shellouts, files: user.map(Conf::permissions), warnings }
    }
}

/// What a scene may read and write whose user has no rules: nothing is written but in these folders.
pub fn defaults<'a>(folders: impl IntoIterator<Item = &'a Path>) -> Permissions {
    let current = |folder: &'a Path| if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    Permissions::write_only_in(folders.into_iter().map(|folder| Folder::open(current(folder))).collect())
}

/// Which files are restricted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
enum Security {
    #[default]
    None,
    ReadOnly,
    Restricted,
}

/// One file.
#[derive(Debug, Default)]
struct Conf {
    shellouts: bool,
    security: Security,
    readable: Vec<Folder>,
    writable: Vec<Folder>,
}

impl Conf {
    /// Reads a file's text; `odd` hears of lines that say nothing.
    fn read(text: &str, home: Option<&Path>, odd: &mut dyn FnMut(usize, String)) -> Self {
        let mut conf = Self::default();
        let mut section = "";
        for (number, line) in text.lines().enumerate() {
            let line = line.split(';').next().unwrap_or(line).trim();
            if let Some(name) = line.strip_prefix('[').and_then(|line| line.strip_suffix(']')) {
                section = name;
                continue;
            }
            let known = match (section, line) {
                (_, "") => true,
                ("File I/O Security", _) => conf.set_security(line),
                // What is unknown allows nothing.
                ("Shellout Security", _) => {
                    conf.shellouts = line == "allowed";
                    matches!(line, "allowed" | "forbidden")
                }
                ("Permitted Paths", _) => conf.add_path(line, home),
                _ => false,
            };
            if !known {
                odd(number + 1, format!("`{line}` means nothing under `[{section}]`"));
            }
        }
        conf
    }

    fn set_security(&mut self, word: &str) -> bool {
        self.security = match word {
            "none" => Security::None,
            "read-only" => Security::ReadOnly,
            "restricted" => Security::Restricted,
            _ => return false,
        };
        true
    }

    /// Adds a line such as `read+write* = "%HOME%/pictures"`.
    fn add_path(&mut self, line: &str, home: Option<&Path>) -> bool {
        let Some((kind, path)) = line.split_once('=') else { return false };
        let (kind, path) = (kind.trim(), path.trim());
        let path = value::quoted(path).map_or(path, |(inside, _)| inside);
        let (kind, deep) = kind.strip_suffix('*').map_or((kind, false), |kind| (kind, true));
        let folder = Folder::new(&expanded(path, home), deep);
        match kind {
            "read" => {}
            "read+write" => self.writable.push(folder.clone()),
            _ => return false,
        }
        self.readable.push(folder);
        true
    }

    fn permissions(self) -> Permissions {
        let (read, write) = (self.security == Security::Restricted, self.security != Security::None);
        let (read, write) = (read.then_some(self.readable), write.then_some(self.writable));
        Permissions { read, write, written: true, pictures: true }
    }
}

/// A path with `%INSTALLDIR%` or `%HOME%` in front replaced.
fn expanded(path: &str, home: Option<&Path>) -> PathBuf {
    let installed = INSTALLED.iter().find(|folder| Path::new(folder).is_dir()).unwrap_or(&INSTALLED[0]);
    let places = [("%INSTALLDIR%", Some(Path::new(installed))), ("%HOME%", home)];
    let place = places
        .into_iter()
        .find_map(|(word, place)| Some((path.strip_prefix(word)?.trim_start_matches('/'), place?)));
    place.map_or_else(|| PathBuf::from(path), |(rest, place)| place.join(rest))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> (Conf, Vec<usize>) {
        let mut odd = Vec::new();
        let conf = Conf::read(text, Some(Path::new("/home/me")), &mut |line, _| odd.push(line));
        (conf, odd)
    }

    #[test]
    fn shellouts_need_a_plain_yes() {
        for (text, allowed, odd) in [
            ("", false, 0),
            ("[Shellout Security]\nallowed", true, 0),
            ("[Shellout Security] ; comment\n  allowed ; or ;forbidden", true, 0),
            ("[Shellout Security]\n;allowed\nforbidden", false, 0),
            ("[Shellout Security]\nALLOWED", false, 1),
            ("[shellout security]\nallowed", false, 1),
            ("[File I/O Security]\nallowed", false, 1),
        ] {
            let (conf, lines) = read(text);
            assert_eq!((conf.shellouts, lines.len()), (allowed, odd), "{text}");
        }
    }

    #[test]
    fn paths_are_restricted_as_the_security_says() {
        let paths = "[Permitted Paths]\nread* = %HOME%\nread+write=\"/a b\"\nfoo\nwrite = /c";
        let home = Folder::new(Path::new("/home/me"), true);
        let both = Folder::new(Path::new("/a b"), false);
        let rows = [
            ("none", None, None),
            ("read-only", None, Some(vec![both.clone()])),
            ("restricted", Some(vec![home, both.clone()]), Some(vec![both])),
        ];
        for (security, read_paths, write_paths) in rows {
            let (conf, odd) = read(&format!("[File I/O Security]\n{security}\n{paths}"));
            assert_eq!(
                conf.permissions(),
                Permissions { read: read_paths, write: write_paths, written: true, pictures: true }
            );
            assert_eq!(odd, [6, 7]);
        }
    }

    #[test]
    fn a_users_file_restricts_and_nobodys_allows_nothing() {
        let folder = tempfile::tempdir().expect("a folder for the test");
        let free = Restrictions::read(Some(folder.path()));
        assert_eq!(free.files, None);
        std::fs::create_dir_all(folder.path().join(".povray/3.7")).expect("the folder takes folders");
        let text = "[File I/O Security]\nrestricted\n[Shellout Security]\nforbidden\n";
        std::fs::write(folder.path().join(USER), text).expect("the folder takes files");
        let strict = Restrictions::read(Some(folder.path()));
        assert!(!strict.shellouts);
        let (read, write) = (Some(Vec::new()), Some(Vec::new()));
        let nothing = Permissions { read, write, written: true, pictures: true };
        assert_eq!(strict.files, Some(nothing));
    }
}
