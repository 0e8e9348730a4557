//! One mistake in, one report out: real scenes with a token deleted, doubled or swapped with the next.
//!
//! Of the mutants that POV-Ray refuses, nearly all give exactly one error, whose place covers the mistake or the
//! token after it. `POVISTA_MUTANTS` says how many are made (100 otherwise), `POVISTA_SEED` where the seeds
//! begin; with `POVISTA_SHOW` those that fail are listed.

#[path = "../programs/random.rs"]
mod random;
mod token;

use std::fs;
use std::ops::Range;
use std::path::Path;
use std::time::Duration;

use povista_compat::parallel;
use povista_compat::process::{Ended, Sandbox};
use povista_compat::program::Program;
use povista_compat::scene::{Places, Scene};
use random::Random;
use serde_json::Value;

/// Bytes of the longest scene that is mutated.
const LONGEST: u64 = 8_000;
/// Processor time of one program: only what ends in it is judged.
const LIMIT: Duration = Duration::from_secs(10);
/// Share of the refused mutants that give exactly one error.
const ONE_ERROR: f64 = 0.90;
/// Share of them whose first error covers the mistake, or the next token.
const RIGHT_PLACE: f64 = 0.80;
/// Runs at a time: POV-Ray sleeps for half a second each.
const AT_A_TIME: usize = 10;

/// A scene with a mistake.
struct Mutant {
    text: String,
    /// What was done.
    kind: &'static str,
    /// The mistake and the token after it.
    place: Range<usize>,
}

impl Mutant {
    /// Makes a mistake somewhere in a text, if it has tokens enough.
    fn of(text: &str, random: &mut Random) -> Option<Mutant> {
        let tokens = token::ranges(text);
        if tokens.len() < 20 {
            return None;
        }
        let at = random.below(tokens.len() - 1);
        let (this, next) = (tokens[at].clone(), tokens[at + 1].clone());
        let kind = random.one(&["delete", "double", "swap"]);
        let (before, between) = (&text[..this.start], &text[this.end..next.start]);
        let (one, two, after) = (&text[this.clone()], &text[next.clone()], &text[next.end..]);
        let (text, end) = match kind {
            "delete" => (format!("{before}{between}{two}{after}"), this.start),
            "double" => (format!("{before}{one} {one}{between}{two}{after}"), this.end + 1 + one.len()),
            _ => (format!("{before}{two}{between}{one}{after}"), next.end),
        };
        let following = token::ranges(&text).into_iter().find(|token| token.start >= end);
        let place = this.start..following.map_or(text.len(), |token| token.end);
        Some(Mutant {
            text,
            kind: if kind == "delete" {
                "delete"
            } else if kind == "double" {
                "double"
            } else {
                "swap"
            },
            place,
        })
    }
}

/// What became of a mutant that POV-Ray refuses.
struct Judged {
    errors: usize,
    covered: bool,
    /// For people.
    story: String,
}

fn judge(seed: u64, scenes: &[Scene], povray: &Program, povista: &Program) -> Option<Judged> {
    let mut random = Random::new(seed);
    let scene = &scenes[random.below(scenes.len())];
    let text: String = fs::read(&scene.path).unwrap().iter().map(|&byte| char::from(byte)).collect();
    if !text.is_ascii() {
        return None;
    }
    let mutant = Mutant::of(&text, &mut random)?;
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("mutant.pov"), &mutant.text).unwrap();
    let run = |program: &Program, arguments: &[&str]| {
        let arguments: Vec<String> = arguments.iter().map(|&argument| argument.to_owned()).collect();
        Sandbox::copy_of(folder.path()).unwrap().run(&program.path, &arguments, LIMIT).unwrap()
    };
    let library = scene.folder().display().to_string();
    let switch = format!("+L{library}");
    if run(povray, &["+Imutant.pov", &switch, "+W1", "+H1", "-F", "-D", "+WT1"]).ended != Ended::Code(1) {
        return None;
    }
    let found = run(povista, &["check", "--format", "json", "-L", &library, "mutant.pov"]);
    let diagnostics = found.text.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
    let errors: Vec<Value> = diagnostics.filter(|diagnostic| diagnostic["severity"] == "error").collect();
    let covered = errors
        .first()
        .and_then(|error| span(&mutant.text, &error["at"]))
        .is_some_and(|span| span.start <= mutant.place.end && span.end >= mutant.place.start);
    let line = mutant.text[..mutant.place.start].matches('\n').count() + 1;
    let mut story = format!(
        "seed {seed}, {} line {line}, {}: {:?}",
        scene.name,
        mutant.kind,
        &mutant.text[mutant.place.clone()]
    );
    for error in errors.iter().take(4) {
        story
            .push_str(&format!("\n    {}:{} {}", error["at"]["file"], error["at"]["line"], error["message"]));
    }
    Some(Judged { errors: errors.len(), covered, story })
}

