//! Time against error for every way to sample, over scenes of eight kinds, with POV-Ray's own curves:
//! `cargo bench --bench time_vs_error`. Leaves its table, CSV and plot in `benches/results`.

use std::path::Path;
use std::process::{Command, ExitCode};

/// One scene for each kind of difficulty.
const SCENES: [&str; 8] = ["edges", "checker", "glass", "csg", "mesh", "textured", "soft_shadow", "flake"];

fn main() -> ExitCode {
    // `cargo test --benches` only wants to know whether it starts.
    if std::env::args().any(|word| word == "--test") {
        return ExitCode::SUCCESS;
    }
    let here = Path::new(env!("CARGO_MANIFEST_DIR")).join("benches");
    let run = Command::new(env!("CARGO_BIN_EXE_povista"))
        .arg("bench")
        .args(SCENES.map(|name| here.join("scenes/sampling").join(name).with_extension("pov")))
        .arg("--output")
        .arg(here.join("results"))
        .status();
    match run {
        Ok(status) if status.success() => ExitCode::SUCCESS,
        _ => ExitCode::FAILURE,
    }
}
