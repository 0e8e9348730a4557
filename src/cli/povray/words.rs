//! The words of POV-Ray's command line (docs/spec/camera-image.md 16).

use super::{ini, switch};
use crate::cli::Problem;
use crate::cli::settings::{Kind, Name, Settings, Value, value};

/// Reads one word of the command line.
///
/// # Errors
/// The word is no switch, option, scene, folder or INI file, or its value cannot be read.
pub fn read(word: &str, settings: &mut Settings) -> Result<(), Problem> {
    if word.is_empty() {
        return Ok(()); // A script's empty variable.
    }
    if word == "-" && settings.text(Name::InputFileName).is_none() {
        // Standard input, as with povista's own words; POV-Ray refuses it.
        settings.set(Name::InputFileName, Value::Text(word.to_owned()));
        return Ok(());
    }
    if word.starts_with(['+', '-']) {
        return read_switches(word, settings, 0);
    }
    match word.split_once('=') {
        Some((name, value)) => {
            let option = Name::find(name).ok_or_else(|| unknown(name))?;
            let (value, quoted) = match value::quoted(value) {
                Some((inside, "")) => (inside, true),
                _ => (value, false),
            };
            match option.kind() {
                Kind::Command if !quoted && value.contains([' ', ';']) => {
                    let problem =
                        Problem::new(format!("the command of `{}` ends too early", option.as_str()));
                    Err(problem.help(format!("put it in quotes: `{}=\"{value}\"`", option.as_str())))
                }
                Kind::Obsolete => Err(Problem::new(format!("`{}` is for INI files alone", option.as_str()))),
                Kind::Ini => ini::read_named(value, settings, 1),
                _ => settings.read(option, value),
            }
        }
        _ => read_plain(word, settings, 0),
    }
}

/// Reads switches that stand in one line, each beginning with a sign, and what stands before them:
/// `scene.pov +W40 +H30`.
///
/// A blank inside a value stays: `+Omy picture.png` is one switch.
///
/// # Errors
/// One of them cannot be read.
pub(super) fn read_switches(line: &str, settings: &mut Settings, depth: usize) -> Result<(), Problem> {
    let mut rest = line.trim();
    while !rest.is_empty() {
        if let Some((name, after)) = value::quoted(rest) {
            read_plain(name, settings, depth)?;
            rest = after.trim_start();
            continue;
        }
        let next = rest
            .match_indices([' ', '\t'])
            .find(|(blank, _)| rest[blank + 1..].starts_with(['+', '-']))
            .map_or(rest.len(), |(blank, _)| blank);
        let word = rest[..next].trim_end();
        if word.starts_with(['+', '-']) {
            switch::read(word, settings)?;
        } else {
            read_plain(word, settings, depth)?;
        }
        rest = rest[next..].trim_start();
    }
    Ok(())
}

/// Reads a word that is neither switch nor option: a scene, a folder to search or an INI file.
///
/// # Errors
/// There is no such INI file, or it cannot be read.
pub(super) fn read_plain(word: &str, settings: &mut Settings, depth: usize) -> Result<(), Problem> {
    let word = match value::quoted(word) {
        Some((inside, "")) => inside,
        _ => word.trim_end(),
    };
    if is_scene(word) {
        settings.set(Name::InputFileName, Value::Text(word.to_owned()));
        Ok(())
    } else if word.ends_with('/') {
        settings.add_library_path(word);
        Ok(())
    } else {
        ini::read_named(word, settings, depth)
    }
}

/// Tells whether a word is POV-Ray's way of writing an option or a switch, or names an INI file.
pub fn is_povray(word: &str) -> bool {
    let option = word.split_once('=').is_some_and(|(name, _)| Name::find(name).is_some());
    let ini = word.to_ascii_lowercase().ends_with(".ini") || word.ends_with(']') && word.contains('[');
    // A sign of `+` belongs to nobody else, so a misspelt switch is POV-Ray's too.
    word.starts_with('+') || option || ini || switch::is_switch(word) && !word.starts_with("--")
}

/// Tells whether a word names a scene.
fn is_scene(word: &str) -> bool {
    word.to_ascii_lowercase().ends_with(".pov")
}

