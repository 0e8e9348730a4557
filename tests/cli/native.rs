//! povista's own command line.

use super::{Desk, size};
use std::fs;

#[test]
fn a_scene_alone_is_rendered_beside_itself_and_summed_up() {
    let desk = Desk::new();
    let answer = desk.povista("a.pov --size 32x24");
    assert_eq!(answer.code, Some(0), "{}", answer.err);
    assert_eq!(size(&desk.path("a.png")), (32, 24));
    for text in ["a.png  32 x 24", "read ", "render ", "768 camera"] {
        assert!(answer.err.contains(text), "{text} is not in\n{}", answer.err);
    }
}

#[test]
fn the_outputs_extension_chooses_the_format() {
    let desk = Desk::new();
    for name in ["b.png", "b.PPM", "b.tga", "b.bmp", "b.jpeg", "b.hdr", "b.exr"] {
        let answer = desk.povista(&format!("render a.pov -o {name} --size 8x6"));
        assert_eq!(answer.code, Some(0), "{name}: {}", answer.err);
        let picture = image::ImageReader::open(desk.path(name)).unwrap();
        assert_eq!(picture.into_dimensions().unwrap(), (8, 6), "{name}");
    }
    let answer = desk.povista("a.pov -o b.webp");
    assert_eq!(answer.code, Some(1));
    assert!(answer.err.contains("povista writes no `.webp` files"), "{}", answer.err);
}

#[test]
fn both_command_lines_make_the_same_picture() {
    let desk = Desk::new();
    let ours = desk.povista(
        "a.pov -o ours.png --size 40x30 --aa 0.1 --aa-method 2 --aa-depth 2 --threads 2 --rows 3-20",
    );
    let theirs = desk.povista("a.pov +Otheirs.png +W40 +H30 +A0.1 +AM2 +R2 +WT1 +SR3 +ER20");
    assert_eq!((ours.code, theirs.code), (Some(0), Some(0)), "{}{}", ours.err, theirs.err);
    assert_eq!(fs::read(desk.path("ours.png")).unwrap(), fs::read(desk.path("theirs.png")).unwrap());
}

#[test]
fn words_of_both_command_lines_are_told_apart() {
    let desk = Desk::new();
    for (line, own) in [
        ("a.pov +W40 --stats", "--stats"),
        ("+Ia.pov --threads 2", "--threads"),
        ("render a.pov +W40", "render"),
    ] {
        let answer = desk.povista(line);
        assert_eq!(answer.code, Some(1), "{line}");
        assert!(
            answer.err.contains("is a word of POV-Ray's") && answer.err.contains(&format!("`{own}`")),
            "{}",
            answer.err
        );
    }
    assert_eq!(desk.povista("a.pov --size 8x6 --clock +1").code, Some(0));
}

#[test]
fn every_accelerator_and_thread_count_gives_the_same_bytes() {
    let desk = Desk::new();
    let mut bytes = Vec::new();
    for words in ["--threads 1", "--threads 8", "--accel linear", "--accel octree", "--accel bvh"] {
        let answer = desk.povista(&format!("a.pov --size 64x48 --aa {words}"));
        assert_eq!(answer.code, Some(0), "{words}: {}", answer.err);
        bytes.push(fs::read(desk.path("a.png")).unwrap());
    }
    assert!(bytes.windows(2).all(|pair| pair[0] == pair[1]));
}

#[test]
fn checking_tells_errors_and_fails() {
    let desk = Desk::new();
    desk.write("bad.pov", "#version 3.7;\nsphere { 0, Radius }\nbox { 0, 1 pigmint { rgb 1 } }\n");
    assert_eq!(desk.povista("check a.pov").code, Some(0));

    let human = desk.povista("check bad.pov");
    let text = String::from_utf8(human.out).unwrap();
    assert_eq!(human.code, Some(1));
    assert!(text.contains("Radius") && text.contains("bad.pov: 2 errors"), "{text}");

    let json = desk.povista("check --format json bad.pov");
    let lines = String::from_utf8(json.out).unwrap();
    let errors: Vec<serde_json::Value> =
        lines.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(errors.iter().filter(|error| error["severity"] == "error").count(), 2);
    assert_eq!(errors[0]["at"]["line"], 2);
    assert_eq!(desk.pictures(), Vec::<String>::new());
}

