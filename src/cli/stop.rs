//! What happens when the user stops the program (docs/spec/camera-image.md 21).
//!
//! Pictures appear when they are complete and a state file ends with a whole record or is mended later, so
//! that the program may end at any moment: all there is to do is to say so and to run the commands that
//! the user wants run then.

use std::io::Write;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};

use super::exit;

/// What is still to be done; returns the exit code.
pub(super) type Ending = Box<dyn FnOnce(&mut dyn Write) -> u8 + Send>;

static STOPPING: AtomicBool = AtomicBool::new(false);
static ENDING: Mutex<Option<Ending>> = Mutex::new(None);

/// Ends whatever the program does and returns its exit code; called on a thread of its own.
pub fn stop(err: &mut dyn Write) -> u8 {
    STOPPING.store(true, Ordering::Release);
    let ending = ENDING.lock().unwrap_or_else(PoisonError::into_inner).take();
    ending.map_or(exit::ABANDONED, |ending| ending(err))
}

/// Says what a stop has to do from now on.
pub(super) fn prepare(ending: Ending) {
    *ENDING.lock().unwrap_or_else(PoisonError::into_inner) = Some(ending);
}

/// Never returns once the user has stopped the program: the thread that ends it is at work, and nothing
/// may come after what that one does.
pub(super) fn hold_if_stopping() {
    while STOPPING.load(Ordering::Acquire) {
        std::thread::park();
    }
}
