//! POV-Ray's switches: `+W640`, `-J`, `+A0.3` (docs/spec/camera-image.md 16 and 17).

use crate::cli::Problem;
use crate::cli::settings::{Name, Settings, Value, value};

/// How a switch uses what follows its letters.
#[derive(Debug, Clone, Copy)]
enum Use {
    /// Nothing may follow; the sign says on or off.
    Flag(Name),
    /// A value follows; the sign means nothing.
    Value(Name),
    /// The sign says on or off, and a value may follow.
    FlagAnd(Name, Name),
    /// The sign says on or off, and a value follows.
    FlagWith(Name, Name),
    /// A file format's letter, bits or `g` may follow.
    Format,
    /// Letters for a display that is not there.
    Display,
}

use Name::*;

/// The switches; the first whose letters start the word and whose use suits what follows is taken.
const SWITCHES: &[(&str, Use)] = &[
    ("KFI", Use::Value(InitialFrame)),
    ("KFF", Use::Value(FinalFrame)),
    ("KLA", Use::Flag(ClocklessAnimation)),
    ("RFI", Use::Flag(RadiosityFromFile)),
    ("RFO", Use::Flag(RadiosityToFile)),
    ("RTR", Use::Flag(RealTimeRaytracing)),
    ("RVP", Use::Flag(RadiosityVainPretrace)),
    ("STP", Use::Value(FrameStep)),
    ("A0", Use::FlagWith(Antialias, AntialiasThreshold)),
    ("AG", Use::Value(AntialiasGamma)),
    ("AM", Use::Value(SamplingMethod)),
    ("BM", Use::Value(BoundingMethod)),
    ("BS", Use::Value(RenderBlockSize)),
    ("EC", Use::Value(EndColumn)),
    ("EF", Use::Value(SubsetEndFrame)),
    ("EP", Use::Value(PreviewEndSize)),
    ("ER", Use::Value(EndRow)),
    ("GA", Use::FlagAnd(AllConsole, AllFile)),
    ("GD", Use::FlagAnd(DebugConsole, DebugFile)),
    ("GF", Use::FlagAnd(FatalConsole, FatalFile)),
    ("GI", Use::Value(CreateIni)),
    ("GP", Use::Flag(AppendFile)),
    ("GR", Use::FlagAnd(RenderConsole, RenderFile)),
    ("GS", Use::FlagAnd(StatisticConsole, StatisticFile)),
    ("GW", Use::FlagAnd(WarningConsole, WarningFile)),
    ("HI", Use::Value(IncludeHeader)),
    ("HR", Use::Flag(HighReproducibility)),
    ("KC", Use::Flag(CyclicAnimation)),
    ("KF", Use::Value(FinalClock)),
    ("KI", Use::Value(InitialClock)),
    ("MB", Use::FlagAnd(Bounding, BoundingThreshold)),
    ("MI", Use::Value(MaxImageBufferMemory)),
    ("MV", Use::Value(Version)),
    ("RF", Use::Value(RadiosityFileName)),
    ("RP", Use::Value(RenderPattern)),
    ("RS", Use::Value(RenderBlockStep)),
    ("SC", Use::Value(StartColumn)),
    ("SF", Use::Value(SubsetStartFrame)),
    ("SP", Use::Value(PreviewStartSize)),
    ("SR", Use::Value(StartRow)),
    ("SU", Use::Flag(SplitUnions)),
    ("TH", Use::FlagAnd(Dither, DitherMethod)),
    ("UA", Use::Flag(OutputAlpha)),
    ("UD", Use::Flag(DrawVistas)),
    ("UF", Use::Flag(FieldRender)),
    ("UL", Use::Flag(LightBuffer)),
    ("UO", Use::Flag(OddField)),
    ("UR", Use::Flag(RemoveBounds)),
    ("UV", Use::Flag(VistaBuffer)),
    ("WL", Use::Value(WarningLevel)),
    ("WT", Use::Value(WorkThreads)),
    ("A", Use::Flag(Antialias)),
    ("B", Use::Flag(Bounding)),
    ("C", Use::Flag(ContinueTrace)),
    ("D", Use::Display),
    ("F", Use::Format),
    ("H", Use::Value(Height)),
    ("I", Use::Value(InputFileName)),
    ("J", Use::FlagAnd(Jitter, JitterAmount)),
    ("K", Use::Value(Clock)),
    ("L", Use::Value(LibraryPath)),
    ("O", Use::Value(OutputFileName)),
    ("P", Use::Flag(PauseWhenDone)),
    ("Q", Use::Value(Quality)),
    ("R", Use::Value(AntialiasDepth)),
    ("V", Use::Flag(Verbose)),
    ("W", Use::Value(Width)),
    ("X", Use::FlagAnd(TestAbort, TestAbortCount)),
];

