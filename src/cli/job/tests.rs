//! What options make of a run.

use super::*;
use crate::cli::povray;

fn job(words: &str) -> Result<Job, Problem> {
    let mut settings = Settings::default();
    for word in words.split_whitespace() {
        povray::read(word, &mut settings).expect("a known switch");
    }
    Job::new(&settings, Restrictions::default())
}

/// The rows of docs/spec/camera-image.md 10: columns and rows that are rendered, from 1.
#[test]
fn parts_of_a_picture_are_chosen_as_povray_does() {
    let rows = [
        ("+SC3 +EC5", 3..=5, 1..=8),
        ("+SR2 +ER4", 1..=10, 2..=4),
        ("+SC0.3 +EC0.6", 4..=6, 1..=8),
        ("+SR0.25 +ER0.5", 1..=10, 3..=4),
        ("+SC1 +EC1", 1..=10, 1..=8),
        ("+SC0.99", 10..=10, 1..=8),
        ("+SC2.7 +EC4.9", 2..=4, 1..=8),
    ];
    for (words, columns, rows) in rows {
        let region = job(&format!("a.pov +W10 +H8 {words}")).expect("a region").render.region;
        assert_eq!(region.columns, columns.start() - 1..*columns.end(), "{words}");
        assert_eq!(region.rows, rows.start() - 1..*rows.end(), "{words}");
    }
    assert!(job("a.pov +W10 +H8 +SC5 +EC3").expect("a region").render.region.columns.is_empty());
    for words in ["+EC11", "+SC11", "+EC0.05", "+ER0.0", "+SC-3"] {
        assert!(job(&format!("a.pov +W10 +H8 {words}")).is_err(), "{words}");
    }
}

#[test]
fn values_are_clipped_as_povray_clips_them() {
    let job = job("a.pov +A03 +R20 +J2 +AM5 +Q15 +FN3 +WT0").expect("a job");
    let antialias = job.render.antialias.expect("antialiasing");
    assert_eq!((antialias.threshold, antialias.depth, antialias.jitter), (1.0, 9, 1.0));
    assert_eq!(antialias.method, AntialiasMethod::Adaptive);
    assert_eq!(job.render.quality, 9);
    assert_eq!(job.render.threads, None);
    assert_eq!(job.encoding.expect("an encoding").bits, 5);
}

#[test]
fn antialiasing_is_off_without_a_or_with_method_zero() {
    for words in ["a.pov", "a.pov +A0.1 -A", "a.pov +A +AM0", "a.pov +AM2"] {
        assert_eq!(job(words).expect("a job").render.antialias, None, "{words}");
    }
    assert_eq!(job("a.pov +A -J").expect("a job").render.antialias.map(|a| a.jitter), Some(0.0));
}

#[test]
fn what_a_format_cannot_do_is_refused() {
    for words in ["+FBg", "+FJ +O-", "+FE +Ostdout", "+H0", "+W-5", "+BS3", "+W100000 +H100000"] {
        assert!(job(&format!("a.pov {words}")).is_err(), "{words}");
    }
    assert!(job("+W5").is_err(), "no scene");
    assert!(job("a.pov +FP +O-").is_ok());
}

#[test]
fn alpha_a_format_cannot_hold_is_left_out_with_a_warning() {
    let job = job("a.pov +UA +FJ").expect("a job");
    assert!(!job.render.output_alpha);
    assert_eq!(job.warnings.len(), 1);
}

#[test]
fn without_options_a_picture_is_160_by_120_png() {
    let job = job("dir/a.pov").expect("a job");
    assert_eq!((job.render.width, job.render.height), (160, 120));
    assert_eq!(job.language.input_file_name, "a.pov");
    let frame = job.animation.frames().next().expect("one frame");
    assert_eq!(job.place(&frame), Some(Place::File("dir/a.png".into())));
}

/// Options that change what is done, with what shows it.
type Effect = (&'static str, fn(&Job) -> String, &'static str);

