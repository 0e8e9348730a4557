//! Laying out all that is installed, and the program that does it to a user's files.

use povista::fmt::format;
use povista::source::{Encoding, FileId, Source};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// Every scene and include file of Debian's povray-includes and povray-examples: none is refused, which would
/// mean that tokens or comments were not the same afterwards, and laid out again it is the same.
#[test]
fn every_installed_file_is_laid_out_and_keeps_its_tokens() {
    let mut files = Vec::new();
    for folder in ["/usr/share/povray-3.7/include", "/usr/share/doc/povray/examples"] {
        collect(Path::new(folder), &mut files);
    }
    assert!(files.len() >= 477, "only {} files: install povray-includes and povray-examples", files.len());
    let (mut wrong, mut latin1) = (Vec::new(), 0);
    for file in &files {
        let lay_out = |bytes: Vec<u8>| {
            let source = Source::new("file", "", bytes);
            let text = format(FileId(0), &source).map_err(|refusal| format!("{refusal:?}"))?;
            Ok::<_, String>((source.bytes(&text).into_owned(), source.encoding))
        };
        let again = lay_out(fs::read(file).unwrap()).and_then(|(once, encoding)| {
            latin1 += usize::from(encoding == Encoding::Latin1);
            let twice = lay_out(once.clone())?.0;
            if twice == once { Ok(()) } else { Err(first_difference(&once, &twice)) }
        });
        if let Err(error) = again {
            wrong.push(format!("{}: {error}", file.display()));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(latin1 > 0, "no file that is not UTF-8 was among them");
}

fn first_difference(once: &[u8], twice: &[u8]) -> String {
    let lines = |bytes: &[u8]| String::from_utf8_lossy(bytes).lines().map(str::to_owned).collect::<Vec<_>>();
    let pair = lines(once).into_iter().zip(lines(twice)).find(|(a, b)| a != b);
    format!("laid out again it is different: {pair:?}")
}

/// The files below a folder that hold scenes or parts of them.
fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).into_iter().flatten() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            collect(&path, files);
        } else if path.extension().is_some_and(|e| e == "pov" || e == "inc") {
            files.push(path);
        }
    }
}

fn povista(folder: &Path, words: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_povista"));
    command.args(words).current_dir(folder).stdin(Stdio::null()).output().unwrap()
}

#[test]
fn a_file_is_replaced_and_keeps_its_bytes_and_its_mode() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.pov");
    fs::write(&file, b"sphere{0,1}// \xe9t\xe9\r\n#debug\"\xe9\"").unwrap();
    let mut permissions = fs::metadata(&file).unwrap().permissions();
    permissions.set_readonly(true);
    fs::set_permissions(&file, permissions).unwrap();
    let output = povista(folder.path(), &["fmt", "a.pov"]);
    assert!(output.status.success(), "{output:?}");
    assert_eq!(fs::read(&file).unwrap(), b"sphere { 0, 1 } // \xe9t\xe9\n#debug \"\xe9\"\n");
    assert!(fs::metadata(&file).unwrap().permissions().readonly());
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "something was left behind");
}

#[cfg(unix)]
#[test]
fn a_link_to_a_file_stays_a_link() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.pov"), "a{}b{}").unwrap();
    std::os::unix::fs::symlink("a.pov", folder.path().join("link.pov")).unwrap();
    assert!(povista(folder.path(), &["fmt", "link.pov"]).status.success());
    assert!(fs::symlink_metadata(folder.path().join("link.pov")).unwrap().is_symlink());
    assert_eq!(fs::read_to_string(folder.path().join("a.pov")).unwrap(), "a {} b {}\n");
}

#[test]
fn a_check_names_files_and_changes_none() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("good.pov"), "sphere { 0, 1 }\n").unwrap();
    fs::write(folder.path().join("bad.pov"), "sphere{0,1}").unwrap();
    assert_eq!(povista(folder.path(), &["fmt", "--check", "good.pov"]).status.code(), Some(0));
    let output = povista(folder.path(), &["fmt", "--check", "good.pov", "bad.pov"]);
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(String::from_utf8_lossy(&output.stdout), "bad.pov is not laid out\n");
    let output = povista(folder.path(), &["fmt", "--stdout", "bad.pov"]);
    assert_eq!(String::from_utf8_lossy(&output.stdout), "sphere { 0, 1 }\n");
    assert_eq!(fs::read_to_string(folder.path().join("bad.pov")).unwrap(), "sphere{0,1}");
}

#[test]
fn what_is_no_text_of_tokens_is_left_alone_and_the_others_are_laid_out() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("open.pov"), "sphere{0,1} \"open").unwrap();
    fs::write(folder.path().join("b.pov"), "sphere{0,1}").unwrap();
    let output = povista(folder.path(), &["fmt", "open.pov", "b.pov"]);
    assert_eq!(output.status.code(), Some(1));
    let told = String::from_utf8_lossy(&output.stderr);
    assert!(
        told.contains("this string is never closed") && told.contains("open.pov is left as it is"),
        "{told}"
    );
    assert_eq!(fs::read_to_string(folder.path().join("open.pov")).unwrap(), "sphere{0,1} \"open");
    assert_eq!(fs::read_to_string(folder.path().join("b.pov")).unwrap(), "sphere { 0, 1 }\n");
}

#[test]
fn standard_input_is_laid_out_on_standard_output() {
    let mut command = Command::new(env!("CARGO_BIN_EXE_povista"));
    command.args(["fmt", "-"]).stdin(Stdio::piped()).stdout(Stdio::piped());
    let mut child = command.spawn().unwrap();
    std::io::Write::write_all(&mut child.stdin.take().unwrap(), b"box{0,1}").unwrap();
    assert_eq!(child.wait_with_output().unwrap().stdout, b"box { 0, 1 }\n");
}
