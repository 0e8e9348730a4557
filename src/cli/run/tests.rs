//! Programs around a run, and pictures that are continued.

use super::*;
use crate::cli::povray;
use crate::cli::restrictions::Restrictions;
use crate::cli::settings::{Name, Settings};
use crate::diag::Stream;

const SCENE: &str = "#version 3.7; global_settings { assumed_gamma 1 }
camera { } sphere { z*3, 1 pigment { rgb 1 } } light_source { <5, 5, -5> rgb 1 }";

/// Hears what is said.
#[derive(Default)]
struct Listener {
    said: Vec<String>,
}

impl Sink for Listener {
    fn diagnostic(&mut self, _: Diagnostic, _: &Sources) {}
    fn text(&mut self, _: Stream, _: &str) {}
}

impl Report for Listener {
    fn begin(&mut self, _: &Job, _: &Frame, _: Option<&Place>) {}
    fn parsing(&mut self) {}
    fn rendering(&mut self, _: &Job, _: Duration, _: Duration) {}
    fn progress(&self) -> &dyn Progress {
        &()
    }
    fn skipped(&mut self, _: &Place) {
        self.say("skipped");
    }
    fn finished(&mut self, _: &Summary) {}
    fn say(&mut self, text: &str) {
        self.said.push(text.to_owned());
    }
    fn stopping(&self) -> Stopping {
        Box::new(|_, _| ())
    }
}

/// A folder with a scene.
struct Desk(tempfile::TempDir);

impl Desk {
    fn new(scene: &str) -> Self {
        let desk = Self(tempfile::tempdir().expect("a folder for the test"));
        std::fs::write(desk.path("a.pov"), scene).expect("the folder takes files");
        desk
    }

    fn path(&self, name: &str) -> std::path::PathBuf {
        self.0.path().join(name)
    }

    /// What a command line does, with every moment's program writing to a log and ending with `code`.
    fn job(&self, words: &str, answers: &[(Name, &str)], code: u8) -> Job {
        let mut settings = Settings::default();
        let log = self.path("log");
        for (name, tag) in [
            (Name::PreSceneCommand, "PS"),
            (Name::PreFrameCommand, "PF"),
            (Name::PostFrameCommand, "OF"),
            (Name::PostSceneCommand, "OS"),
            (Name::UserAbortCommand, "UA"),
            (Name::FatalErrorCommand, "FE"),
        ] {
            let answers_here = answers.iter().any(|(answer, _)| answer.as_str()[..6] == name.as_str()[..6]);
            let code = if answers_here { code } else { 0 };
            let command = format!("echo {tag}%n >>'{}'; exit {code}", log.display());
            settings.read(name, &command).expect("text");
        }
        for (name, answer) in answers {
            settings.read(*name, answer).expect("text");
        }
        let scene = self.path("a.pov").display().to_string();
        for word in [scene.as_str(), "+W40", "+H30", "+BS8"].into_iter().chain(words.split_whitespace()) {
            povray::read(word, &mut settings).expect("a known switch");
        }
        Job::new(&settings, Restrictions { shellouts: true, ..Restrictions::default() }).expect("a job")
    }

    fn log(&self) -> String {
        let log = std::fs::read_to_string(self.path("log")).unwrap_or_default();
        let _ = std::fs::remove_file(self.path("log"));
        log.split_whitespace().collect::<Vec<_>>().join(" ")
    }
}

/// What a result means: finished, halted with an error, or stopped.
fn end(result: Result<(), Failure>) -> &'static str {
    match result {
        Ok(()) => "good",
        Err(Failure::Abandoned) => "stopped",
        Err(_) => "bad",
    }
}

