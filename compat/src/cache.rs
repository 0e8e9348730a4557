//! POV-Ray's pictures, kept by everything they depend on.
//!
//! A picture's key is a hash of POV-Ray's version, the switches, the thread count, the scene's own
//! text and every other file in its folder (any of which the scene may include or read). Left out
//! are the other scenes of the folder and the pictures named after scenes, so that adding a scene
//! doesn't renew its neighbours. The includes installed with POV-Ray go by its version.

use std::collections::HashMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use sha2::{Digest, Sha256};
use walkdir::WalkDir;

use crate::program::{Outcome, Program, Rendering};
use crate::scene::{Places, Scene};

/// Raised when what is kept, or how POV-Ray is started, changes.
const FORMAT: &str = "povista-compat cache 1";

/// A folder of POV-Ray's pictures.
#[derive(Debug)]
pub struct Cache {
    folder: PathBuf,
    /// Hashes of scene folders: many scenes share one.
    folders: Mutex<HashMap<PathBuf, Arc<[u8]>>>,
}

impl Cache {
    /// The cache at `POVISTA_COMPAT_CACHE`, or in `compat/cache` of the repository.
    pub fn here(places: &Places) -> io::Result<Self> {
        let folder = std::env::var_os("POVISTA_COMPAT_CACHE");
        Cache::at(folder.map_or_else(|| places.list("cache"), PathBuf::from))
    }

    /// The cache in `folder`, made where it isn't.
    pub fn at(folder: PathBuf) -> io::Result<Self> {
        fs::create_dir_all(&folder)?;
        Ok(Cache { folder, folders: Mutex::default() })
    }

    /// POV-Ray's rendering of `scene`: the one kept, or a new one, then kept unless it ran out of time.
    pub fn reference(
        &self,
        povray: &Program,
        scene: &Scene,
        threads: u32,
        limit: Duration,
    ) -> io::Result<Rendering> {
        let key = self.key(povray, scene, threads)?;
        if let Some(kept) = self.kept(&key) {
            return Ok(kept);
        }
        let rendering = povray.render(scene, threads, limit)?;
        if rendering.outcome != Outcome::OutOfTime {
            self.keep(&key, &rendering)?;
        }
        Ok(rendering)
    }

    fn kept(&self, key: &str) -> Option<Rendering> {
        let record = fs::read(self.folder.join(format!("{key}.json"))).ok()?;
        let mut rendering: Rendering = serde_json::from_slice(&record).ok()?;
        if let Outcome::Picture(png) = &mut rendering.outcome {
            *png = fs::read(self.folder.join(format!("{key}.png"))).ok()?;
        }
        Some(rendering)
    }

    /// The record is written last and each file appears whole, so other runs may share the folder.
    fn keep(&self, key: &str, rendering: &Rendering) -> io::Result<()> {
        if let Outcome::Picture(png) = &rendering.outcome {
            self.write(&format!("{key}.png"), png)?;
        }
        self.write(&format!("{key}.json"), &serde_json::to_vec(rendering)?)
    }

    fn write(&self, name: &str, bytes: &[u8]) -> io::Result<()> {
        let file = tempfile::NamedTempFile::new_in(&self.folder)?;
        fs::write(file.path(), bytes)?;
        file.persist(self.folder.join(name))?;
        Ok(())
    }

    fn key(&self, povray: &Program, scene: &Scene, threads: u32) -> io::Result<String> {
        let mut hash = Sha256::new();
        for text in [FORMAT, &povray.version, &scene.file_name(), &threads.to_string()] {
            add(&mut hash, text.as_bytes());
        }
        for switch in &scene.switches {
            add(&mut hash, switch.as_bytes());
        }
        add(&mut hash, &fs::read(&scene.path)?);
        add(&mut hash, &self.folder_hash(scene.folder())?);
        Ok(hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect())
    }

