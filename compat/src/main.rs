//! `povista-compat`: povista beside POV-Ray on the same scenes.

use std::io;
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Duration;

use clap::Parser;

use povista_compat::cache::Cache;
use povista_compat::expectations::Expectations;
use povista_compat::program::Program;
use povista_compat::reading;
use povista_compat::report::{self, Report};
use povista_compat::scene::{Places, Scene};
use povista_compat::suite::{Case, Suite};
use povista_compat::timing;

/// Renders scenes with Debian's povray and with povista and reports how far the pictures agree.
#[derive(Parser)]
#[command(name = "povista-compat", version)]
struct Arguments {
    /// `quick`, `all`, `list-examples` (renews compat/examples.txt), or scenes and folders
    #[arg(default_value = "quick")]
    targets: Vec<String>,
    /// Time both programs in turn, with no cache and nothing beside; with --check, their reading alone
    #[arg(long)]
    time: bool,
    /// Pairs of runs per scene when timing; the least time counts
    #[arg(long, default_value_t = 5)]
    rounds: usize,
    /// Threads of both programs when timing
    #[arg(long, default_value_t = 1)]
    threads: u32,
    /// Switches for both programs, after those of the scene, such as "+W640 +H480"
    #[arg(long, value_name = "SWITCHES", default_value = "", allow_hyphen_values = true)]
    switches: String,
    /// Only what keeps scenes from matching, counted
    #[arg(long)]
    summary: bool,
    /// Write what was found into compat/expectations
    #[arg(long)]
    update: bool,
    /// Only have povista read the scenes, and count what it can't
    #[arg(long)]
    check: bool,
    /// Only render and keep POV-Ray's pictures
    #[arg(long)]
    references: bool,
    /// Scenes in work at once [default: one and a half per core]
    #[arg(long)]
    jobs: Option<usize>,
    /// Processor seconds either program may use for a scene
    #[arg(long, default_value_t = 120)]
    limit: u64,
    /// Folder for report.json and report.html [default: compat/report]
    #[arg(long)]
    report: Option<PathBuf>,
}

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("povista-compat: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Does what is asked; false if a scene isn't as expected.
fn run(arguments: &Arguments) -> io::Result<bool> {
    let places = Places::here();
    let limit = Duration::from_secs(arguments.limit);
    if arguments.targets == ["list-examples"] {
        return list_examples(&places, arguments, limit);
    }
    let scenes = scenes(&places, arguments)?;
    if arguments.check && arguments.time {
        return time_reading(&scenes, arguments, limit);
    }
    if arguments.check {
        let readings = reading::read(&Program::povista()?, &scenes, jobs(arguments)?, limit)?;
        print!("{}", report::readings(&readings));
        return Ok(readings.iter().all(|reading| reading.error.is_none()));
    }
    let suite = Suite { povista: povista(arguments)?, ..suite(&places, arguments, limit)? };
    let mut cases = compare(&suite, &scenes)?;
    if let Some(povista) = suite.povista.as_ref().filter(|_| arguments.time) {
        time(&suite.povray, povista, &scenes, &mut cases, arguments)?;
    }
    let report = Report {
        povray: &suite.povray.version,
        povista: suite.povista.as_ref().map_or("", |povista| &povista.version),
        cases: &cases,
    };
    if arguments.references {
        print!("{}", report::cases(&report));
        return Ok(true);
    }
    let list = places.list("expectations");
    let expectations = Expectations::read(&list)?;
    let folder = arguments.report.clone().unwrap_or_else(|| places.list("report"));
    report.write(&folder, |scene| expectations.reason(scene).map(str::to_owned))?;
    print!("{}", if arguments.summary { report::features(&report) } else { report::cases(&report) });
    println!("see {}", folder.join("report.html").display());
    if arguments.update {
        expectations.updated(&cases).write(&list)?;
        return Ok(true);
    }
    let mut surprises = expectations.surprises(&cases);
    if arguments.targets == ["all"] {
        surprises.extend(expectations.unknown(scenes.iter().map(|scene| scene.name.as_str())));
    }
    for surprise in &surprises {
        eprintln!("not as expected: {surprise}");
    }
    Ok(surprises.is_empty())
}

/// The scenes the targets stand for, with the switches asked for added.
fn scenes(places: &Places, arguments: &Arguments) -> io::Result<Vec<Scene>> {
    let mut scenes = Vec::new();
    for target in &arguments.targets {
        scenes.extend(match target.as_str() {
            "quick" => places.quick()?,
            "all" => places.all()?,
            path => {
                places.under(path.as_ref()).map_err(|e| io::Error::new(e.kind(), format!("{path}: {e}")))?
            }
        });
    }
    for scene in &mut scenes {
        scene.switches.extend(arguments.switches.split_whitespace().map(str::to_owned));
    }
    Ok(scenes)
}

fn povista(arguments: &Arguments) -> io::Result<Option<Program>> {
    if arguments.references { Ok(None) } else { Program::povista().map(Some) }
}

fn jobs(arguments: &Arguments) -> io::Result<usize> {
    let cores = thread::available_parallelism()?.get();
    Ok(arguments.jobs.unwrap_or(cores + cores.div_ceil(2)))
}

/// A suite with POV-Ray alone.
fn suite(places: &Places, arguments: &Arguments, limit: Duration) -> io::Result<Suite> {
    Ok(Suite {
        povray: Program::povray()?,
        povista: None,
        cache: Cache::here(places)?,
        jobs: jobs(arguments)?,
        limit,
    })
}

/// Compares the scenes, telling each on standard error as it is done.
fn compare(suite: &Suite, scenes: &[Scene]) -> io::Result<Vec<Case>> {
    let done = AtomicUsize::new(0);
    suite.compare(scenes, |case| {
        let count = done.fetch_add(1, Ordering::Relaxed) + 1;
        eprintln!("[{count}/{}] {} {}", scenes.len(), case.verdict, case.scene);
    })
}

/// Times the scenes both programs render.
fn time(
    povray: &Program,
    povista: &Program,
    scenes: &[Scene],
    cases: &mut [Case],
    arguments: &Arguments,
) -> io::Result<()> {
    let limit = Duration::from_secs(arguments.limit);
    let rendered = scenes.iter().zip(cases).filter(|(_, case)| case.difference.is_some());
    for (scene, case) in rendered {
        eprintln!("timing {}", scene.name);
        case.times = timing::time(povray, povista, scene, arguments.threads, arguments.rounds, limit)?;
    }
    Ok(())
}

/// Times the reading of the scenes both programs read.
fn time_reading(scenes: &[Scene], arguments: &Arguments, limit: Duration) -> io::Result<bool> {
    let (povray, povista) = (Program::povray()?, Program::povista()?);
    let mut timings = Vec::new();
    for scene in scenes {
        eprintln!("timing {}", scene.name);
        let timing = timing::time_reading(&povray, &povista, scene, arguments.rounds, limit)?;
        timings.extend(timing.map(|timing| (scene.name.clone(), timing)));
    }
    print!("{}", report::reading_times(&timings));
    Ok(timings.len() == scenes.len())
}

/// Renders every installed example with POV-Ray and lists those it renders, with their seconds.
fn list_examples(places: &Places, arguments: &Arguments, limit: Duration) -> io::Result<bool> {
    let scenes = places.under(&places.examples)?;
    let suite = suite(places, arguments, limit)?;
    let cases = compare(&suite, &scenes)?;
    let mut list = format!(
        "# The scenes of Debian's povray-examples that {} renders, and the seconds it takes at 160x120.\n\
         # Made by `povista-compat list-examples`.\n",
        suite.povray.version
    );
    let rendered = cases.iter().filter(|case| case.pictures[0].is_some());
    for case in rendered.clone() {
        let name = case.scene.trim_start_matches("examples/");
        list.push_str(&format!("{name} {:.0}\n", case.reference_seconds));
    }
    std::fs::write(places.list("examples.txt"), list)?;
    println!("{} of {} examples are rendered by {}", rendered.count(), cases.len(), suite.povray.version);
    for case in cases.iter().filter(|case| case.pictures[0].is_none()) {
        println!("{}: {}", case.scene, case.message);
    }
    Ok(true)
}