/// The bytes that an error of the mutant itself points at.
fn span(text: &str, at: &Value) -> Option<Range<usize>> {
    if at["file"].as_str()? != "mutant.pov" {
        return None;
    }
    let offset = |line: &Value, column: &Value| {
        let (line, column) = (line.as_u64()? as usize, column.as_u64()? as usize);
        let start = text.split_inclusive('\n').take(line - 1).map(str::len).sum::<usize>();
        Some(start + column - 1)
    };
    Some(offset(&at["line"], &at["column"])?..offset(&at["end_line"], &at["end_column"])?)
}

fn variable(name: &str, otherwise: u64) -> u64 {
    std::env::var(name).ok().and_then(|value| value.parse().ok()).unwrap_or(otherwise)
}

#[test]
fn one_mistake_is_one_error() {
    let (count, first) = (variable("POVISTA_MUTANTS", 100), variable("POVISTA_SEED", 1));
    let places = Places::here();
    let (povray, povista) = (Program::povray().unwrap(), Program::povista().unwrap());
    let short = |scene: &Scene| {
        scene.path.starts_with(&places.examples)
            && fs::metadata(&scene.path).is_ok_and(|file| file.len() < LONGEST)
    };
    let scenes: Vec<Scene> = places.all().unwrap().into_iter().filter(short).collect();
    assert!(scenes.len() > 100, "install povray-examples in {}", Path::new(&places.examples).display());
    let order: Vec<usize> = (0..count as usize).collect();
    let judged = parallel::each(&order, AT_A_TIME, |at| judge(first + at as u64, &scenes, &povray, &povista));
    let judged: Vec<Judged> = judged.into_iter().flatten().collect();
    let share = |what: &dyn Fn(&Judged) -> bool| {
        judged.iter().filter(|mutant| what(mutant)).count() as f64 / judged.len().max(1) as f64
    };
    let (one, right) = (share(&|mutant| mutant.errors == 1), share(&|mutant| mutant.covered));
    let (none, many) = (share(&|mutant| mutant.errors == 0), share(&|mutant| mutant.errors > 3));
    if std::env::var_os("POVISTA_SHOW").is_some() {
        for mutant in judged.iter().filter(|mutant| mutant.errors != 1 || !mutant.covered) {
            println!(
                "{} errors, {}: {}",
                mutant.errors,
                if mutant.covered { "covered" } else { "elsewhere" },
                mutant.story
            );
        }
    }
    println!(
        "seeds from {first}: POV-Ray refuses {} of {count} mutants; one error {:.1} %, in the right place {:.1} %, no error {:.1} %, more than three {:.1} %",
        judged.len(),
        100.0 * one,
        100.0 * right,
        100.0 * none,
        100.0 * many
    );
    assert!(judged.len() as u64 > count / 2, "most mistakes are refused");
    assert!(one >= ONE_ERROR && right >= RIGHT_PLACE, "set POVISTA_SHOW to see which");
}