#[test]
fn a_dump_shows_what_was_understood() {
    let desk = Desk::new();
    let answer = desk.povista("dump a.pov");
    assert_eq!(answer.code, Some(0), "{}", answer.err);
    assert!(String::from_utf8(answer.out).unwrap().contains("sphere"));
}

#[test]
fn pictures_are_compared() {
    let desk = Desk::new();
    assert_eq!(desk.povista("a.pov --size 16x12").code, Some(0));
    assert_eq!(desk.povista("a.pov -o b.png --size 16x12 --quality 0").code, Some(0));

    let same = desk.povista("diff a.png a.png --threshold 0");
    assert_eq!(same.code, Some(0));
    assert!(String::from_utf8(same.out).unwrap().contains("equal                100.000 %"));

    let json = desk.povista("diff a.png b.png --json -o heat.png --threshold 1");
    assert_eq!(json.code, Some(1), "{}", json.err);
    let difference: serde_json::Value = serde_json::from_slice(&json.out).unwrap();
    assert!(difference["max"].as_f64().unwrap() > 1.0);
    assert_eq!(size(&desk.path("heat.png")), (16, 12));

    assert_eq!(desk.povista("diff a.png missing.png").code, Some(1));
    assert_eq!(desk.povista("diff a.png b.png -o heat.xyz").code, Some(1));
    assert_eq!(desk.povista("a.pov -o c.png --size 12x16").code, Some(0));
    let sizes = desk.povista("diff a.png c.png");
    assert_eq!(sizes.code, Some(1));
    assert!(sizes.err.contains("differ in size: 16 by 12 and 12 by 16"), "{}", sizes.err);
    assert_eq!(desk.povista("diff a.png a.pov").code, Some(1));
}

/// Debian's POV-Ray stands beside; without one, the answer says how to get it.
#[test]
fn a_scene_is_compared_with_povray() {
    let desk = Desk::new();
    let answer = desk.povista("compare a.pov --size 32x24 --json");
    assert_eq!(answer.code, Some(0), "{}", answer.err);
    let compared: serde_json::Value = serde_json::from_slice(&answer.out).unwrap();
    assert!(compared["difference"]["max"].as_f64().unwrap() <= 1.0, "{compared}");
    assert_eq!(size(&desk.path("a-compare.png")), (32 * 3 + 16, 24));

    let absent = desk.povista("compare a.pov --povray ./no-such-program");
    assert_eq!(absent.code, Some(1));
    assert!(absent.err.contains("install POV-Ray"), "{}", absent.err);
    desk.write("bad.pov", "sphere { foo }");
    let bad = desk.povista("compare bad.pov");
    assert_eq!(bad.code, Some(1));
    assert!(bad.err.contains("File 'bad.pov' line 1: Parse Error: "), "{}", bad.err);
    assert!(!bad.err.contains("Graphic display"), "{}", bad.err);
    assert_eq!(desk.povista("compare nowhere.pov").code, Some(1));
}

#[test]
fn what_is_not_supported_yet_is_an_error_until_skipped() {
    let desk = Desk::new();
    desk.write(
        "m.pov",
        "#version 3.7;\nglobal_settings {\n  assumed_gamma 1\n  photons { count 100 }\n}\nsphere { z*3, 1 }\n",
    );
    let refused = desk.povista("m.pov --size 8x8");
    assert_eq!(refused.code, Some(1), "{}", refused.err);
    assert!(
        refused.err.contains("not supported yet: ")
            && refused.err.contains("--skip-unsupported")
            && refused.err.contains("m.pov:4:3"),
        "{}",
        refused.err
    );
    assert_eq!(desk.pictures(), Vec::<String>::new());
    let skipped = desk.povista("m.pov --size 8x8 --skip-unsupported");
    assert_eq!(skipped.code, Some(0), "{}", skipped.err);
    assert_eq!(desk.pictures(), ["m.png"]);
}