/// The order is POV-Ray's own; what the answers bring about is what its manual says (docs/spec/camera-image.md 25).
#[cfg(unix)]
#[test]
fn programs_run_in_order_and_their_answers_are_obeyed() {
    use Name::{PostFrameReturn, PostSceneReturn, PreFrameReturn, PreSceneReturn};
    let rows = [
        (PreSceneReturn, "I", 3, "PS1 PF1 OF1 PF2 OF2 OS2", "good"),
        (PreSceneReturn, "F", 0, "PS1 PF1 OF1 PF2 OF2 OS2", "good"),
        (PreSceneReturn, "-F", 3, "PS1 PF1 OF1 PF2 OF2 OS2", "good"),
        (PreSceneReturn, "F", 3, "PS1 FE1", "bad"),
        (PreSceneReturn, "!F", 0, "PS1 FE1", "bad"),
        (PreSceneReturn, "S", 3, "PS1 OS1", "good"),
        (PreSceneReturn, "A", 3, "PS1", "good"),
        (PreSceneReturn, "Q", 3, "PS1", "good"),
        (PreSceneReturn, "U", 3, "PS1 UA1 OS1", "stopped"),
        (PreFrameReturn, "S", 3, "PS1 PF1 PF2 OS2", "good"),
        (PreFrameReturn, "A", 3, "PS1 PF1 OS1", "good"),
        (PreFrameReturn, "Q", 3, "PS1 PF1", "good"),
        (PreFrameReturn, "U", 3, "PS1 PF1 UA1 OS1", "stopped"),
        (PreFrameReturn, "F", 3, "PS1 PF1 FE1", "bad"),
        (PostFrameReturn, "S", 3, "PS1 PF1 OF1 OS1", "good"),
        (PostFrameReturn, "F", 3, "PS1 PF1 OF1 FE1", "bad"),
        (PostSceneReturn, "S", 3, "PS1 PF1 OF1 PF2 OF2 OS2", "good"),
        (PostSceneReturn, "U", 3, "PS1 PF1 OF1 PF2 OF2 OS2 UA2", "stopped"),
        (PostSceneReturn, "F", 3, "PS1 PF1 OF1 PF2 OF2 OS2 FE2", "bad"),
    ];
    for (answer, letter, code, order, ending) in rows {
        let desk = Desk::new(SCENE);
        let result = run(&desk.job("+KFF2", &[(answer, letter)], code), &mut Listener::default());
        assert_eq!((desk.log().as_str(), end(result)), (order, ending), "{answer:?}={letter}, {code}");
    }
}

#[cfg(unix)]
#[test]
fn an_error_runs_the_program_for_errors_alone() {
    let desk = Desk::new("#error \"no\"");
    let job = desk.job("", &[], 0);
    assert_eq!(end(run(&job, &mut Listener::default())), "bad");
    assert_eq!(desk.log(), "PS0 PF0 FE0");
}

#[test]
fn a_picture_that_is_there_has_no_program_after_it() {
    let desk = Desk::new(SCENE);
    std::fs::write(desk.path("a.png"), "picture").expect("the folder takes files");
    let mut listener = Listener::default();
    assert_eq!(end(run(&desk.job("+C", &[], 0), &mut listener)), "good");
    assert_eq!(listener.said, ["skipped"]);
    if cfg!(unix) {
        assert_eq!(desk.log(), "PS0 PF0 OS0");
    }
}

#[test]
fn a_continued_picture_is_the_same_to_the_byte() {
    let desk = Desk::new(SCENE);
    let picture = || std::fs::read(desk.path("a.png")).expect("the picture is there");
    let state = desk.path("a.pov-state");
    for look in ["", "+A0.05", "+A0.05 +AM2 +UA +SC3 +ER20"] {
        let job = |words: &str| desk.job(&format!("{look} {words}"), &[], 0);
        run(&job(""), &mut Listener::default()).expect("a picture");
        let whole = picture();
        assert!(!state.exists());

        // Half of the blocks are there, the last of them torn.
        let job = job("+C +WT1");
        let (scene, _, sources) = read::scene(&job, &job.first_language(), &mut Listener::default())
            .unwrap_or_else(|_| panic!("a scene"));
        let fingerprint = state::fingerprint(&sources, &job.first_language(), &job.render);
        let kept = resume::begin(&job, state.clone(), fingerprint, &mut |_| ());
        let world = compile::compile(scene, &job.render).world;
        render::render(&world, &job.render, &Resume::new(&(), kept.as_ref()));
        drop(kept);
        let bytes = std::fs::read(&state).expect("the state is there");
        std::fs::write(&state, &bytes[..bytes.len() / 2]).expect("the folder takes files");

        let mut listener = Listener::default();
        run(&job, &mut listener).expect("a picture");
        assert!(listener.said[0].starts_with("Continuing from "), "{look}: {:?}", listener.said);
        assert!(picture() == whole, "{look}");
        assert!(!state.exists());
    }
}

#[test]
fn the_state_of_an_older_scene_is_not_continued() {
    let desk = Desk::new(SCENE);
    let job = desk.job("+C", &[], 0);
    std::fs::write(desk.path("a.pov-state"), "POV-Ray's own").expect("the folder takes files");
    std::fs::write(desk.path("a.png"), "an old picture").expect("the folder takes files");
    let mut listener = Listener::default();
    run(&job, &mut listener).expect("a picture");
    assert!(listener.said[0].ends_with("the picture is begun anew."), "{:?}", listener.said);
    assert!(image::open(desk.path("a.png")).is_ok() && !desk.path("a.pov-state").exists());
}
