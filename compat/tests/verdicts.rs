//! Every row of `tests/statement/verdicts.txt`, put to both programs: what docs/spec/language.md 6 calls an error
//! is refused, what it accepts is accepted.
//!
//! A comment `# POV-Ray: E; why` before a row says where POV-Ray answers otherwise: the reasons are collected in
//! docs/conformance.md.

use std::fs;
use std::time::Duration;

use povista_compat::parallel;
use povista_compat::process::{Ended, Sandbox};
use povista_compat::program::Program;
use povista_compat::scene::Places;

/// Processor time of one program.
const LIMIT: Duration = Duration::from_secs(20);
/// Runs at a time: POV-Ray sleeps for half a second each.
const AT_A_TIME: usize = 12;

/// How povista is asked: habits that POV-Ray says nothing about are no verdicts.
const CHECK: [&str; 8] =
    ["check", "--format", "plain", "--allow", "unused", "--allow", "missing_max_gradient", "row.pov"];

/// A statement and what both programs are to say.
struct Row {
    line: usize,
    povista: String,
    povray: String,
    statement: String,
}

fn rows(text: &str) -> Vec<Row> {
    let mut rows = Vec::new();
    let mut other = None;
    for (at, line) in text.lines().enumerate() {
        if let Some(comment) = line.strip_prefix('#') {
            other = comment.trim().strip_prefix("POV-Ray: ").and_then(|rest| rest.split(';').next());
        } else if let Some((verdict, statement)) = line.split_once(' ') {
            let povray = other.take().unwrap_or(verdict).to_owned();
            rows.push(Row {
                line: at + 1,
                povista: verdict.to_owned(),
                povray,
                statement: statement.trim().to_owned(),
            });
        }
    }
    rows
}

/// What a program says to a statement: E, W or ok.
fn verdict(program: &Program, statement: &str, arguments: &[&str], warns: &[&str]) -> &'static str {
    let settings = if statement.contains("assumed_gamma") { "" } else { "global_settings{assumed_gamma 1}" };
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("row.pov"), format!("#version 3.7;\n{settings}\n{statement}\n")).unwrap();
    let arguments: Vec<String> = arguments.iter().map(|&argument| argument.to_owned()).collect();
    let finished = Sandbox::copy_of(folder.path()).unwrap().run(&program.path, &arguments, LIMIT).unwrap();
    match finished.ended {
        Ended::Code(0) if warns.iter().any(|word| finished.text.contains(word)) => "W",
        Ended::Code(0) => "ok",
        _ => "E",
    }
}

#[test]
fn statements_are_refused_and_accepted_by_both() {
    let text = fs::read_to_string(Places::here().repository.join("tests/statement/verdicts.txt")).unwrap();
    let rows = rows(&text);
    let (povray, povista) = (Program::povray().unwrap(), Program::povista().unwrap());
    let order: Vec<usize> = (0..rows.len()).collect();
    let wrong = parallel::each(&order, AT_A_TIME, |at| {
        let row = &rows[at];
        let switches = ["+Irow.pov", "-F", "-D", "+W1", "+H1", "+WT1"];
        let theirs = verdict(&povray, &row.statement, &switches, &["Parse Warning", "Possible Parse Error"]);
        let ours = verdict(&povista, &row.statement, &CHECK, &["⚠"]);
        let found = format!("povista {ours}, POV-Ray {theirs}");
        let wanted = format!("povista {}, POV-Ray {}", row.povista, row.povray);
        (found != wanted)
            .then(|| format!("line {}: {found} instead of {wanted}: {}", row.line, row.statement))
    });
    let wrong: Vec<String> = wrong.into_iter().flatten().collect();
    println!(
        "{} rows, {} of them answered otherwise by POV-Ray",
        rows.len(),
        rows.iter().filter(|row| row.povista != row.povray).count()
    );
    assert!(rows.len() > 900 && wrong.is_empty(), "{} rows:\n{}", wrong.len(), wrong.join("\n"));
}
