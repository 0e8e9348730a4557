//! Runs that are stopped, continued and restricted (docs/spec/camera-image.md 18, 21 and 25).

use super::Desk;
use std::fs;

/// A picture that takes long enough to be stopped.
#[cfg(unix)]
const SLOW: &str = "#version 3.7; global_settings { assumed_gamma 1 }
camera { location -5*z aperture 0.1 focal_point 0 blur_samples 60 variance 0 }
light_source { <5, 5, -5> rgb 1 area_light x, y, 60, 60 }
union { sphere { 0, 1 } plane { y, -1 } pigment { bozo } }
";

#[cfg(unix)]
#[test]
fn a_stopped_picture_is_continued_to_the_same_bytes() {
    use std::process::{Command, Stdio};
    use std::time::{Duration, Instant};

    let desk = Desk::new();
    desk.write("s.pov", SLOW);
    let words = ["s.pov", "+W128", "+H96", "+BS8", "+WT2", "-D"];
    let line = words.join(" ");
    assert_eq!(desk.povray(&line).code, Some(0));
    let (picture, state) = (desk.path("s.png"), desk.path("s.pov-state"));
    let whole = fs::read(&picture).unwrap();
    assert!(!state.exists());

    for signal in ["-INT", "-QUIT", "-TERM"] {
        fs::remove_file(&picture).unwrap();
        let mut child = Command::new(desk.path("povray"))
            .args(words)
            .current_dir(desk.folder.path())
            .env("POVINI", desk.path("empty.ini"))
            .stdin(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let begun = || fs::metadata(&state).is_ok_and(|file| file.len() > 5000);
        while !begun() && child.try_wait().unwrap().is_none() {
            std::thread::sleep(Duration::from_millis(5));
        }
        let asked = Instant::now();
        assert!(Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap().success());
        assert_eq!(child.wait().unwrap().code(), Some(2), "{signal}");
        assert!(asked.elapsed() < Duration::from_secs(2), "{signal}");
        assert!(state.exists() && desk.pictures().is_empty(), "{signal}: {:?}", desk.pictures());

        let answer = desk.povray(&format!("{line} +C"));
        assert_eq!(answer.code, Some(0), "{}", answer.err);
        assert!(answer.err.contains("Continuing from s.pov-state: "), "{}", answer.err);
        assert!(fs::read(&picture).unwrap() == whole && !state.exists(), "{signal}");
    }
}

#[test]
fn programs_run_on_the_way_may_be_forbidden() {
    let desk = Desk::new();
    desk.write("home/.povray/3.7/povray.conf", "[Shellout Security]\nforbidden\n");
    let answer = desk.povray("a.pov +W8 +H8 Pre_Scene_Command=ls");
    assert_eq!(answer.code, Some(0), "{}", answer.err);
    assert!(answer.err.contains("Execution of shellout 'ls' prohibited"), "{}", answer.err);
    desk.write("r.ini", "Post_Frame_Command=touch \"%o.done\", %s ; a comment\n");
    let answer = desk.povray("r.ini a.pov +W8 +H8");
    assert_eq!(answer.code, Some(0), "{}", answer.err);
    assert!(answer.err.contains("Execution of shellout 'touch' prohibited"), "{}", answer.err);
    assert!(!desk.path("a.png.done").exists());
    desk.write("r.ini", "Pre_Frame_Command=touch x\nPre_Frame_Return=F\n");
    assert_eq!(desk.povray("r.ini a.pov +W8 +H8").code, Some(1));
}

#[test]
fn programs_run_where_they_are_asked_for() {
    let desk = Desk::new();
    // The file that is read first, whatever the user's own says.
    desk.write("empty.ini", "Post_Scene_Command=touch done\n");
    let answer = desk.povista("a.pov --size 8x8");
    assert!(!desk.path("done").exists(), "{}", answer.err);
    let answer = desk.povista("a.pov --size 8x8 --allow-shell");
    assert!(desk.path("done").exists(), "{}", answer.err);
}

/// Without rules of the user's own: scenes write beside themselves, beside the picture and in the current folder.
#[test]
#[cfg(unix)]
fn a_scene_writes_nowhere_else() {
    use std::os::unix::fs::symlink;
    let desk = Desk::new();
    let away = tempfile::tempdir().unwrap();
    fs::create_dir(away.path().join("scene")).unwrap();
    for folder in ["sub/deep", "pictures", "home/.ssh"] {
        fs::create_dir_all(desk.path(folder)).unwrap();
    }
    desk.write("home/.ssh/config", "Host");
    symlink(away.path(), desk.path("out")).unwrap();
    symlink(away.path().join("new"), desk.path("new.txt")).unwrap();
    symlink(away.path().join("new.png"), desk.path("linked.png")).unwrap();
    let outside = away.path().join("a.txt").display().to_string();
    let beside = away.path().join("scene/a.txt").display().to_string();
    let scene = away.path().join("scene/a.pov");
    let write = |name: &str, mode: &str, line: &str| {
        fs::write(&scene, format!("{}\n#fopen F \"{name}\" {mode} #write(F, 1) #fclose F", super::SCENE))
            .unwrap();
        desk.povista(&format!("{} --size 8x8 -o pictures/a.png {line}", scene.display())).code == Some(0)
    };
    for (name, permitted) in [
        ("a.txt", true),
        ("sub/deep/a.txt", true),
        ("pictures/a.txt", true),
        (&*beside, true),
        (&*outside, false),
        ("../a.txt", false),
        ("/etc/povista", false),
        ("out/a.txt", false),
        ("new.txt", false),
        ("home/.ssh/config", false),
        (".bashrc", false),
        ("sub", false),
    ] {
        for mode in ["write", "append"] {
            assert_eq!(write(name, mode, ""), permitted, "{name} {mode}");
        }
    }
    assert_eq!(fs::read_to_string(desk.path("home/.ssh/config")).unwrap(), "Host");
    let allow = format!("--allow-write {}", away.path().display());
    assert!(write(&outside, "write", &allow) && write("out/b.txt", "append", &allow));
    // A picture does not follow a link out of its folder either.
    let answer = desk.povista("a.pov --size 8x8 -o linked.png");
    assert!(answer.code == Some(1) && answer.err.contains("--allow-write"), "{}", answer.err);
    assert!(!away.path().join("new.png").exists() && !away.path().join("new").exists());
}

/// A file that has no end is not read.
#[test]
#[cfg(unix)]
fn what_is_no_ordinary_file_is_not_opened() {
    let desk = Desk::new();
    assert!(std::process::Command::new("mkfifo").arg(desk.path("pipe")).status().unwrap().success());
    for text in [
        "#include \"/dev/zero\"",
        "#include \"pipe\"",
        "#fopen F \"pipe\" read",
        "#fopen F \"pipe\" write",
        "#fopen F \"/dev/null\" write",
        "plane { z, 1 pigment { image_map { png \"/dev/zero\" } } }",
    ] {
        desk.write("a.pov", text);
        let answer = desk.povista("check a.pov");
        assert_eq!(answer.code, Some(1), "{text}: {}", answer.err);
    }
}

#[test]
fn a_scene_keeps_to_the_folders_its_user_permits() {
    let desk = Desk::new();
    desk.write("secret/key.inc", "#declare Key = 1;");
    desk.write("in.pov", "#include \"secret/key.inc\"");
    desk.write("out.pov", "#fopen F \"secret/new.txt\" write");
    desk.write("image.pov", "plane { z, 1 pigment { image_map { png \"secret/a.png\" } } }");
    desk.write("secret/a.png", "");
    let conf = |security: &str| {
        let text = format!("[File I/O Security]\n{security}\n[Permitted Paths]\nread+write = .\n");
        desk.write("home/.povray/3.7/povray.conf", &text);
    };
    conf("restricted");
    for line in ["in.pov", "out.pov", "image.pov", "a.pov +Osecret/a", "secret/none.pov"] {
        let answer = desk.povray(&format!("{line} +W8 +H8"));
        assert_eq!(answer.code, Some(1), "{line}: {}", answer.err);
        let said = answer.err.split_whitespace().collect::<Vec<_>>().join(" ");
        let refused = said.contains("not permitted by povray.conf");
        assert_eq!(refused, line != "secret/none.pov", "{line}: {}", answer.err);
    }
    assert_eq!(desk.povray("a.pov +W8 +H8").code, Some(0));
    conf("read-only");
    assert_eq!(desk.povray("in.pov +W8 +H8").code, Some(0));
    assert_eq!(desk.povray("out.pov +W8 +H8").code, Some(1));
    conf("none");
    assert_eq!(desk.povray("out.pov +W8 +H8").code, Some(0));
    assert!(desk.path("secret/new.txt").exists());
}

#[test]
fn what_only_older_versions_knew_is_let_pass_in_ini_files() {
    let desk = Desk::new();
    desk.write("old.ini", "Create_Histogram=on\nHistogram_Name=h\nBuffer_Output=on\nBuffer_Size=64\n");
    let answer = desk.povray("old.ini a.pov +W8 +H8");
    assert_eq!(answer.code, Some(0), "{}", answer.err);
    assert!(answer.err.contains("`Create_Histogram` is no longer used"), "{}", answer.err);
    assert_eq!(desk.povray("a.pov +W8 +H8 Create_Histogram=on").code, Some(1));
}
