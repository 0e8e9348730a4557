//! Statements: what is refused and what is not, and the scenes they make.

use povista::diag::{Collect, Severity};
use povista::interp::{check::check_with, interpret};
use povista::options::LanguageOptions;
use povista::scene::Scene;
use povista::source::{Library, Source, Sources};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

const INCLUDES: &str = "/usr/share/povray-3.7/include";
const EXAMPLES: &str = "/usr/share/doc/povray/examples";

/// Every line of `verdicts.txt` was put to POV-Ray.
#[test]
fn statements_are_accepted_and_refused_as_by_povray() {
    let mut wrong = Vec::new();
    for line in include_str!("statement/verdicts.txt").lines() {
        let Some((verdict, statement)) = line.split_once(' ').filter(|_| !line.starts_with('#')) else {
            continue;
        };
        let settings = match statement.contains("assumed_gamma") {
            true => "",
            false => "global_settings{assumed_gamma 1}",
        };
        let text = format!("#version 3.7;\n{settings}\n{statement}\n");
        let library = Library { paths: vec![INCLUDES.into()], ..Library::default() };
        let source = Source::new("scene.pov", "", text.into_bytes());
        let checked = check_with(source, library, &LanguageOptions::default());
        let found = match checked.diagnostics.iter().map(|diagnostic| diagnostic.severity).max() {
            Some(Severity::Error) => "E",
            Some(_) => "W",
            None => "ok",
        };
        if found != verdict {
            wrong.push(format!("{found} instead of {verdict}: {statement}\n{checked}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// What the specification says of statements has rows: every reserved word of its chapter stands in one.
#[test]
fn every_word_of_the_chapter_about_statements_is_in_a_row() {
    // Words of its notation, and of other chapters.
    const OTHERS: [&str; 7] = ["else", "if", "include", "int", "max", "min", "spline"];
    let reserved: BTreeSet<&str> = povista::reference::words().into_iter().map(|(word, _)| word).collect();
    let words = |text: &'static str| {
        text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').filter(|word| reserved.contains(word))
    };
    let specification = include_str!("../docs/spec/language.md");
    let chapter = specification.split("## 6. Statements").nth(1).unwrap().split("## 7.").next().unwrap();
    let rows = include_str!("statement/verdicts.txt").lines().filter(|line| !line.starts_with('#'));
    let in_rows: BTreeSet<&str> = rows.flat_map(words).collect();
    let code = chapter.split('`').skip(1).step_by(2);
    let missing: BTreeSet<&str> =
        code.flat_map(words).filter(|word| !in_rows.contains(word) && !OTHERS.contains(word)).collect();
    assert!(missing.is_empty(), "{missing:?}");
}

/// The dump of each scene in `statement/scenes` is its snapshot.
#[test]
fn scenes_are_what_was_written() {
    insta::glob!("statement/scenes/*.pov", |path| {
        let scene =
            read(path, path.parent().unwrap(), Vec::new()).unwrap_or_else(|report| panic!("{report}"));
        insta::with_settings!({
            snapshot_path => "statement/snapshots", prepend_module_to_snapshot => false, omit_expression => true
        }, {
            insta::assert_snapshot!("scene", scene.dump().trim_end());
        });
    });
}

/// Reads a scene file, or says what is wrong with it.
fn read(path: &Path, current: &Path, paths: Vec<PathBuf>) -> Result<Scene, String> {
    let mut sources = Sources::new(Library { current: current.into(), paths, ..Library::default() });
    let main = sources.add(Source::new(path.display().to_string(), path, fs::read(path).unwrap()));
    let options = LanguageOptions { image_width: 16, image_height: 12, ..LanguageOptions::default() };
    let mut sink = Collect::default();
    interpret(main, &mut sources, &options, &mut sink).ok_or_else(|| {
        let errors = sink.diagnostics.iter().filter(|diagnostic| diagnostic.severity == Severity::Error);
        errors
            .take(3)
            .map(|diagnostic| povista::diag::line(diagnostic, &sources))
            .collect::<Vec<_>>()
            .join("\n")
    })
}

/// Of the scenes of povray-examples that POV-Ray itself renders, at least so many are understood.
#[test]
fn installed_scenes_are_understood() {
    const LEAST: usize = 376;
    let scenes: Vec<&str> = include_str!("../compat/examples.txt")
        .lines()
        .filter(|line| !line.starts_with('#'))
        .filter_map(|line| line.split_whitespace().next())
        .collect();
    let scratch = tempfile::tempdir().unwrap();
    let mut wrong = Vec::new();
    for scene in &scenes {
        let path = Path::new(EXAMPLES).join(scene);
        let folder = path.parent().unwrap().to_owned();
        if let Err(report) = read(&path, scratch.path(), vec![folder, INCLUDES.into()]) {
            wrong.push(format!("{scene}: {report}"));
        }
    }
    let understood = scenes.len() - wrong.len();
    println!("{understood} of {} scenes are understood", scenes.len());
    assert!(understood >= LEAST, "only {understood}:\n{}", wrong.join("\n"));
}

/// Every include file can be read, after two that others rely on.
#[test]
fn installed_includes_are_understood() {
    let mut wrong = Vec::new();
    let mut count = 0;
    let scratch = tempfile::tempdir().unwrap();
    for entry in fs::read_dir(INCLUDES).expect("install povray-includes") {
        let name = entry.unwrap().file_name().to_string_lossy().into_owned();
        if !name.ends_with(".inc") {
            continue;
        }
        let main = scratch.path().join("scene.pov");
        let text = format!(
            "#version 3.7; global_settings {{ assumed_gamma 1 }}\n\
             #include \"colors.inc\"\n#include \"shapes.inc\"\n#include \"{name}\"\n"
        );
        fs::write(&main, text).unwrap();
        count += 1;
        if let Err(report) = read(&main, scratch.path(), vec![INCLUDES.into()]) {
            wrong.push(format!("{name}: {report}"));
        }
    }
    println!("{} of {count} include files are understood", count - wrong.len());
    assert!(count >= 39 && wrong.is_empty(), "{}", wrong.join("\n"));
}