    fn folder_hash(&self, folder: &Path) -> io::Result<Arc<[u8]>> {
        let mut folders = self.folders.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(hash) = folders.get(folder) {
            return Ok(hash.clone());
        }
        let mut hash = Sha256::new();
        for entry in WalkDir::new(folder).follow_links(true).sort_by_file_name() {
            let entry = entry?;
            let path = entry.path();
            let extension = path.extension().unwrap_or_default();
            let of_a_scene = extension == "png" && path.with_extension("pov").is_file();
            if entry.file_type().is_dir() || extension == "pov" || of_a_scene {
                continue;
            }
            let below = path.strip_prefix(folder).map_err(io::Error::other)?;
            add(&mut hash, below.as_os_str().as_encoded_bytes());
            add(&mut hash, &fs::read(path)?);
        }
        let hash: Arc<[u8]> = hash.finalize().as_slice().into();
        folders.insert(folder.to_owned(), hash.clone());
        Ok(hash)
    }
}

/// Adds one item with its length, so that neighbours cannot run together.
fn add(hash: &mut Sha256, bytes: &[u8]) {
    hash.update((bytes.len() as u64).to_le_bytes());
    hash.update(bytes);
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Bench {
        folder: tempfile::TempDir,
        povray: Program,
    }

    impl Bench {
        fn new() -> Self {
            let folder = tempfile::tempdir().unwrap();
            fs::create_dir(folder.path().join("scenes")).unwrap();
            fs::write(folder.path().join("scenes/a.pov"), "sphere").unwrap();
            fs::write(folder.path().join("scenes/a.inc"), "colour").unwrap();
            // Renders nothing, but says in the folder above the sandbox that it was started.
            let program = folder.path().join("povray");
            let script = format!(
                "#!/bin/sh\n[ $1 = --version ] || echo >> {}\necho 'Error: no' >&2\nexit 1\n",
                folder.path().join("runs").display()
            );
            crate::suite::tests::write_program(&program, &script);
            let povray = Program { path: program, version: "POV-Ray 3.7".to_owned() };
            Bench { folder, povray }
        }

        fn scene(&self) -> Scene {
            Scene {
                name: "a".to_owned(),
                path: self.folder.path().join("scenes/a.pov"),
                switches: vec!["+W8".to_owned()],
                seconds: 0,
            }
        }

        /// Asks a cache that starts afresh, as another run would, and counts all runs so far.
        fn runs_after(&self, scene: &Scene, threads: u32) -> usize {
            let cache = Cache::at(self.folder.path().join("cache")).unwrap();
            let rendering = cache.reference(&self.povray, scene, threads, Duration::from_secs(5)).unwrap();
            assert_eq!(rendering.outcome, Outcome::Refused("Error: no".to_owned()));
            fs::read_to_string(self.folder.path().join("runs")).unwrap().lines().count()
        }
    }

    #[test]
    fn a_kept_picture_is_not_rendered_again() {
        let bench = Bench::new();
        assert_eq!(bench.runs_after(&bench.scene(), 1), 1);
        assert_eq!(bench.runs_after(&bench.scene(), 1), 1);
    }

    #[test]
    fn whatever_changes_the_picture_renews_it() {
        let bench = Bench::new();
        let mut scene = bench.scene();
        assert_eq!(bench.runs_after(&scene, 1), 1);
        assert_eq!(bench.runs_after(&scene, 2), 2);
        scene.switches.push("+A0.3".to_owned());
        assert_eq!(bench.runs_after(&scene, 1), 3);
        fs::write(bench.folder.path().join("scenes/a.inc"), "other colour").unwrap();
        assert_eq!(bench.runs_after(&scene, 1), 4);
        fs::write(&scene.path, "box").unwrap();
        assert_eq!(bench.runs_after(&scene, 1), 5);
    }

    #[test]
    fn a_neighbour_scene_and_its_picture_renew_nothing() {
        let bench = Bench::new();
        assert_eq!(bench.runs_after(&bench.scene(), 1), 1);
        fs::write(bench.folder.path().join("scenes/c.pov"), "cone").unwrap();
        fs::write(bench.folder.path().join("scenes/c.png"), "its picture").unwrap();
        assert_eq!(bench.runs_after(&bench.scene(), 1), 1);
    }
}
