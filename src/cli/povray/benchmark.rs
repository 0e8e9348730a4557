//! `--benchmark`: the scene that comes with the program, rendered to be timed (docs/spec/camera-image.md 16).

use super::words::read;
use crate::cli::Problem;
use crate::cli::job::Job;
use crate::cli::restrictions::Restrictions;
use crate::cli::settings::Settings;

/// What is said before the run. POV-Ray waits for the return key here; a script that sends one is not held up
/// and one that does not is not stopped.
pub(super) const GREETING: &str = "\
The built-in benchmark: povista's own scene, 512 x 512, +A0.3, not POV-Ray's, so figures of both programs
do not compare. Nothing is displayed or stored; only +WTn and +Lpath are heeded.
";

/// The scene.
const SCENE: &str = include_str!("../../../scenes/showcase.pov");

/// How it is rendered.
const WORDS: [&str; 4] = ["+W512", "+H512", "+A0.3", "-F"];

/// Whether a command line asks for the benchmark.
pub(in crate::cli) fn is_asked(words: &[String]) -> bool {
    words.iter().any(|word| word == "--benchmark" || word == "-benchmark")
}

/// What there is to do, whatever else the command line and INI files say.
///
/// # Errors
/// The number of threads or a library path cannot be read.
pub(super) fn job(words: &[String]) -> Result<(Settings, Job), Problem> {
    let mut settings = Settings::default();
    let heeded = |word: &&str| {
        let switch = word.to_ascii_uppercase();
        ["+WT", "-WT", "+L"].iter().any(|start| switch.starts_with(start))
    };
    for word in WORDS.into_iter().chain(words.iter().map(String::as_str).filter(heeded)) {
        read(word, &mut settings)?;
    }
    let job = Job::of_text("benchmark.pov", SCENE, &mut settings, Restrictions::read(None))?;
    Ok((settings, job))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(line: &str) -> Vec<String> {
        line.split_whitespace().map(str::to_owned).collect()
    }

    #[test]
    fn nothing_but_threads_and_libraries_is_heeded() {
        let line = words("--benchmark +Iother.pov +W40 +Ox.png +wt3 +L/some/where");
        assert!(is_asked(&line));
        let (_, job) = job(&line).unwrap();
        assert_eq!((job.render.width, job.render.height, job.render.threads), (512, 512, Some(3)));
        assert!(job.encoding.is_none());
        assert!(job.language.library_paths.iter().any(|path| path.ends_with("some/where")));
    }
}
