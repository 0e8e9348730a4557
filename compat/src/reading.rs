//! povista's reading of scenes, without rendering: `povista check` on each.

use std::io;
use std::time::Duration;

use crate::parallel::each;
use crate::program::Program;
use crate::scene::Scene;

/// What `povista check` said of one scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reading {
    /// The scene's name.
    pub scene: String,
    /// The error, if it isn't read.
    pub error: Option<String>,
}

/// Reads all `scenes`, `jobs` at once; the result is in their order.
pub fn read(povista: &Program, scenes: &[Scene], jobs: usize, limit: Duration) -> io::Result<Vec<Reading>> {
    let order: Vec<usize> = (0..scenes.len()).collect();
    let read = |number: usize| {
        let scene = &scenes[number];
        Ok(Reading { scene: scene.name.clone(), error: povista.check(scene, limit)?.1 })
    };
    each(&order, jobs, read).into_iter().collect()
}
