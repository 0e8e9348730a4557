//! POV-Ray's command line (docs/spec/camera-image.md 16 to 21).

use super::{Desk, size};
use std::fs;
use std::process::{Command, Stdio};

/// The table of docs/spec/camera-image.md 19.
#[test]
fn exit_codes_and_files_are_those_of_povray() {
    let rows: &[(&str, i32, &[&str])] = &[
        ("a.pov", 0, &["a.png"]),
        ("+Ia", 0, &["a.png"]),
        ("a.pov -F", 0, &[]),
        ("a.pov +FT", 0, &["a.tga"]),
        ("a.pov +FC", 0, &["a.tga"]),
        ("a.pov +FP", 0, &["a.ppm"]),
        ("a.pov +FB", 0, &["a.bmp"]),
        ("a.pov +FJ", 0, &["a.jpg"]),
        ("a.pov +FH", 0, &["a.hdr"]),
        ("a.pov +FE", 0, &["a.exr"]),
        ("a.pov +FS", 1, &[]),
        ("a.pov +Ofoo", 0, &["foo.png"]),
        ("a.pov +Ofoo.tga", 0, &["foo.tga.png"]),
        ("a.pov +O.png", 0, &["a.png"]),
        ("a.pov +Ofoo.", 0, &["foo.png"]),
        ("a.pov +Ofoo.PNG", 0, &["foo.PNG.png"]),
        ("a.pov +FJ +O-", 1, &[]),
        ("nope.pov", 1, &[]),
        ("", 1, &[]),
        ("a.pov +ZZ", 1, &[]),
        ("a.pov +EC11", 1, &[]),
        ("a.pov +SC5 +EC3", 0, &["a.png"]),
        ("a.pov +Omissing/a.png", 1, &[]),
        ("a.pov +KFF3", 0, &["a1.png", "a2.png", "a3.png"]),
        ("a.pov +KFF10 +SF4 +EF5", 0, &["a04.png", "a05.png"]),
        ("a.pov +KFF12 +SF20", 0, &["a20.png"]),
        ("a.pov +KFF3 +KC +EF4", 0, &["a1.png", "a2.png", "a3.png", "a4.png"]),
        ("a.pov +KFF3 +SF2 +EF1", 0, &["a2.png"]),
        ("a.pov +KFI3 +KFF1", 0, &["a3.png"]),
        ("a.pov +KFF3 +STP0", 0, &["a1.png", "a2.png", "a3.png"]),
        ("Input_File_Name=a.pov Output_File_Name=x.png", 0, &["x.png"]),
        ("input_file_name=\"a.pov\" Output_to_file=off", 0, &[]),
        ("a.pov Output_File_Type=png", 0, &["a.ppm"]),
        ("a.pov nope.pov +Ia.pov", 0, &["a.png"]),
        ("a.pov +FTg", 1, &[]),
        ("a.pov +Oa.pov/x", 1, &[]),
        ("a.pov Include_Ini=empty.ini", 0, &["a.png"]),
        ("a.pov +HInope.inc", 1, &[]),
        ("a.pov x=y.pov", 1, &[]),
        ("a.pov -", 1, &[]),
        ("a.pov Foo=1", 1, &[]),
        ("nope.ini", 1, &[]),
    ];
    for (line, code, pictures) in rows {
        let desk = Desk::new();
        let answer = desk.povray(&format!("{line} +W8 +H8 -D"));
        assert_eq!(answer.code, Some(*code), "{line}: {}", answer.err);
        assert_eq!(desk.pictures(), *pictures, "{line}");
        assert!(answer.out.is_empty(), "{line}");
    }
}

#[test]
fn the_picture_is_the_only_thing_on_standard_output() {
    let desk = Desk::new();
    let png = desk.povray("a.pov +O- +W8 +H6 -D");
    assert_eq!(png.code, Some(0), "{}", png.err);
    let picture = image::load_from_memory_with_format(&png.out, image::ImageFormat::Png).unwrap();
    assert_eq!((picture.width(), picture.height()), (8, 6));

    let ppm = desk.povray("+FP a.pov Output_File_Name=stdout +W8 +H6");
    assert!(ppm.out.starts_with(b"P6\n8 6\n255\n") && ppm.out.len() == 11 + 8 * 6 * 3);
    assert_eq!(desk.pictures(), Vec::<String>::new());
}

