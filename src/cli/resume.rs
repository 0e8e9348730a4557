//! Going on with a picture that was begun (docs/spec/camera-image.md 21).

use std::path::PathBuf;

use super::job::Job;
use super::state::{Found, State};
use super::stop;
use crate::options::Region;
use crate::render::{Progress, Sample};

/// Begins to keep what is finished of a picture, and finds what an earlier run has left of it.
pub(super) fn begin(job: &Job, path: PathBuf, fingerprint: u64, say: &mut dyn FnMut(&str)) -> Option<State> {
    let name = path.display().to_string();
    match State::open(path, fingerprint, job.continue_trace) {
        Ok((state, found)) => {
            match found {
                Found::Nothing => {}
                Found::Pixels(pixels) => {
                    let total = job.render.region.area();
                    say(&format!("Continuing from {name}: {pixels} of {total} pixels are there."));
                }
                Found::Another => say(&format!(
                    "{name} is of another scene, size or way to render; the picture is begun anew."
                )),
            }
            Some(state)
        }
        Err(error) => {
            say(&format!("cannot keep {name}: {error}; the picture cannot be continued."));
            None
        }
    }
}

/// Watches a rendering, keeps what is finished of it, and ends it when the user wishes.
pub(super) struct Resume<'a> {
    progress: &'a dyn Progress,
    state: Option<&'a State>,
}

impl<'a> Resume<'a> {
    /// Watches for somebody; without a state nothing is kept.
    pub(super) fn new(progress: &'a dyn Progress, state: Option<&'a State>) -> Self {
        Self { progress, state }
    }
}

impl Progress for Resume<'_> {
    fn advance(&self, done: u64, total: u64) {
        stop::hold_if_stopping();
        self.progress.advance(done, total);
    }

    fn known(&self, block: &Region) -> Option<Vec<Sample>> {
        self.state?.take(block)
    }

    fn keep(&self, block: &Region, pixels: &[Sample]) {
        if let Some(state) = self.state {
            state.add(block, pixels);
        }
    }
}