#[test]
fn bad_input_of_any_kind_ends_with_one() {
    let desk = Desk::new();
    fs::write(desk.path("binary.pov"), [0x89, b'P', b'N', b'G', 0, 1, 2, 0xff, b'{', b'"']).unwrap();
    desk.write("deep.pov", &format!("#declare A = {};", "(".repeat(1_000_000)));
    desk.write("endless.pov", "#while (1) #end");
    desk.write("missing.pov", "#include \"nowhere.inc\"");
    desk.write("folder.pov", "#include \".\"");
    fs::write(desk.path("cut.png"), b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR").unwrap();
    desk.write("image.pov", "plane { z, 1 pigment { image_map { png \"cut.png\" } } }");
    for scene in ["binary", "deep", "endless", "missing", "folder", "image", "nowhere", "."] {
        let name = if scene == "." { ".".to_owned() } else { format!("{scene}.pov") };
        let answer = desk.povista(&format!("{name} --size 8x8 --max-steps 10000"));
        assert_eq!(answer.code, Some(1), "{name}: {}", answer.err);
        assert!(!answer.err.contains("panicked"), "{name}: {}", answer.err);
    }
    assert_eq!(desk.pictures(), ["cut.png"]);
}

#[test]
fn bad_words_end_with_one() {
    let desk = Desk::new();
    for line in [
        "",
        "a.pov --size 8",
        "a.pov --size 0x0",
        "a.pov --threads x",
        "frobnicate",
        "rendr a.pov",
        "a.pov --rows 5-3000",
        "check",
        "check nowhere.pov",
        "a.pov --declare =3",
        "a.pov --bogus",
        "completions tcsh",
        "compare",
    ] {
        assert_eq!(desk.povista(line).code, Some(1), "{line}");
    }
}

#[test]
fn help_and_version_go_to_standard_output() {
    let desk = Desk::new();
    for (line, text) in [
        ("--help", "Examples:"),
        ("-h", "Usage: povista"),
        ("render --help", "--skip-unsupported"),
        ("--version", env!("CARGO_PKG_VERSION")),
        ("completions bash", "_povista()"),
        ("completions fish", "complete -c povista"),
    ] {
        let answer = desk.povista(line);
        assert_eq!(answer.code, Some(0), "{line}");
        assert!(String::from_utf8(answer.out).unwrap().contains(text), "{line}");
        assert!(answer.err.is_empty(), "{line}: {}", answer.err);
    }
}

#[test]
fn the_memory_a_scene_takes_is_bounded() {
    let desk = Desk::new();
    let start = "#version 3.7; global_settings { assumed_gamma 1 } #declare R = seed(1);
        #declare S = \"xxxxxxxxxxxxxxxx\"; #for (I, 1, 16) #declare S = concat(S, S); #end ";
    let check = |text: &str| {
        desk.write("m.pov", &format!("{start}{text}"));
        desk.povista("check m.pov --max-memory 100")
    };
    for text in [
        "#declare A = array[1000]; #for (I, 0, 999) #declare A[I] = concat(S, \"y\"); #end",
        "#declare A = array[4000000];",
        "#declare A = array[2000000]; #declare B = A; #declare B[0] = 1;",
        "#while (rand(R) < 2) sphere { 0, 1 texture { pigment { rgb rand(R) } } } #end",
        "mesh { #while (rand(R) < 2) triangle { 0, x, y*rand(R) } #end }",
    ] {
        let answer = check(text);
        assert_eq!(answer.code, Some(1), "{text}");
        let told = String::from_utf8_lossy(&answer.out).into_owned();
        assert!(told.contains("more than 100 MB of memory"), "{text}: {told}");
    }
    // What is forgotten does not count.
    let answer = check("#for (I, 1, 1000) #declare A = array[100000]; #declare A[0] = 1; #undef A #end");
    assert_eq!(answer.code, Some(0), "{}", answer.err);
}
