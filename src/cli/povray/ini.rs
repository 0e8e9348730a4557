//! INI files (docs/spec/camera-image.md 16 and 18).

use std::fs;
use std::path::{Path, PathBuf};

use super::words;
use crate::cli::Problem;
use crate::cli::settings::{Kind, Name, Settings, value};

/// INI files may read others; a file that reads itself would never end.
const DEEPEST: usize = 16;

/// Longest extension with which a file name is tried as it is.
const EXTENSION: usize = 3;

/// Reads the INI file that `file` or `file[section]` names into the settings.
///
/// # Errors
/// There is no such file, or something in it cannot be read.
pub(super) fn read_named(spec: &str, settings: &mut Settings, depth: usize) -> Result<(), Problem> {
    let (name, section) = match spec.strip_suffix(']').and_then(|spec| spec.split_once('[')) {
        Some((name, section)) => (name, Some(section)),
        None => (spec, None),
    };
    let path = find(name, &settings.library_paths)
        .ok_or_else(|| Problem::new(format!("cannot find an INI file `{name}`")).help(input_help(name)))?;
    read_file(&path, section, settings, depth)
}

/// Reads an INI file: the lines before its first section, and those of the section asked for.
///
/// # Errors
/// The file cannot be read, or a line of it cannot.
pub(super) fn read_file(
    path: &Path,
    section: Option<&str>,
    settings: &mut Settings,
    depth: usize,
) -> Result<(), Problem> {
    if depth >= DEEPEST {
        let message = format!("INI files are nested more than {DEEPEST} deep at `{}`", path.display());
        return Err(Problem::new(message).help("does one of them read itself?"));
    }
    let bytes = fs::read(path).map_err(|error| Problem::io("read", path, &error))?;
    let text = String::from_utf8_lossy(&bytes);
    let mut asked = true;
    for (number, line) in text.trim_start_matches('\u{feff}').split(['\n', '\r']).enumerate() {
        let line = line.trim();
        if let Some(name) = line.strip_prefix('[') {
            let name = name.split(']').next().unwrap_or(name).trim();
            asked = section.is_some_and(|section| section.eq_ignore_ascii_case(name));
        } else if asked {
            read_line(line, settings, depth).map_err(|problem| Problem {
                message: format!("{}, line {}: {}", path.display(), number + 1, problem.message),
                ..problem
            })?;
        }
    }
    Ok(())
}

/// Reads a line that is not the head of a section.
fn read_line(line: &str, settings: &mut Settings, depth: usize) -> Result<(), Problem> {
    if line.starts_with(['+', '-']) {
        return words::read_switches(uncommented(line), settings, depth + 1);
    }
    match line.split_once('=') {
        Some((name, values)) if !name.contains(|letter: char| "\"';#".contains(letter)) => {
            let name = name.trim();
            let option = Name::find(name).ok_or_else(|| words::unknown(name))?;
            if option.kind() == Kind::Command {
                // The shell reads its quotes and commas itself.
                return settings.read(option, values[..unquoted_end(values, &[';', '#'])].trim());
            }
            for value in split(values) {
                if option.kind() == Kind::Ini {
                    read_named(&value, settings, depth + 1)?;
                } else {
                    settings.read(option, &value)?;
                }
            }
            Ok(())
        }
        _ => words::read_switches(uncommented(line), settings, depth + 1),
    }
}

/// The values after `=`: separated by commas, each perhaps in quotes, until a comment.
fn split(text: &str) -> Vec<String> {
    let mut values = Vec::new();
    let mut rest = text.trim_start();
    loop {
        if let Some((value, after)) = value::quoted(rest) {
            values.push(value.to_owned());
            rest = after.trim_start();
        } else {
            // A quote inside the value, as in `Declare=s="a;b"`, hides what would end it.
            let end = unquoted_end(rest, &[',', ';', '#']);
            values.push(rest[..end].trim_end().to_owned());
            rest = &rest[end..];
        }
        match rest.strip_prefix(',') {
            Some(next) => rest = next.trim_start(),
            None => return values,
        }
    }
}

/// Where the first of some letters stands outside quotes, or the text's end.
fn unquoted_end(text: &str, ends: &[char]) -> usize {
    let mut open = None;
    text.char_indices()
        .find(|(_, letter)| match (open, letter) {
            (Some(quote), letter) => {
                if quote == *letter {
                    open = None;
                }
                false
            }
            (None, '"' | '\'') => {
                open = Some(*letter);
                false
            }
            (None, letter) => ends.contains(letter),
        })
        .map_or(text.len(), |(position, _)| position)
}

/// A line without its comment.
fn uncommented(line: &str) -> &str {
    line.split([';', '#']).next().unwrap_or(line).trim()
}

