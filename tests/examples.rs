//! Every scene and include file that POV-Ray installs is understood.

use std::path::{Path, PathBuf};

use povista::diag::Severity;
use povista::options::LanguageOptions;
use povista::source::{Library, Source};

const EXAMPLES: &str = "/usr/share/doc/povray/examples";
const INCLUDES: &str = "/usr/share/povray-3.7/include";

fn files(folder: &Path, extension: &str, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            files(&path, extension, found);
        } else if path.extension().is_some_and(|e| e == extension) {
            found.push(path);
        }
    }
    found.sort();
}

#[test]
fn examples() {
    let mut scenes = Vec::new();
    files(Path::new(EXAMPLES), "pov", &mut scenes);
    let mut good = 0;
    let filter = std::env::var("ONLY").unwrap_or_default();
    for path in &scenes {
        if !path.to_string_lossy().contains(&filter) {
            continue;
        }
        let library =
            Library { current: path.parent().unwrap().into(), paths: vec![INCLUDES.into()], scene: None };
        let scene = Source::new(path.display().to_string(), path, std::fs::read(path).unwrap());
        let start = std::time::Instant::now();
        let checked = povista::interp::check::check_with(scene, library, &LanguageOptions::default());
        let took = start.elapsed().as_secs_f64();
        if took > 2.0 {
            println!("SLOW {took:.1} {}", path.display());
        }
        if checked.failed() {
            println!("FAIL {}", path.display());
            for d in checked.diagnostics.iter().filter(|d| d.severity == Severity::Error).take(1) {
                println!("   {}", povista::diag::line(d, &checked.sources));
            }
        } else {
            good += 1;
        }
    }
    println!("{good} of {}", scenes.len());
}
