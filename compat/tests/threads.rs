//! povista's picture is the same file whatever the number of threads.

use std::time::Duration;

use povista_compat::program::{Outcome, Program};
use povista_compat::scene::{Places, Scene};

/// Processor seconds for one scene.
const LIMIT: Duration = Duration::from_secs(120);

#[test]
fn one_two_and_eight_threads_write_the_same_bytes() {
    let povista = Program::povista().unwrap_or_else(|error| panic!("{error}"));
    let mut scenes = Places::here().ours().unwrap();
    assert!(!scenes.is_empty());
    let mut rendered = 0;
    for scene in &mut scenes {
        // Antialiasing shares work between pixels, so it is where threads could show.
        scene.switches.extend(["+AM2", "+A0.1", "+J"].map(str::to_owned));
        let one = picture(&povista, scene, 1);
        rendered += usize::from(one.is_some());
        for threads in [2, 8] {
            assert!(picture(&povista, scene, threads) == one, "{} with {threads} threads", scene.name);
        }
    }
    assert!(rendered * 2 > scenes.len(), "only {rendered} of {} scenes are rendered", scenes.len());
}

/// The picture's bytes; nothing of a scene povista refuses, which the quick set judges.
fn picture(povista: &Program, scene: &Scene, threads: u32) -> Option<Vec<u8>> {
    match povista.render(scene, threads, LIMIT).unwrap().outcome {
        Outcome::Picture(png) => Some(png),
        _ => None,
    }
}
