//! POV-Ray's own command line: switches, options, INI files, and the console its users know.

mod benchmark;
mod console;
mod ini;
mod lookup;
mod streams;
mod switch;
mod words;
mod wrap;

use std::io::Write;

pub(super) use benchmark::is_asked as asks_for_benchmark;
pub use lookup::Environment;
pub use words::{is_povray, read};

use super::exit;
use super::failure::Failure;
use super::job::Job;
use super::problem::Problem;
use super::restrictions::Restrictions;
use super::run;
use super::settings::{Name, Settings};
use console::Console;
use streams::{Files, Streams};

/// What `--version` says first; programs look for the name and the number.
const VERSION: &str = concat!(
    "POV-Ray 3.7 work-alike: povista ",
    env!("CARGO_PKG_VERSION"),
    "\nReads POV-Ray's scenes, switches and INI files. Not part of POV-Ray.\n"
);

/// What `--help` says.
const HELP: &str = "\
Usage: povray [+/-SWITCH ...] [Option=value ...] [FILE.ini[section] ...] SCENE.pov

  +Iname  scene            +Oname  output, - is stdout   +FN +FP +FT +FC +FB +FJ +FH +FE  format
  +Wn +Hn size             +A0.x   antialias             +AMn +Rn +Jx +AGx  how
  +Qn     quality 0..9     +WTn    threads               +SRx +ERx +SCx +ECx  part of the picture
  +Lpath  library path     +Kx     clock                 +KFIn +KFFn +KIx +KFx  animation
  +UA     store alpha      -F      no output file        +GIname  write these options as an INI file

  --benchmark | -benchmark     render the built-in scene, store nothing, tell the time
  --version | -version | --V   print the version
  --help | -help | -h | -?     print this text
";

/// Runs a command line of POV-Ray's and returns the exit code.
///
/// Text is POV-Ray's, in plain ASCII, for programs that read it.
pub(super) fn main(words: &[String], err: &mut (dyn Write + Send)) -> u8 {
    let answer = words.iter().find_map(|word| match word.as_str() {
        "--version" | "-version" | "--V" => Some(VERSION),
        "--help" | "-help" | "-h" | "-?" => Some(HELP),
        _ => None,
    });
    if let Some(answer) = answer {
        let _ = err.write_all(answer.as_bytes());
        return exit::SUCCESS;
    }
    let _ = err.write_all(VERSION.as_bytes());
    if asks_for_benchmark(words) {
        let _ = err.write_all(benchmark::GREETING.as_bytes());
    }
    let read = job(words).and_then(|(settings, job)| {
        let first = job.animation.frames().next().and_then(|frame| job.place(&frame));
        let files = Files::open(&settings, console::folder(first.as_ref()), &job.permissions)?;
        Ok((settings, job, files))
    });
    let (settings, job, files) = match read {
        Ok(read) => read,
        Err(problem) => {
            let _ = err.write_all(console::options_problem(words, &problem).as_bytes());
            return exit::FAILURE;
        }
    };
    let verbose = settings.bool(Name::Verbose) == Some(true);
    let streams = Streams::new(err, &settings, files);
    let mut console = Console::new(streams, verbose, job.animation.frames().count());
    for warning in &job.warnings {
        console.warn(warning);
    }
    let result = run::run(&job, &mut console);
    console.end(&result);
    match result {
        Ok(()) => exit::SUCCESS,
        Err(Failure::Abandoned) => exit::ABANDONED,
        Err(_) => exit::FAILURE,
    }
}

/// Reads INI files and a command line into what there is to do.
///
/// # Errors
/// A word, an INI file or a value is wrong.
pub(super) fn job(words: &[String]) -> Result<(Settings, Job), Problem> {
    if asks_for_benchmark(words) {
        return benchmark::job(words);
    }
    let environment = Environment::of_process();
    let mut settings = Settings::default();
    environment.read(&mut settings)?;
    for word in words {
        read(word, &mut settings)?;
    }
    environment.add_last_path(&mut settings);
    let job = Job::new(&settings, Restrictions::read(environment.home.as_deref()))?;
    if let Some(path) = settings.text(Name::CreateIni) {
        let written = match settings.is_found(Name::CreateIni) {
            true => job.permissions.check_write(path.as_ref()),
            false => Ok(path.into()),
        };
        written
            .and_then(|path| std::fs::write(path, settings.to_string()))
            .map_err(|error| Problem::io("write", path.as_ref(), &error))?;
    }
    Ok((settings, job))
}