#[test]
fn what_programs_look_for_is_on_standard_error_in_ascii() {
    let desk = Desk::new();
    let answer = desk.povray("a.pov +W80 +H60 +V -D +A0.1");
    assert_eq!(answer.code, Some(0), "{}", answer.err);
    assert!(answer.err.is_ascii());
    for text in [
        "==== [Parsing...] =",
        "==== [Rendering...] =",
        "(100%)",
        "Input file: a.pov",
        "Image resolution.....80 by 60 (rows 1 to 60, columns 1 to 80).",
        "Output file..........a.png, 24 bpp PNG",
        "POV-Ray finished",
    ] {
        assert!(answer.err.contains(text), "{text} is not in\n{}", answer.err);
    }
    assert!(answer.err.split(['\n', '\r']).all(|line| line.len() <= 80));
}

#[test]
fn an_error_names_file_and_line() {
    let desk = Desk::new();
    desk.write("bad.pov", "#version 3.7;\n\nsphere { z*3, 1 pigment { rgb \u{e4}foo } }\n");
    let answer = desk.povray("bad.pov +W8 +H8 -D");
    assert_eq!(answer.code, Some(1));
    assert!(answer.err.contains("File 'bad.pov' line 3: Parse Error: "), "{}", answer.err);
    assert!(
        answer.err.ends_with("Fatal error in parser: Cannot parse input.\nRender failed\n\n"),
        "{}",
        answer.err
    );
    assert!(answer.err.is_ascii());
    assert_eq!(desk.pictures(), Vec::<String>::new());
}

#[test]
fn words_of_programs_that_drive_povray_are_understood() {
    let desk = Desk::new();
    desk.write(
        "t.ini",
        "; made by a program\nInput_File_Name='a.pov'\nHeight=13.99\nWidth = \"20\" ; pixels\nDisplay=OFF\n",
    );
    for line in [
        "t.ini",
        "Height=5 t.ini",
        "t.ini Antialias=True Antialias_Threshold=0.010000 -A",
        "-D t.ini output_file_type=n Output_to_File=1 +UA -UA",
    ] {
        let answer = desk.povray(line);
        assert_eq!(answer.code, Some(0), "{line}: {}", answer.err);
        assert_eq!(size(&desk.path("a.png")), (20, 13), "{line}");
    }
    assert_eq!(desk.povray("t.ini +H7").code, Some(0));
    assert_eq!(size(&desk.path("a.png")), (20, 7), "a later word wins");
}

