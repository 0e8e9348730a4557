//! `povista lsp`: what an editor wants to know.

use super::args::{Lsp, Scene};
use super::settings;
use crate::cli::failure::Failure;
use crate::cli::problem::Problem;
use crate::lsp::{self, Options};

/// Answers an editor on standard input and output until it leaves.
///
/// # Errors
/// The editor doesn't keep to the protocol.
pub(super) fn lsp(arguments: Lsp) -> Result<(), Failure> {
    // The scenes are those the editor opens; options are read as for any.
    let scene = Scene {
        scene: Some("-".to_owned()),
        library: arguments.library,
        declare: Vec::new(),
        max_steps: Some(arguments.max_steps),
        max_memory: Some(arguments.max_memory),
        allow_write: Vec::new(),
        allow_shell: false,
        clock: None,
    };
    let job = settings::job(&scene, &settings::of_scene(&scene)?)?;
    let options = Options { language: job.first_language(), permissions: job.permissions };
    let (connection, threads) = lsp_server::Connection::stdio();
    lsp::serve(&connection, &options).map_err(|trouble| Problem::new(trouble.to_string()))?;
    drop(connection);
    Ok(threads.join()?)
}
