//! Scene files in, reports out: each file of `tests/syntax/invalid` is named after the mistake in
//! it, and its snapshot is what a user sees. What POV-Ray's own files hold has to be readable.

use povista::diag::{Severity, plain};
use povista::interp::check::{Checked, check_with};
use povista::options::LanguageOptions;
use povista::source::{FileId, Library, Source, Span};
use povista::syntax::{NodeKind, Symbols, Tree, parse};
use std::fs;
use std::path::{Path, PathBuf};

#[test]
fn invalid_scenes_are_refused() {
    insta::glob!("syntax/invalid/*.pov", |path| {
        let checked = check_file(path);
        assert!(checked.failed(), "{} is accepted", path.display());
        check_spans(&checked);
        snapshot("invalid", &checked);
    });
}

#[test]
fn valid_scenes_are_accepted() {
    insta::glob!("syntax/valid/*.pov", |path| {
        let checked = check_file(path);
        assert!(!checked.failed(), "{}:\n{checked}", path.display());
        check_spans(&checked);
        snapshot("valid", &checked);
    });
}

/// What is accepted but should be looked at: here remarks about the scene as a whole count too.
#[test]
fn doubtful_scenes_are_warned_about() {
    insta::glob!("syntax/warned/*.pov", |path| {
        let checked = check_file(path);
        assert!(!checked.failed(), "{}:\n{checked}", path.display());
        assert!(!checked.diagnostics.is_empty(), "{} is passed over", path.display());
        check_spans(&checked);
        snapshot("warned", &checked);
    });
}

/// Every error and warning of docs/spec/language.md 7.2 has a scene that is in that situation.
#[test]
fn every_situation_has_a_scene() {
    let spec = include_str!("../docs/spec/language.md");
    let table = spec.split("### 7.2 Situations").nth(1).unwrap();
    let listed = include_str!("syntax/situations.txt");
    let mut count = 0;
    for row in table.lines().filter(|row| row.starts_with("| ") && !row.starts_with("| #")) {
        let mut cells = row.trim_matches('|').split(" | ");
        let (number, outcome) = (cells.next().unwrap().trim(), cells.last().unwrap().trim());
        count += 1;
        let scenes = listed.lines().find_map(|line| line.strip_prefix(&format!("{number} ")));
        assert!(scenes.is_some() || outcome.starts_with("silent"), "{row} has no scene");
        for scene in scenes.unwrap_or_default().split(' ').filter(|scene| !scene.is_empty()) {
            let exists = |folder: &str| {
                Path::new(env!("CARGO_MANIFEST_DIR"))
                    .join(format!("tests/syntax/{folder}/{scene}.pov"))
                    .exists()
            };
            assert!(exists("invalid") || exists("warned"), "{number}: {scene} does not exist");
        }
    }
    assert!(count >= 70, "only {count} rows were found");
}

/// Every file of Debian's povray-includes and povray-examples.
#[test]
fn installed_files_are_tokens_throughout() {
    let mut files = Vec::new();
    for folder in ["/usr/share/povray-3.7/include", "/usr/share/doc/povray/examples"] {
        collect(Path::new(folder), &mut files);
    }
    assert!(files.len() >= 477, "only {} files: install povray-includes and povray-examples", files.len());
    let mut wrong = Vec::new();
    for file in files {
        let source = Source::new(file.display().to_string(), &file, fs::read(&file).unwrap());
        let mut symbols = Symbols::new([]);
        let tree = parse(FileId(0), &source, &mut symbols);
        wrong.extend(tree.errors.iter().map(|error| format!("{}: {}", file.display(), error.message)));
        check_nodes(&source, &tree);
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

fn check_file(path: &Path) -> Checked {
    let name = path.file_name().unwrap().to_string_lossy().into_owned();
    let source = Source::new(name, path, fs::read(path).unwrap());
    let library = Library { current: path.parent().unwrap().join("include"), ..Library::default() };
    check_with(source, library, &LanguageOptions { max_steps: 10_000, ..LanguageOptions::default() })
}

/// Compares the report, and what the scene wrote, with the snapshot.
fn snapshot(verdict: &str, checked: &Checked) {
    // What concerns the scene as a whole, such as that it has no objects, is mostly no matter here.
    let all = verdict == "warned";
    let placed = checked.diagnostics.iter().filter(|diagnostic| all || diagnostic.span.is_some());
    let mut report: String = placed.map(|diagnostic| plain(diagnostic, &checked.sources)).collect();
    if !checked.debug.is_empty() {
        report = format!("{report}--- debug\n{}", checked.debug);
    }
    let current = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/syntax/");
    let report = report.replace(current, "");
    insta::with_settings!({
        snapshot_path => "syntax/snapshots", prepend_module_to_snapshot => false, omit_expression => true
    }, {
        insta::assert_snapshot!(verdict, report.trim_end());
    });
}

/// Spans point into their files, labels are not empty text, and no error is said twice.
fn check_spans(checked: &Checked) {
    let inside = |span: Span| {
        let text = &checked.sources.get(span.file).text();
        let (start, end) = (span.start as usize, span.end as usize);
        assert!(start <= end && end <= text.len(), "{span:?} lies outside its file");
        assert!(text.is_char_boundary(start) && text.is_char_boundary(end), "{span:?} cuts a character");
    };
    for (index, diagnostic) in checked.diagnostics.iter().enumerate() {
        diagnostic.span.map(inside);
        diagnostic.labels.iter().for_each(|label| inside(label.span));
        diagnostic.trace.iter().for_each(|step| inside(step.span));
        assert!(
            !diagnostic.message.is_empty() && !diagnostic.message.ends_with('.'),
            "{:?}",
            diagnostic.message
        );
        if diagnostic.severity == Severity::Error {
            let first = diagnostic.message.chars().next().unwrap_or(' ');
            let own = diagnostic.label.contains("the scene stops itself");
            assert!(own || !first.is_uppercase(), "{:?} starts with a capital", diagnostic.message);
        }
        assert!(!checked.diagnostics[..index].contains(diagnostic), "{:?} is said twice", diagnostic.message);
    }
}

/// Nodes are in order, don't overlap, and links lead forward to directives.
fn check_nodes(source: &Source, tree: &Tree) {
    let mut end = 0;
    for (index, node) in tree.nodes.iter().enumerate() {
        assert!(node.start >= end && node.end >= node.start, "nodes overlap at {index}");
        end = node.end;
        if let NodeKind::Directive(_, link) = node.kind
            && let Some(other) = tree.nodes.get(link as usize)
        {
            assert!(link as usize > index && matches!(other.kind, NodeKind::Directive(..)));
        }
    }
    assert!(end as usize <= source.text().len());
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).into_iter().flatten() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            collect(&path, files);
        } else if path.extension().is_some_and(|extension| extension == "pov" || extension == "inc") {
            files.push(path);
        }
    }
}
