//! `povista diff`: how far two pictures are apart.

use std::io::Write;

use super::args::Diff;
use crate::cli::Problem;
use crate::cli::failure::Failure;
use crate::cli::picture;

/// Compares two pictures; tells whether they are as near as was asked.
///
/// # Errors
/// A picture cannot be read, their sizes differ, or the map cannot be written.
pub(super) fn diff(arguments: &Diff, out: &mut dyn Write) -> Result<bool, Failure> {
    let (ours, theirs) = (picture::read(&arguments.ours)?, picture::read(&arguments.theirs)?);
    let difference = picture::compare(&ours, &theirs)?;
    if let Some(path) = &arguments.output {
        picture::write(&picture::heat_map(&ours, &theirs), path)?;
    }
    if arguments.json {
        let json = serde_json::to_string(&difference).map_err(|error| Problem::new(error.to_string()))?;
        writeln!(out, "{json}")?;
    } else {
        writeln!(out, "{difference}")?;
    }
    Ok(arguments.threshold.is_none_or(|threshold| difference.max <= threshold))
}
