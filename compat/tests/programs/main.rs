//! Random programs that print numbers: POV-Ray and povista print the same.
//!
//! `POVISTA_PROGRAMS` says how many (200 otherwise), `POVISTA_SEED` where the seeds begin. A difference is
//! reported with the seed of its program; what was found is kept in `found`, one scene a file.

mod expression;
mod program;
mod random;

use std::fs;
use std::path::Path;
use std::thread;
use std::time::Duration;

use povista_compat::parallel;
use povista_compat::process::{Ended, Finished, Sandbox};
use povista_compat::program::Program;

/// Programs that are read in one start: POV-Ray sleeps for half a second each time.
const AT_ONCE: u64 = 100;
/// Processor time for one start.
const LIMIT: Duration = Duration::from_secs(60);
/// Difference allowed, relative to the value.
const NEAR: f64 = 1e-12;
/// Differences that are shown.
const SHOWN: usize = 12;

/// What one program prints, or that it is refused.
type Printed = Result<Vec<String>, String>;

/// Has a program read a scene, and gives the lines it prints.
fn printed(by: &Program, scene: &str) -> Printed {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("scene.pov"), scene).unwrap();
    let sandbox = Sandbox::copy_of(folder.path()).unwrap();
    let switches =
        ["+Iscene.pov", "+GDdebug.out", "-F", "-D", "+W8", "+H6", "+WT1", "-GR", "-GS", "-GF", "-GA"];
    let finished: Finished = sandbox.run(&by.path, &switches.map(str::to_owned), LIMIT).unwrap();
    let lines = fs::read(sandbox.scene_folder().join("debug.out")).unwrap_or_default();
    let lines: Vec<String> = String::from_utf8_lossy(&lines).lines().map(str::to_owned).collect();
    match finished.ended {
        Ended::Code(0) => Ok(lines),
        ended => Err(format!("{ended:?} after {} lines: {}", lines.len(), complaint(&finished.text))),
    }
}

/// What a program said on its way out.
fn complaint(text: &str) -> String {
    let lines = text.lines().skip_while(|line| !line.contains("Parse Error"));
    lines.take(4).collect::<Vec<_>>().join(" ")
}

/// Whether two lines print the same, to the last digits.
fn same(ours: &str, theirs: &str) -> bool {
    if ours == theirs {
        return true;
    }
    let (ours, theirs): (Vec<&str>, Vec<&str>) = (ours.split(' ').collect(), theirs.split(' ').collect());
    let near = |(a, b): (&&str, &&str)| {
        let number = |text: &str| text.trim_start_matches('-').parse::<f64>();
        let (Ok(x), Ok(y)) = (number(a), number(b)) else { return a == b };
        // The sign of what is no number depends on the order of operands.
        (x.is_nan() && y.is_nan())
            || a.starts_with('-') == b.starts_with('-') && (x - y).abs() <= NEAR * x.abs().max(1.0)
            || x.max(y) <= NEAR
    };
    ours.len() == theirs.len() && ours.iter().zip(&theirs).all(near)
}

/// The first difference between what both print, if any.
fn difference(ours: &Printed, theirs: &Printed) -> Option<String> {
    match (ours, theirs) {
        (Ok(ours), Ok(theirs)) => {
            let differ = ours.iter().zip(theirs).position(|(ours, theirs)| !same(ours, theirs));
            let at = differ.or((ours.len() != theirs.len()).then_some(ours.len().min(theirs.len())))?;
            let line = |lines: &[String]| lines.get(at).cloned().unwrap_or_else(|| "nothing".to_owned());
            Some(format!("line {}: {} where POV-Ray prints {}", at + 1, line(ours), line(theirs)))
        }
        (Err(_), Err(_)) => None,
        (Err(ours), Ok(_)) => Some(format!("refused: {ours}")),
        (Ok(_), Err(theirs)) => Some(format!("POV-Ray refuses it: {theirs}")),
    }
}

fn compared(programs: &[String]) -> Option<String> {
    let scene = format!("{}{}", program::PRELUDE, programs.concat());
    let (povray, povista) = (Program::povray().unwrap(), Program::povista().unwrap());
    difference(&printed(&povista, &scene), &printed(&povray, &scene))
}

fn variable(name: &str, otherwise: u64) -> u64 {
    std::env::var(name).ok().and_then(|value| value.parse().ok()).unwrap_or(otherwise)
}

#[test]
fn random_programs_print_the_same() {
    let (count, first) = (variable("POVISTA_PROGRAMS", 200), variable("POVISTA_SEED", 201));
    println!("{count} programs, seeds from {first}");
    let starts: Vec<usize> = (0..count.div_ceil(AT_ONCE) as usize).collect();
    let jobs = 2 * thread::available_parallelism().map_or(1, usize::from);
    let found = parallel::each(&starts, jobs, |start| {
        let begin = first + start as u64 * AT_ONCE;
        let seeds: Vec<u64> = (begin..(begin + AT_ONCE).min(first + count)).collect();
        let programs: Vec<String> = seeds.iter().map(|&seed| program::program(seed)).collect();
        if compared(&programs).is_none() {
            return Vec::new();
        }
        // Which of them it is.
        let alone = |(seed, program): (&u64, &String)| {
            let difference = compared(std::slice::from_ref(program))?;
            Some((*seed, difference, program.clone()))
        };
        let found: Vec<_> = seeds.iter().zip(&programs).filter_map(alone).collect();
        match found.is_empty() {
            true => vec![(begin, "only together with those after it".to_owned(), programs.concat())],
            false => found,
        }
    });
    let found: Vec<_> = found.into_iter().flatten().collect();
    let folder = std::env::temp_dir().join("povista-programs");
    let report: Vec<String> =
        found.iter().take(SHOWN).map(|(seed, difference, _)| format!("seed {seed}: {difference}")).collect();
    for (seed, _, program) in &found {
        fs::create_dir_all(&folder).unwrap();
        fs::write(folder.join(format!("{seed}.pov")), format!("{}{program}", program::PRELUDE)).unwrap();
    }
    assert!(
        found.is_empty(),
        "{} programs differ, see {}:\n{}",
        found.len(),
        folder.display(),
        report.join("\n")
    );
}

/// What random programs found, and what else was found on the way.
#[test]
fn what_was_found_prints_the_same() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/programs/found");
    let mut files: Vec<_> =
        fs::read_dir(folder).into_iter().flatten().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    let order: Vec<usize> = (0..files.len()).collect();
    let wrong = parallel::each(&order, 8, |at| {
        let difference = compared(&[fs::read_to_string(&files[at]).unwrap()])?;
        Some(format!("{}: {difference}", files[at].display()))
    });
    let wrong: Vec<String> = wrong.into_iter().flatten().collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