/// Tells whether a word is a switch POV-Ray knows, whatever its value.
pub(super) fn is_switch(word: &str) -> bool {
    word.strip_prefix(['+', '-']).is_some_and(|rest| find(rest).is_some())
}

/// Reads one switch, with its sign, into the settings.
///
/// # Errors
/// No such switch, or a value it cannot take.
pub(super) fn read(word: &str, settings: &mut Settings) -> Result<(), Problem> {
    let on = Value::Bool(word.starts_with('+'));
    let unknown = || Problem::new(format!("there is no switch `{word}`"));
    let (usage, rest) = word.strip_prefix(['+', '-']).and_then(find).ok_or_else(unknown)?;
    let text = match value::quoted(rest) {
        Some((text, "")) => text,
        Some((_, after)) => {
            return Err(Problem::new(format!("`{after}` follows the closing quote in `{word}`")));
        }
        None => rest.trim_end(),
    };
    let misread =
        |problem: Problem| Problem { message: format!("switch `{word}`: {}", problem.message), ..problem };
    match usage {
        Use::Flag(flag) => settings.set(flag, on),
        Use::Value(name) => settings.read(name, text).map_err(misread)?,
        Use::FlagAnd(flag, name) | Use::FlagWith(flag, name) => {
            if !text.is_empty() {
                settings.read(name, text).map_err(misread)?;
            }
            settings.set(flag, on);
        }
        Use::Format => {
            format(text, settings).map_err(misread)?;
            settings.set(OutputToFile, on);
        }
        Use::Display => {
            for (name, letter) in [VideoMode, Palette].into_iter().zip(text.chars()) {
                settings.set(name, Value::Text(letter.to_string()));
            }
            settings.set(Display, on);
        }
    }
    Ok(())
}

/// Finds the switch a word without its sign means, and what follows the letters.
fn find(word: &str) -> Option<(Use, &str)> {
    SWITCHES.iter().find_map(|(letters, usage)| {
        let head = word.get(..letters.len()).filter(|head| head.eq_ignore_ascii_case(letters))?;
        let rest = &word[head.len()..];
        let fits = match usage {
            Use::Flag(_) => rest.is_empty(),
            Use::Value(_) | Use::FlagWith(..) => !rest.is_empty(),
            Use::FlagAnd(..) | Use::Format | Use::Display => true,
        };
        fits.then_some((*usage, rest))
    })
}