/// Looks for an INI file in the current folder and then in the library paths.
fn find(name: &str, library_paths: &[PathBuf]) -> Option<PathBuf> {
    let extension = Path::new(name).extension().filter(|extension| extension.len() <= EXTENSION);
    let names =
        [extension.map(|_| name.to_owned()), Some(format!("{name}.ini")), Some(format!("{name}.INI"))];
    std::iter::once(Path::new(""))
        .chain(library_paths.iter().map(PathBuf::as_path))
        .flat_map(|folder| names.iter().flatten().map(move |name| folder.join(name)))
        .find(|path| path.is_file())
}

/// Advice for a word that was taken for an INI file.
fn input_help(name: &str) -> String {
    format!(
        "a word that is no switch and doesn't end in `.pov` names an INI file; a scene called so is `+I{name}`"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ini(text: &str, section: Option<&str>) -> String {
        let folder = tempfile::tempdir().expect("a folder for the test");
        let path = folder.path().join("t.ini");
        fs::write(&path, text).expect("the folder takes files");
        let mut settings = Settings::default();
        match read_file(&path, section, &mut settings, 0) {
            Ok(()) => settings.to_string().trim_end().replace('\n', " "),
            Err(problem) => format!("error: {}", problem.message),
        }
    }

    /// Each row was read by POV-Ray itself: `povray a.pov t.ini +GIout.ini`.
    #[test]
    fn lines_mean_what_povray_takes_them_for() {
        let rows = [
            ("Width=5 ; comment\nHeight = 6 # c", "Height=6 Width=5"),
            ("Width=5 Height=6", "Width=5"),
            ("Width=5,6", "Width=6"),
            ("Width=103.99\nHeight=' 12'", "Height=12 Width=103"),
            ("Declare=a=1,b=2", "Declare=a=1 Declare=b=2"),
            ("Library_Path=x,y", "Library_Path=\"x\" Library_Path=\"y\""),
            ("+W5 +H6", "Height=6 Width=5"),
            (
                "-D0\n-UV;\n+A0.3",
                "Antialias=On Antialias_Threshold=0.3 Display=Off Video_Mode=0 Vista_Buffer=Off",
            ),
            ("foo/", "Library_Path=\"foo/\""),
            ("a.pov +W10 +H8 ; small", "Height=8 Input_File_Name=\"a.pov\" Width=10"),
            ("\"a b.pov\" -D", "Display=Off Input_File_Name=\"a b.pov\""),
            ("'a - b.pov' 'c.pov'", "Input_File_Name=\"c.pov\""),
            ("  Width  =  5  ", "Width=5"),
            ("Output_File_Name=a b", "Output_File_Name=\"a b\""),
            ("Output_File_Name='a b'", "Output_File_Name=\"a b\""),
            ("Output_File_Name=\"a;b\"", "Output_File_Name=\"a;b\""),
            ("Output_File_Name=a;b", "Output_File_Name=\"a\""),
            ("Output_File_Name=a#b", "Output_File_Name=\"a\""),
            ("Declare=a=\"x;y\"", "Declare=a=\"x;y\""),
            ("Declare='a=\"x y\"'", "Declare=a=\"x y\""),
            ("Output_File_Type=N16", "Output_File_Type=N"),
            ("Antialias=", "Antialias=On"),
            ("Display=off\rWidth=5\r\n", "Display=Off Width=5"),
            ("Width=5 # x\n#Width=6\n;Width=7", "Width=5"),
            ("[a]\nWidth=5\n[b]\nWidth=6", ""),
            ("[a\nWidth=4", ""),
        ];
        for (text, expected) in rows {
            assert_eq!(ini(text, None), expected, "{text}");
        }
    }

    #[test]
    fn a_section_adds_to_the_lines_before_the_first() {
        let text = "Height=9\n[a]\nWidth=5\n[B]\nWidth=6\n[b]\nQuality=3";
        assert_eq!(ini(text, Some("b")), "Height=9 Quality=3 Width=6");
        assert_eq!(ini(text, Some("zz")), "Height=9");
    }

    #[test]
    fn lines_povray_refuses_are_refused() {
        for text in ["Foo=1", "Foo", "Width", "Antialias", "// c", "Width=x", "Width=5\n]"] {
            let answer = ini(text, None);
            assert!(answer.starts_with("error: ") && answer.contains("line "), "{text}: {answer}");
        }
    }

    #[test]
    fn a_file_that_reads_itself_is_an_error() {
        let folder = tempfile::tempdir().expect("a folder for the test");
        let path = folder.path().join("t.ini");
        fs::write(&path, format!("Include_Ini=\"{}\"", path.display())).expect("the folder takes files");
        let problem = read_file(&path, None, &mut Settings::default(), 0).expect_err("it never ends");
        assert!(problem.message.contains("nested more than 16 deep"), "{}", problem.message);
    }
}