#[test]
fn a_scene_on_standard_input_that_nobody_reads_does_no_harm() {
    let desk = Desk::new();
    desk.povray("--version");
    let mut child = Command::new(desk.path("povray"))
        .args(["a.pov", "+W8", "+H8", "-D"])
        .current_dir(desk.folder.path())
        .env("POVINI", desk.path("empty.ini"))
        .stdin(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    assert!(child.wait().unwrap().success());
    assert_eq!(desk.pictures(), ["a.png"]);
}

#[test]
fn a_scene_can_come_from_standard_input() {
    let desk = Desk::new();
    let scene = fs::File::open(desk.path("a.pov")).unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_povista"))
        .args(["+I-", "+O-", "+W8", "+H8"])
        .env("POVINI", desk.path("empty.ini"))
        .stdin(scene)
        .output()
        .unwrap();
    assert!(output.status.success());
    assert!(output.stdout.starts_with(b"\x89PNG"));
}

#[test]
fn a_reader_that_goes_away_ends_the_run_with_two() {
    let desk = Desk::new();
    let mut child = Command::new(env!("CARGO_BIN_EXE_povista"))
        .args(["a.pov", "+O-", "+W400", "+H300"])
        .current_dir(desk.folder.path())
        .env("POVINI", desk.path("empty.ini"))
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    assert_eq!(child.wait().unwrap().code(), Some(2));
}

#[test]
fn a_bad_place_for_the_picture_is_known_before_rendering() {
    let desk = Desk::new();
    let answer = desk.povray("a.pov +Omissing/a.png +W4000 +H3000");
    assert_eq!(answer.code, Some(1));
    assert!(!answer.err.contains("Rendering..."), "{}", answer.err);
    fs::create_dir(desk.path("a.png")).unwrap();
    assert_eq!(desk.povray("a.pov +W4000 +H3000").code, Some(1));
}

#[test]
fn a_picture_that_cannot_be_made_leaves_the_old_one() {
    let desk = Desk::new();
    assert_eq!(desk.povray("a.pov +W8 +H8").code, Some(0));
    let old = fs::read(desk.path("a.png")).unwrap();
    desk.write("a.pov", "#error \"no\"");
    assert_eq!(desk.povray("a.pov +W9 +H9").code, Some(1));
    assert_eq!(fs::read(desk.path("a.png")).unwrap(), old);
    assert_eq!(desk.pictures(), ["a.png"]);
}

#[test]
fn a_picture_that_exists_is_kept_when_a_trace_is_continued() {
    let desk = Desk::new();
    desk.write("a.png", "something");
    let answer = desk.povray("a.pov +C +W8 +H8");
    assert_eq!(answer.code, Some(0));
    assert!(answer.err.contains("File already rendered and continue requested; skipping."));
    assert_eq!(fs::read(desk.path("a.png")).unwrap(), b"something");
}

#[test]
fn only_a_part_of_the_picture_is_rendered() {
    let desk = Desk::new();
    assert_eq!(desk.povray("a.pov +W10 +H8 +SC3 +EC5 +SR2 +ER4").code, Some(0));
    let picture = image::open(desk.path("a.png")).unwrap().to_rgb8();
    for (x, y, pixel) in picture.enumerate_pixels() {
        let rendered = (2..5).contains(&x) && (1..4).contains(&y);
        assert_eq!(pixel.0 != [0, 0, 0], rendered, "{x} {y}");
    }
}

#[test]
fn streams_are_silenced_and_written_to_files() {
    let desk = Desk::new();
    desk.write("d.pov", "#version 3.7;\n#debug \"from the scene\\n\"\n#warning \"a doubt\"\n");
    let answer = desk.povray("d.pov +W8 +H8 -GA +GDtrue +GWdoubts.txt");
    assert_eq!(answer.code, Some(0), "{}", answer.err);
    assert!(!answer.err.contains("from the scene") && !answer.err.contains("Input file"), "{}", answer.err);
    assert!(answer.err.contains("==== [Parsing...] ="));
    assert_eq!(fs::read_to_string(desk.path("debug.out")).unwrap(), "from the scene\n");
    assert!(
        fs::read_to_string(desk.path("doubts.txt")).unwrap().contains("File 'd.pov' line 3: Parse Warning: ")
    );
    assert_eq!(desk.povray("d.pov +W8 +H8 +GWa/b").code, Some(1));
}

#[test]
fn effective_options_are_written_as_an_ini_file() {
    let desk = Desk::new();
    assert_eq!(desk.povray("a.pov +W8 +H8 +A0.3 Declare=Size=3 +GIout.ini -F").code, Some(0));
    let ini = fs::read_to_string(desk.path("out.ini")).unwrap();
    for line in [
        "Antialias=On",
        "Antialias_Threshold=0.3",
        "Height=8",
        "Width=8",
        "Declare=Size=3",
        "Output_To_File=Off",
    ] {
        assert!(ini.lines().any(|other| other == line), "{line} is not in\n{ini}");
    }
}

#[test]
fn constants_and_clock_reach_the_scene() {
    let desk = Desk::new();
    let scene = r##"#version 3.7;
#debug concat("size ", str(Size, 0, 3), " text ", Word, " clock ", str(clock, 0, 3), " on ", str(clock_on, 0, 0), "\n")
"##;
    desk.write("c.pov", scene);
    desk.write("c.ini", "Declare=Size=2.5\nDeclare=Word=\"hello\"\nDeclare=Size=7\n");
    // What is declared first stays, as with POV-Ray.
    let answer = desk.povray("c.ini c.pov Declare=Size=3 +K0.25 +W8 +H8 -F");
    assert!(answer.err.contains("size 2.500 text hello clock 0.250 on 1\n"), "{}", answer.err);
}

/// `povray.ini` in the current folder is read unasked, and may have come along with a scene.
#[test]
fn an_ini_file_that_nobody_named_writes_no_further_than_a_scene() {
    let desk = Desk::new();
    fs::remove_file(desk.path("empty.ini")).unwrap();
    fs::create_dir_all(desk.path("home/.ssh")).unwrap();
    let elsewhere = tempfile::tempdir().unwrap();
    let victim = elsewhere.path().join("victim.png");
    for line in [
        format!("Output_File_Name={}", victim.display()),
        "Output_File_Name=home/.ssh/config".to_owned(),
        format!("Create_Ini={}", victim.display()),
        format!("Output_File_Name={}/\nAll_File=victim.png", elsewhere.path().display()),
    ] {
        desk.write("povray.ini", &line);
        let answer = desk.povray("a.pov +W8 +H8");
        assert_eq!(answer.code, Some(1), "{line}");
        assert!(answer.err.contains("not permitted"), "{line}: {}", answer.err);
        assert!(fs::read_dir(elsewhere.path()).unwrap().next().is_none(), "{line}");
    }
    // The current folder is the scene's to write in.
    desk.write("povray.ini", "Output_File_Name=b.png\nAll_File=on");
    assert_eq!(desk.povray("a.pov +W8 +H8").code, Some(0));
    assert!(desk.path("b.png").exists() && desk.path("alltext.out").exists());
    // What the user types, or says in a file they name, goes where they say.
    desk.write("povray.ini", "Output_File_Name=/nowhere/a.png");
    assert_eq!(desk.povray(&format!("a.pov +W8 +H8 +O{}", victim.display())).code, Some(0));
    desk.write("mine.ini", &format!("Output_File_Name={}", elsewhere.path().join("mine.png").display()));
    assert_eq!(desk.povray("mine.ini a.pov +W8 +H8").code, Some(0));
    assert!(victim.exists() && elsewhere.path().join("mine.png").exists());
}

#[cfg(unix)]
#[test]
fn no_link_leads_the_text_of_a_found_ini_file_elsewhere() {
    let desk = Desk::new();
    fs::remove_file(desk.path("empty.ini")).unwrap();
    let elsewhere = tempfile::tempdir().unwrap();
    let victim = elsewhere.path().join("victim");
    std::os::unix::fs::symlink(&victim, desk.path("alltext.out")).unwrap();
    desk.write("povray.ini", "All_File=on");
    assert_eq!(desk.povray("a.pov +W8 +H8").code, Some(1));
    assert!(!victim.exists());
}

#[test]
fn the_old_default_is_numbers_as_they_are_and_version_makes_them_light() {
    let desk = Desk::new();
    desk.write("g.pov", "camera { } background { rgb <0.5, 0.25, 0.7> }");
    let pixel = |words: &str| {
        let answer = desk.povray(&format!("g.pov +W2 +H2 {words}"));
        assert_eq!(answer.code, Some(0), "{}", answer.err);
        image::open(desk.path("g.png")).unwrap().to_rgb8().get_pixel(0, 0).0
    };
    assert_eq!(pixel(""), [128, 64, 179]);
    assert_eq!(pixel("+MV3.6"), [128, 64, 179]);
    assert_eq!(pixel("+MV3.7"), [188, 137, 218]);
    assert_eq!(pixel("+MV3.7 File_Gamma=1.0"), [128, 64, 179]);
}

#[test]
fn asking_for_version_or_help_is_a_success() {
    let desk = Desk::new();
    for word in ["--version", "-version", "--V", "--help", "-help", "-h", "-?"] {
        let answer = desk.povray(word);
        assert_eq!(answer.code, Some(0), "{word}");
        assert_eq!(desk.povray(&format!("+W8 a.pov {word}")).code, Some(0), "{word}");
        assert!(answer.err.contains("povista") || answer.err.contains("povray"), "{word}");
    }
}
