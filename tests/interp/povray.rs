//! The same rows put to the installed POV-Ray: what a table promises has to be what it does.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

/// POV-Ray sleeps most of the half second it takes to start, so many run at a time.
const AT_A_TIME: usize = 12;
/// How long one scene may take.
const PATIENCE: Duration = Duration::from_secs(30);

/// What POV-Ray makes of each scene, in the words of the tables.
pub(crate) fn outcomes(scenes: &[String], current: &Path) -> Vec<String> {
    // Rows about files may meet each other's.
    let workers = if current.as_os_str().is_empty() { AT_A_TIME } else { 1 };
    let next = AtomicUsize::new(0);
    let mut found = std::thread::scope(|scope| {
        let workers: Vec<_> = (0..workers)
            .map(|_| {
                scope.spawn(|| {
                    let mut found = Vec::new();
                    while let Some((index, scene)) = {
                        let index = next.fetch_add(1, Ordering::Relaxed);
                        scenes.get(index).map(|scene| (index, scene))
                    } {
                        found.push((index, outcome(scene, current)));
                    }
                    found
                })
            })
            .collect();
        workers.into_iter().flat_map(|worker| worker.join().unwrap()).collect::<Vec<_>>()
    });
    found.sort();
    found.into_iter().map(|(_, outcome)| outcome).collect()
}

fn outcome(scene: &str, current: &Path) -> String {
    let scratch = tempfile::tempdir().unwrap();
    // Relative names in a scene count from here.
    let desk = if current.as_os_str().is_empty() { scratch.path() } else { current };
    fs::write(desk.join("scene.pov"), scene).unwrap();
    let mut povray = Command::new("povray");
    povray.args(["+Iscene.pov", "+GDdebug.out", "+GWwarnings.out"]);
    povray.args(["-F", "-D", "+W8", "+H6", "+WT1", "-GR", "-GS", "-GF"]);
    povray.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).current_dir(desk);
    let mut child = povray.spawn().expect("Debian's package `povray` is needed");
    let start = Instant::now();
    let status = loop {
        match child.try_wait().unwrap() {
            Some(status) => break status,
            None if start.elapsed() > PATIENCE => {
                child.kill().unwrap();
                child.wait().unwrap();
                return "hangs".to_owned();
            }
            None => std::thread::sleep(Duration::from_millis(20)),
        }
    };
    let read = |name: &str| {
        fs::read(desk.join(name))
            .map(|bytes| bytes.iter().map(|&byte| char::from(byte)).collect())
            .unwrap_or_default()
    };
    let (debug, warnings): (String, String) = (read("debug.out"), read("warnings.out"));
    let mut parts: Vec<String> = debug.lines().map(super::trimmed).collect();
    for (letter, words) in [("W", "Parse Warning: "), ("P", "Possible Parse Error: ")] {
        let placed = |pair: [&str; 2]| {
            pair[0].starts_with("File: ") && pair[1].starts_with(words) && !pair[1].contains("No objects")
        };
        let lines: Vec<&str> = warnings.lines().collect();
        if lines.array_windows().any(|&pair| placed(pair)) {
            parts.push(letter.to_owned());
        }
    }
    if !status.success() {
        parts.push("E".to_owned());
    }
    parts.join(" ")
}
