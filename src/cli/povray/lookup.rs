//! Where the first INI file is looked for (docs/spec/camera-image.md 18).

use std::env;
use std::path::{Path, PathBuf};

use super::ini;
use crate::cli::Problem;
use crate::cli::restrictions::INSTALLED;
use crate::cli::settings::{Name, Settings, Value};

/// The INI file of the current folder, which is read unasked and may have come along with a scene.
const HERE: &str = "povray.ini";

/// What the surroundings say about INI files and include folders.
#[derive(Debug, Clone, Default)]
pub struct Environment {
    /// `POVINI`: an INI file that goes before all others.
    pub povini: Option<PathBuf>,
    /// `POVINC`: a folder searched last.
    pub povinc: Option<PathBuf>,
    /// The user's home.
    pub home: Option<PathBuf>,
}

impl Environment {
    /// The surroundings of this process.
    pub fn of_process() -> Self {
        let path = |name| env::var_os(name).filter(|value| !value.is_empty()).map(PathBuf::from);
        Self { povini: path("POVINI"), povinc: path("POVINC"), home: path("HOME") }
    }

    /// Reads the first INI file that exists; without one, what a packaged POV-Ray would say.
    ///
    /// # Errors
    /// The file exists but cannot be read.
    pub fn read(&self, settings: &mut Settings) -> Result<(), Problem> {
        let home = |name: &str| self.home.as_ref().map(|home| home.join(name));
        let candidates = [
            self.povini.clone(),
            Some(PathBuf::from(HERE)),
            home(".povray/3.7/povray.ini"),
            Some(PathBuf::from("/etc/povray/3.7/povray.ini")),
            home(".povrayrc"),
            Some(PathBuf::from("/usr/local/etc/povray/3.7/povray.ini")),
        ];
        match candidates.into_iter().flatten().find(|path| path.is_file()) {
            Some(path) => {
                settings.finding = path == Path::new(HERE);
                let read = ini::read_file(&path, None, settings, 0);
                settings.finding = false;
                read
            }
            None => {
                as_packaged(settings);
                Ok(())
            }
        }
    }

    /// Adds the folder that is searched after all others.
    pub fn add_last_path(&self, settings: &mut Settings) {
        if let Some(path) = self.povinc.as_deref().and_then(Path::to_str) {
            settings.add_library_path(path);
        }
    }
}

/// What a packaged `povray.ini` sets, so that a machine without POV-Ray gets pictures of the same size.
fn as_packaged(settings: &mut Settings) {
    settings.set(Name::Width, Value::Int(800));
    settings.set(Name::Height, Value::Int(600));
    settings.set(Name::Verbose, Value::Bool(true));
    for folder in INSTALLED.into_iter().filter(|folder| Path::new(folder).is_dir()) {
        settings.add_library_path(folder);
        settings.add_library_path(&format!("{folder}/ini"));
        settings.add_library_path(&format!("{folder}/include"));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn povini_goes_before_the_file_at_home_and_replaces_it() {
        let folder = tempfile::tempdir().expect("a folder for the test");
        let home = folder.path().join("home");
        fs::create_dir_all(home.join(".povray/3.7")).expect("the folder takes folders");
        fs::write(home.join(".povray/3.7/povray.ini"), "Width=5\nHeight=6").expect("the folder takes files");
        fs::write(folder.path().join("mine.ini"), "Width=7").expect("the folder takes files");

        let mut environment = Environment { home: Some(home), ..Environment::default() };
        let mut settings = Settings::default();
        environment.read(&mut settings).expect("the file at home is read");
        assert_eq!((settings.int(Name::Width), settings.int(Name::Height)), (Some(5), Some(6)));

        environment.povini = Some(folder.path().join("mine.ini"));
        let mut settings = Settings::default();
        environment.read(&mut settings).expect("the named file is read");
        assert_eq!((settings.int(Name::Width), settings.int(Name::Height)), (Some(7), None));
    }

    #[test]
    fn the_folder_of_povinc_is_searched_last() {
        let environment = Environment { povinc: Some("last".into()), ..Environment::default() };
        let mut settings = Settings::default();
        settings.add_library_path("first");
        environment.add_last_path(&mut settings);
        assert_eq!(settings.library_paths, [PathBuf::from("first"), PathBuf::from("last")]);
    }
}