/// Every switch of docs/spec/camera-image.md 17 that has an effect, and the options that have no switch.
const EFFECTS: &[Effect] = &[
    ("+W640", |job| job.render.width.to_string(), "640"),
    ("+H480", |job| job.render.height.to_string(), "480"),
    ("+Isub/b", |job| job.input.clone(), "sub/b"),
    ("+Ofoo", output, "foo.png"),
    ("+FT", output, "a.tga"),
    ("+FC", |job| format(job, |e| e.format), "CompressedTarga"),
    ("+FN", |job| format(job, |e| e.format), "Png"),
    ("+FP", |job| format(job, |e| e.format), "Ppm"),
    ("+FB", |job| format(job, |e| e.format), "Bmp"),
    ("+FJ", |job| format(job, |e| e.format), "Jpeg"),
    ("+FH", |job| format(job, |e| e.format), "Hdr"),
    ("+FE", |job| format(job, |e| e.format), "Exr"),
    ("-FN", output, "none"),
    ("Output_To_File=off", output, "none"),
    ("+FN16", |job| format(job, |e| e.bits), "16"),
    ("Bits_Per_Color=12", |job| format(job, |e| e.bits), "12"),
    ("+FPg", |job| format(job, |e| e.grey), "true"),
    ("Grayscale_Output=on", |job| format(job, |e| e.grey), "true"),
    ("Compression=30", |job| format(job, |e| e.quality), "30"),
    ("Compression=1", |job| format(job, |e| e.quality), "85"),
    ("File_Gamma=1.8", |job| format(job, |e| e.file_gamma), "Power(1.8)"),
    ("Display_Gamma=1.8", |job| format(job, |e| e.display_gamma), "Power(1.8)"),
    ("+UA", |job| format(job, |e| e.alpha), "true"),
    ("+TH", |job| format(job, |e| e.dither), "Some(FloydSteinberg)"),
    ("+THB3", |job| format(job, |e| e.dither), "Some(Bayer(3))"),
    ("Dither_Method=D2", |job| format(job, |e| e.dither), "None"),
    ("Dither=on Dither_Method=D2", |job| format(job, |e| e.dither), "Some(Simple)"),
    ("+C", |job| job.continue_trace.to_string(), "true"),
    ("+SC3", |job| format!("{:?}", job.render.region.columns), "2..160"),
    ("+EC30", |job| format!("{:?}", job.render.region.columns), "0..30"),
    ("+SR3", |job| format!("{:?}", job.render.region.rows), "2..120"),
    ("+ER30", |job| format!("{:?}", job.render.region.rows), "0..30"),
    ("+BS16", |job| job.render.block_size.to_string(), "16"),
    ("+WT3", |job| format!("{:?}", job.render.threads), "Some(3)"),
    ("+Q4", |job| job.render.quality.to_string(), "4"),
    ("+A", |job| look(job, |a| a.threshold), "0.3"),
    ("+A0.1", |job| look(job, |a| a.threshold), "0.1"),
    ("+A +AM2", |job| look(job, |a| a.method), "Adaptive"),
    ("+A +R5", |job| look(job, |a| a.depth), "5"),
    ("+A -J", |job| look(job, |a| a.jitter), "0.0"),
    ("+A +J0.5", |job| look(job, |a| a.jitter), "0.5"),
    ("+A +AG1.5", |job| look(job, |a| a.gamma), "1.5"),
    ("-UR", |job| job.render.remove_bounds.to_string(), "false"),
    ("+SU", |job| job.render.split_unions.to_string(), "true"),
    ("+HR", |job| job.render.high_reproducibility.to_string(), "true"),
    ("+MV3.5", |job| format!("{:?}", job.language.version), "Some(350)"),
    ("+Lfoo", |job| format!("{:?}", job.language.library_paths), "[\"foo\"]"),
    ("+HIh.inc", |job| format!("{:?}", job.language.include_header), "Some(\"h.inc\")"),
    ("Declare=A=2", |job| format!("{:?}", job.language.declares), "[(\"A\", Number(2.0))]"),
    ("+K0.5", frames, "a.png 0.5"),
    ("+KFF2", frames, "a1.png 0 a2.png 1"),
    ("+KFI2 +KFF3", frames, "a2.png 0 a3.png 1"),
    ("+KFF2 +KI3 +KF5", frames, "a1.png 3 a2.png 5"),
    ("+KFF2 +KC", frames, "a1.png 0 a2.png 0.5"),
    ("+KFF5 +SF2 +EF3", frames, "a2.png 0.25 a3.png 0.5"),
    ("+KFF5 +STP3", frames, "a1.png 0 a4.png 0.75"),
];

