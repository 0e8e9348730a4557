//! Why a command ended without what it was asked for.

use std::io;

use super::Problem;

/// Why a command ended early.
#[derive(Debug)]
pub enum Failure {
    /// The scene has errors, which have been told.
    Scene,
    /// There is no scene to read.
    Missing(Problem),
    /// Something else is in the way.
    Problem(Problem),
    /// A program that ran beside the run asked for it, which has been told.
    Halted,
    /// The user stopped the run, or who reads the output has gone.
    Abandoned,
}

impl From<Problem> for Failure {
    fn from(problem: Problem) -> Self {
        Self::Problem(problem)
    }
}

/// A failure to write the output.
impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Self::Abandoned,
            _ => Self::Problem(Problem::new(format!("cannot write the output: {error}"))),
        }
    }
}