/// An option nobody knows.
pub(super) fn unknown(name: &str) -> Problem {
    let problem = Problem::new(format!("there is no option `{name}`"));
    match Name::nearest(name) {
        Some(near) => problem.help(format!("did you mean `{near}`?")),
        None => problem,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What POV-Ray's own `+GI` file says of a command line.
    fn ini(words: &[&str]) -> String {
        let mut settings = Settings::default();
        for word in words {
            if let Err(problem) = read(word, &mut settings) {
                return format!("error: {}", problem.message);
            }
        }
        settings.to_string().trim_end().replace('\n', " ")
    }

    /// Each row was read by POV-Ray itself: `povray WORDS +GIout.ini`.
    #[test]
    fn words_mean_what_povray_takes_them_for() {
        let rows: &[(&[&str], &str)] = &[
            (&["Width=103.99"], "Width=103"),
            (&["width=\" 7\""], "Width=7"),
            (&["Input_File_Name=a.pov"], "Input_File_Name=\"a.pov\""),
            (&["Antialias=ON", "-A"], "Antialias=Off"),
            (&["-A", "antialias=1"], "Antialias=On"),
            (&["Antialias=2"], "Antialias=Off"),
            (&["Declare=a=1.23456789"], "Declare=a=1.23457"),
            (&["Declare=a=1", "Declare=b=-1.5e3"], "Declare=a=1 Declare=b=-1500"),
            (&["Declare=s=\"hi there\""], "Declare=s=\"hi there\""),
            (&["File_Gamma=srgb"], "File_Gamma=sRGB"),
            (&["Output_File_Type=ppm"], "Output_File_Type=P"),
            (&["Bits_Per_Colour=16"], "Bits_Per_Color=16"),
            (&["b.POV", "+Ia.pov"], "Input_File_Name=\"a.pov\""),
            (&["+Ia.pov", "b.POV"], "Input_File_Name=\"b.POV\""),
            (&["./foo/", "+Lbar", "+Lbar"], "Library_Path=\"./foo/\" Library_Path=\"bar\""),
            (&["+W5 +H6"], "Height=6 Width=5"),
            (&["-", "+W5"], "Input_File_Name=\"-\" Width=5"),
            (&["", "a.pov", ""], "Input_File_Name=\"a.pov\""),
            (&["Pre_Scene_Command=ls"], "Pre_Scene_Command=ls"),
            (&["Pre_Scene_Command='ls -l;'"], "Pre_Scene_Command=ls -l;"),
            (&["Output_File_Name=a,b"], "Output_File_Name=\"a,b\""),
        ];
        for (words, expected) in rows {
            assert_eq!(ini(words), *expected, "{words:?}");
        }
    }

    #[test]
    fn words_povray_refuses_are_refused() {
        let refused = [
            "Foo=1",
            "a=b.pov",
            "Width=",
            "Width=abc",
            "Quality=abc",
            "Output_File_Type=Z",
            "Output_File_Type=",
            "Dither_Method=xx",
            "File_Gamma=0",
            "File_Gamma=-1",
            "File_Gamma=0.0005",
            "File_Gamma=xyz",
            "no-such-file.ini",
            "foo",
            "foo.bar",
            "--W5",
            "/W640",
            "Pre_Scene_Command=ls -l",
            "Pre_Scene_Command=ls;",
            "Buffer_Output=on",
        ];
        for word in refused {
            assert!(ini(&[word]).starts_with("error: "), "{word}");
        }
    }

    #[test]
    fn a_misspelt_option_gets_a_suggestion() {
        let problem = read("Heigth=3", &mut Settings::default()).expect_err("no such option");
        assert_eq!(problem.help.as_deref(), Some("did you mean `Height`?"));
    }

    #[test]
    fn povrays_way_of_writing_is_told_from_povistas() {
        for word in ["+W640", "-D", "-A0.3", "width=3", "a.ini", "a[b]", "+nonsense", "-UV"] {
            assert!(is_povray(word), "{word}");
        }
        for word in ["scene.pov", "--size", "-o", "out.png", "640x480", "render", "NAME=3", "--threads", "-h"]
        {
            assert!(!is_povray(word), "{word}");
        }
    }
}
