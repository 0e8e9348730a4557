//! The program as a user meets it: words in, exit codes, files and text out.

#[path = "cli/lint.rs"]
mod lint;
#[path = "cli/native.rs"]
mod native;
#[path = "cli/povray.rs"]
mod povray;
#[path = "cli/run.rs"]
mod run;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// A white sphere on a colored ground, with numbers that are light.
const SCENE: &str = "#version 3.7; global_settings { assumed_gamma 1 }
camera { }
background { rgb <0.5, 0.25, 0.7> }
sphere { z*3, 1 pigment { rgb 1 } }
light_source { <5, 5, -5> rgb 1 }
";

/// A folder with `a.pov`, in which the program runs without the user's INI files.
struct Desk {
    folder: tempfile::TempDir,
}

/// What a run left.
struct Answer {
    code: Option<i32>,
    out: Vec<u8>,
    err: String,
}

impl Desk {
    fn new() -> Self {
        let desk = Self { folder: tempfile::tempdir().unwrap() };
        desk.write("a.pov", SCENE);
        desk.write("empty.ini", "");
        desk
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn write(&self, name: &str, text: &str) {
        fs::create_dir_all(self.path(name).parent().unwrap()).unwrap();
        fs::write(self.path(name), text).unwrap();
    }

    /// Runs a command line, words apart by blanks, under a name.
    fn run_as(&self, program: &str, line: &str) -> Answer {
        let words: Vec<&str> = line.split_whitespace().collect();
        let link = self.path(program);
        if !link.exists() {
            fs::hard_link(env!("CARGO_BIN_EXE_povista"), &link)
                .or_else(|_| fs::copy(env!("CARGO_BIN_EXE_povista"), &link).map(drop))
                .unwrap();
        }
        self.start(&mut Command::new(link), &words)
    }

    fn povray(&self, line: &str) -> Answer {
        self.run_as("povray", line)
    }

    fn povista(&self, line: &str) -> Answer {
        self.run_as("povista", line)
    }

    fn start(&self, command: &mut Command, words: &[&str]) -> Answer {
        let output = command
            .args(words)
            .current_dir(self.folder.path())
            .env("POVINI", self.path("empty.ini"))
            .env("HOME", self.path("home"))
            .env_remove("POVINC")
            .stdin(Stdio::null())
            .output()
            .unwrap();
        Answer {
            code: output.status.code(),
            out: output.stdout,
            err: String::from_utf8(output.stderr).unwrap(),
        }
    }

    /// The pictures in the folder, by name.
    fn pictures(&self) -> Vec<String> {
        pictures(self.folder.path())
    }
}

/// The files in a folder that are pictures, and what an abandoned picture would leave.
fn pictures(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| {
            let extension = name.rsplit('.').next().unwrap_or_default().to_lowercase();
            ["png", "tga", "ppm", "bmp", "jpg", "hdr", "exr"].contains(&extension.as_str())
                || name.starts_with('.')
        })
        .collect();
    names.sort();
    names
}

/// The size of a picture.
fn size(path: &Path) -> (u32, u32) {
    image::image_dimensions(path).unwrap()
}