/// Options whose effect is on the console and its files: `tests/cli` shows it.
const CONSOLE: &[&str] = &[
    "-GA",
    "+GAa.txt",
    "-GD",
    "+GDd.txt",
    "-GF",
    "+GFf.txt",
    "-GR",
    "+GRr.txt",
    "-GS",
    "+GSs.txt",
    "-GW",
    "+GWw.txt",
    "+GP",
    "+GIout.ini",
    "+V",
];

/// Options that POV-Ray takes and that change no picture: displays, order of work, speed.
const WITHOUT_EFFECT: &[&str] = &[
    "-D",
    "+D0GA",
    "+P",
    "+X",
    "+X100",
    "+SP8",
    "+EP4",
    "+RS3",
    "+RP2",
    "+MI64",
    "-MB",
    "+MB5",
    "-B",
    "+BM2",
    "BSP_MaxDepth=3",
    "BSP_BaseAccessCost=2",
    "BSP_ChildAccessCost=2",
    "BSP_ISectCost=2",
    "BSP_MissChance=0.1",
    "+UL",
    "+UV",
    "+UD",
    "+WL3",
    "+RFobject.rca",
    "+RVP",
];

/// Options that do not do what they say, which is said.
const WARNED: &[&str] = &["+UF", "+UO", "+KLA", "+RTR", "+RFI", "+RFO"];

fn format<T: std::fmt::Debug>(job: &Job, part: fn(&Encoding) -> T) -> String {
    job.encoding.as_ref().map_or_else(String::new, |encoding| format!("{:?}", part(encoding)))
}

fn look<T: std::fmt::Debug>(job: &Job, part: fn(&Antialias) -> T) -> String {
    job.render.antialias.as_ref().map_or_else(String::new, |antialias| format!("{:?}", part(antialias)))
}

fn output(job: &Job) -> String {
    let frame = job.animation.frames().next().expect("a frame");
    job.place(&frame).map_or_else(|| "none".to_owned(), |place| place.name())
}

fn frames(job: &Job) -> String {
    let name = |frame: &Frame| job.place(frame).expect("a place").name();
    let frames: Vec<String> =
        job.animation.frames().map(|frame| format!("{} {}", name(&frame), frame.clock.value)).collect();
    frames.join(" ")
}

#[test]
fn options_do_what_they_say() {
    for (words, shown, expected) in EFFECTS {
        assert_eq!(shown(&job(&format!("a.pov {words}")).expect("a job")), *expected, "{words}");
    }
}

#[test]
fn what_has_no_effect_changes_nothing_and_what_is_not_done_is_said() {
    let plain = format!("{:?}", job("a.pov").expect("a job"));
    for words in WITHOUT_EFFECT.iter().chain(CONSOLE) {
        assert_eq!(format!("{:?}", job(&format!("a.pov {words}")).expect("a job")), plain, "{words}");
    }
    for words in WARNED {
        assert_eq!(job(&format!("a.pov {words}")).expect("a job").warnings.len(), 1, "{words}");
    }
}

/// So that no option is parsed and then forgotten.
#[test]
fn every_option_is_in_one_of_the_tables() {
    let mut settings = Settings::default();
    let tables = [CONSOLE, WITHOUT_EFFECT, WARNED].into_iter().flatten().copied();
    for words in EFFECTS.iter().map(|row| row.0).chain(tables) {
        for word in words.split_whitespace() {
            povray::read(word, &mut settings).expect("a known switch");
        }
    }
    let written = settings.to_string();
    let missing: Vec<&str> = Name::all()
        // Those that INI files alone hold, or are: `cli::run` and `tests/cli` show what they do.
        .filter(|name| !matches!(name.kind(), Kind::Command | Kind::Obsolete | Kind::Ini))
        .map(Name::as_str)
        .filter(|name| !name.ends_with("_Return") && !written.contains(&format!("{name}=")))
        .collect();
    assert_eq!(missing, Vec::<&str>::new());
}
