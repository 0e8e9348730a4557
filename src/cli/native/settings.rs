//! povista's arguments as POV-Ray's options, so that both command lines mean the same.

use super::args::Scene;
use crate::cli::Problem;
use crate::cli::povray::Environment;
use crate::cli::settings::{Name, Settings, Value};

/// Reads INI files, then what a scene's text can see.
///
/// # Errors
/// An INI file cannot be read, or a declaration has no name.
pub(super) fn of_scene(scene: &Scene) -> Result<Settings, Problem> {
    let environment = Environment::of_process();
    let mut settings = Settings::default();
    environment.read(&mut settings)?;
    if let Some(scene) = &scene.scene {
        settings.set(Name::InputFileName, Value::Text(scene.clone()));
    }
    for folder in &scene.library {
        settings.add_library_path(folder);
    }
    environment.add_last_path(&mut settings);
    for constant in &scene.declare {
        settings.declare(constant)?;
    }
    if let Some(clock) = scene.clock {
        settings.set(Name::Clock, Value::Float(clock));
    }
    Ok(settings)
}