/// Reads what follows `+F`: a letter, then bits per channel or `g` for grey.
fn format(text: &str, settings: &mut Settings) -> Result<(), Problem> {
    let mut letters = text.chars();
    let Some(letter) = letters.next() else { return Ok(()) };
    settings.read(OutputFileType, &letter.to_string())?;
    match letters.as_str() {
        "" => {}
        "g" | "G" => settings.set(GrayscaleOutput, Value::Bool(true)),
        bits if bits.bytes().all(|byte| byte.is_ascii_digit()) => settings.read(BitsPerColor, bits)?,
        other => return Err(Problem::new(format!("a format takes bits per channel or `g`, not `{other}`"))),
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What POV-Ray's own `+GI` file says of a word.
    fn ini(words: &str) -> String {
        let mut settings = Settings::default();
        for word in words.split(' ') {
            if let Err(problem) = read(word, &mut settings) {
                return format!("error: {}", problem.message);
            }
        }
        settings.to_string().trim_end().replace('\n', " ")
    }

    /// Each row was read by POV-Ray itself: `povray a.pov WORDS +GIout.ini`.
    #[test]
    fn switches_mean_what_povray_takes_them_for() {
        let rows = [
            ("+W640.7", "Width=640"),
            ("-W640", "Width=640"),
            ("+w640", "Width=640"),
            ("+W640 +W320", "Width=320"),
            ("+A", "Antialias=On"),
            ("-A", "Antialias=Off"),
            ("+A0.3", "Antialias=On Antialias_Threshold=0.3"),
            ("-A0.3", "Antialias=Off Antialias_Threshold=0.3"),
            ("+A0.010000", "Antialias=On Antialias_Threshold=0.01"),
            ("+A03", "Antialias=On Antialias_Threshold=3"),
            ("+A00.5", "Antialias=On Antialias_Threshold=0.5"),
            ("+A0.3.4", "Antialias=On Antialias_Threshold=0.3"),
            ("+Am2", "Sampling_Method=2"),
            ("+AG1.5", "Antialias_Gamma=1.5"),
            ("+F", "Output_To_File=On"),
            ("-F", "Output_To_File=Off"),
            ("-FN", "Output_File_Type=N Output_To_File=Off"),
            ("+FN16", "Bits_Per_Color=16 Output_File_Type=N Output_To_File=On"),
            ("+fPG", "Grayscale_Output=On Output_File_Type=P Output_To_File=On"),
            ("-D0GA", "Display=Off Palette=G Video_Mode=0"),
            ("-DGT", "Display=Off Palette=T Video_Mode=G"),
            ("+X100", "Test_Abort=On Test_Abort_Count=100"),
            ("-MB5", "Bounding=Off Bounding_Threshold=5"),
            ("+J0.5", "Jitter=On Jitter_Amount=0.5"),
            ("+KC", "Cyclic_Animation=On"),
            ("+KF2", "Final_Clock=2"),
            ("+KFF4", "Final_Frame=4"),
            ("+K-3", "Clock=-3"),
            ("-K0.5", "Clock=0.5"),
            ("+RFI", "Radiosity_From_File=On"),
            ("+RFfoo", "Radiosity_File_Name=\"foo\""),
            ("+SF1.5", "Subset_Start_Frame=1.5"),
            ("+SC.3", "Start_Column=0.3"),
            ("+SU", "Split_Unions=On"),
            ("+THb4", "Dither=On Dither_Method=B4"),
            ("-TH", "Dither=Off"),
            ("-GAfoo", "All_Console=Off All_File=\"foo\""),
            ("+O\"foo", "Output_File_Name=\"foo\""),
            ("+I'a.pov'", "Input_File_Name=\"a.pov\""),
            ("-Lfoo", "Library_Path=\"foo\""),
            ("+MV3.6", "Version=3.6"),
            ("+HIfoo.inc", "Include_Header=\"foo.inc\""),
        ];
        for (words, expected) in rows {
            assert_eq!(ini(words), expected, "{words}");
        }
    }

    #[test]
    fn switches_povray_refuses_are_refused() {
        let refused = [
            "+A.1",
            "+A1",
            "+A2",
            "+A0",
            "+A0x",
            "+A1.0",
            "+AM",
            "+AGsrgb",
            "+B5",
            "+BM",
            "+C1",
            "+FD",
            "+FS",
            "+FX",
            "+FN16g",
            "+FNg16",
            "+FNx",
            "+I",
            "+K",
            "+KC1",
            "+KFF",
            "+Kabc",
            "+L",
            "+MVx",
            "+O",
            "+P5",
            "+Q",
            "+R",
            "+SPx",
            "+TH2",
            "+THxx",
            "+UA1",
            "+V5",
            "+ZZ",
            "-",
            "+",
            "--",
            "-Z",
            "+Width=5",
            "+O\"foo\"bar",
            "+\u{e9}",
        ];
        for word in refused {
            assert!(ini(word).starts_with("error: "), "{word}: {}", ini(word));
        }
    }
}
