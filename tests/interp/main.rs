//! The probe tables of docs/spec/language.md: what POV-Ray was seen to print, povista prints.
//!
//! Every row is put to both programs, but for those in [`better`] tables.
//!
//! A row is a piece of scene and what comes out: the lines of the debug stream with trailing zeros
//! of numbers cut, then `W` for each warning, `P` for each possible error and `E` for an error.

mod arrays;
mod directives;
mod expressions;
mod files;
mod functions;
mod lexical;
mod limits;
mod macros;
mod old_versions;
mod povray;
mod replay;
mod strings;

use povista::diag::Severity;
use povista::interp::check::{Checked, check_with};
use povista::options::LanguageOptions;
use povista::source::{Library, Source};

/// The printing macros the tables use.
const PRELUDE: &str = r#"#version 3.7;
global_settings { assumed_gamma 1 }
#macro F(e) #debug concat(str(e,0,12),"\n") #end
#macro V(e) #debug concat(vstr(3,e,",",0,9),"\n") #end
#macro V5(e) #debug concat(vstr(5,e,",",0,9),"\n") #end
#macro V2(e) #debug concat(vstr(2,e,",",0,9),"\n") #end
#macro S(e) #debug concat("[",e,"]\n") #end
"#;

/// Checks every row of a table with both programs, and reports all that differ.
pub(crate) fn probe(table: &[(&str, &str)]) {
    let library = Library::default;
    probe_in(&library, table);
}

/// The same with files to include.
pub(crate) fn probe_in(library: &dyn Fn() -> Library, table: &[(&str, &str)]) {
    better_in(library, table);
    let scenes: Vec<String> = table.iter().map(|(scene, _)| format!("{PRELUDE}{scene}\n")).collect();
    let found = povray::outcomes(&scenes, &library().current);
    let mut wrong = Vec::new();
    for (((scene, wanted), found), asked) in table.iter().zip(found).zip(&scenes) {
        let (wanted, mut found) = (in_short(wanted), in_short(&found));
        if found != wanted {
            // Once in some hundred starts POV-Ray ends with another code, or without all it has to say.
            let again = povray::outcomes(std::slice::from_ref(asked), &library().current);
            found = in_short(&again.concat());
        }
        if found != wanted {
            wrong.push(format!("{scene}\n  wanted:  {wanted}\n  POV-Ray: {found}"));
        }
    }
    assert!(wrong.is_empty(), "POV-Ray differs in {} of {}:\n{}", wrong.len(), table.len(), wrong.join("\n"));
}

/// Checks rows that POV-Ray does not survive, or answers worse; the test says why.
pub(crate) fn better(table: &[(&str, &str)]) {
    better_in(&Library::default, table);
}

fn better_in(library: &dyn Fn() -> Library, table: &[(&str, &str)]) {
    let mut wrong = Vec::new();
    for &(scene, wanted) in table {
        let checked = run(scene, library());
        let found = outcome(&checked);
        if found != wanted && in_short(&found) != wanted {
            wrong.push(format!("{scene}\n  wanted: {wanted}\n  found:  {found}\n{checked}"));
        }
    }
    assert!(wrong.is_empty(), "{} of {} differ:\n{}", wrong.len(), table.len(), wrong.join("\n"));
}

/// Where POV-Ray answers worse.
#[test]
fn some_answers_are_better_than_pov_rays() {
    better(&[
        // It hangs.
        ("#declare A=array[100000][100000];", "E"),
        // It runs what it can before it notices.
        ("#while(1) F(1)", "E"),
        // It does not expand the macro.
        ("#version 3.5 F(1)", "1 P"),
        // It hangs on a folder.
        ("#include \"/tmp\"", "E"),
        // It gives up at the first error.
        ("#for(I,1,4) F(sqrt(I-3)) #end", "0 1 E"),
    ]);
}

/// Checks every row again inside a loop and a macro, where expressions are compiled the second time.
pub(crate) fn probe_repeated(table: &[(&str, &str)]) {
    probe(table);
    let mut repeated = Vec::new();
    for &(scene, wanted) in table {
        let results: Vec<&str> = wanted.split(' ').filter(|part| !["W", "P", "E"].contains(part)).collect();
        let verdicts: Vec<&str> = wanted.split(' ').filter(|part| ["W", "P", "E"].contains(part)).collect();
        let passes = if verdicts.contains(&"E") { continue } else { 4 };
        let scene = format!("#macro Again() {scene}\n#end #for(Pass,1,{passes}) Again() #end");
        let all: Vec<&str> = std::iter::repeat_n(results, passes).flatten().chain(verdicts).collect();
        repeated.push((scene, all.join(" ")));
    }
    let rows: Vec<(&str, &str)> = repeated.iter().map(|(scene, wanted)| (&**scene, &**wanted)).collect();
    better(&rows);
}

/// Reads a piece of scene after the prelude.
pub(crate) fn run(scene: &str, library: Library) -> Checked {
    let text = format!("{PRELUDE}{scene}\n");
    let options = LanguageOptions { image_width: 8, image_height: 6, ..LanguageOptions::default() };
    check_with(Source::new("scene.pov", "", text.into_bytes()), library, &options)
}

/// An outcome with its gravest complaint alone: how POV-Ray comes to its verdict is its own matter.
pub(crate) fn in_short(outcome: &str) -> String {
    let gravest = ["E", "P", "W"].into_iter().find(|letter| outcome.split(' ').any(|part| part == *letter));
    let told = outcome.split(' ').filter(|part| !["E", "P", "W", ""].contains(part));
    told.chain(gravest).collect::<Vec<_>>().join(" ")
}

fn outcome(checked: &Checked) -> String {
    let mut parts: Vec<String> = checked.debug.lines().map(trimmed).collect();
    // What concerns the scene as a whole, such as that it has no objects, is no matter of a row.
    let placed = checked.diagnostics.iter().filter(|d| d.span.is_some());
    let mut severities: Vec<Severity> = placed.map(|d| d.severity).collect();
    severities.sort();
    severities.dedup_by(|a, b| a == b && *a == Severity::Error);
    parts.extend(severities.iter().map(|severity| {
        let letter = match severity {
            Severity::Warning => "W",
            Severity::Possible => "P",
            Severity::Error => "E",
        };
        letter.to_owned()
    }));
    parts.join(" ")
}

/// A line with the trailing zeros of its numbers cut.
fn trimmed(line: &str) -> String {
    let cut = |number: &str| match number.contains('.') && number.parse::<f64>().is_ok() {
        true => number.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => number.to_owned(),
    };
    if line.starts_with('[') {
        return line.to_owned();
    }
    line.split(',').map(cut).collect::<Vec<_>>().join(",")
}
