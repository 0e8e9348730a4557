//! `povista dump`: what was understood of a scene.

use std::io::Write;

use super::args::Scene;
use super::settings;
use super::teller::Teller;
use crate::cli::failure::Failure;
use crate::cli::read;

/// Shows what was understood of a scene.
///
/// # Errors
/// The scene has errors, or nobody reads the answer.
pub(super) fn dump(
    arguments: &Scene,
    out: &mut dyn Write,
    err: &mut (dyn Write + Send),
) -> Result<(), Failure> {
    let job = settings::job(arguments, &settings::of_scene(arguments)?)?;
    let (scene, _, _) = read::scene(&job, &job.first_language(), &mut Teller::new(err, false))?;
    write!(out, "{}", scene.dump())?;
    Ok(())
}
