//! Programs that run before and after scene and frames (docs/spec/camera-image.md 25).

use std::process::Command;

use super::animation::Frame;
use super::job::Job;
use super::output::Place;
use super::settings::{Name, Settings, value};

/// When a program runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Moment {
    /// Before the first frame.
    PreScene,
    /// Before each frame.
    PreFrame,
    /// After each frame that was rendered.
    PostFrame,
    /// After the last frame.
    PostScene,
    /// After the user has stopped the run.
    UserAbort,
    /// After an error.
    FatalError,
}

/// Each moment with the option of its command, that of its answer, and what the console calls it.
const MOMENTS: [(Moment, Name, Name, &str); 6] = [
    (Moment::PreScene, Name::PreSceneCommand, Name::PreSceneReturn, "pre-scene"),
    (Moment::PreFrame, Name::PreFrameCommand, Name::PreFrameReturn, "pre-frame"),
    (Moment::PostFrame, Name::PostFrameCommand, Name::PostFrameReturn, "post-frame"),
    (Moment::PostScene, Name::PostSceneCommand, Name::PostSceneReturn, "post-scene"),
    (Moment::UserAbort, Name::UserAbortCommand, Name::UserAbortReturn, "user-abort"),
    (Moment::FatalError, Name::FatalErrorCommand, Name::FatalErrorReturn, "fatal-error"),
];

/// What a program's exit code makes of the run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Action {
    /// Nothing: the run goes on.
    Ignore,
    /// Skip what comes next.
    Skip,
    /// Skip all frames to come.
    SkipAll,
    /// End at once, as a success.
    Quit,
    /// End as if the user had stopped the run.
    Abort,
    /// End as with an error.
    Fail,
}

impl Action {
    fn of_letter(letter: char) -> Option<Self> {
        Some(match letter.to_ascii_uppercase() {
            'I' => Self::Ignore,
            'S' => Self::Skip,
            'A' => Self::SkipAll,
            'Q' => Self::Quit,
            'U' => Self::Abort,
            'F' => Self::Fail,
            _ => return None,
        })
    }
}

/// A program with its parameters, and what its answer means.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Shellout {
    program: String,
    /// With `%` words that are not replaced yet.
    parameters: String,
    action: Action,
    /// Whether success brings the action about, rather than failure.
    on_success: bool,
}

/// The programs of a run.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Shellouts {
    commands: [Option<Shellout>; MOMENTS.len()],
    /// Whether they may run; otherwise each counts as failed.
    allowed: bool,
}

/// What replaces the `%` words of a command.
#[derive(Debug, Clone)]
pub struct Values {
    /// `%o`: the picture's file with its folder; empty where none is stored.
    output: String,
    /// `%s`: the scene's file without its folder.
    scene: String,
    /// `%n`: the frame, 0 for a still picture.
    frame: i32,
    /// `%k`: its clock.
    clock: f64,
    /// `%w` and `%h`.
    size: (u32, u32),
}

impl Values {
    /// What a frame's commands are told.
    pub fn of(job: &Job, frame: &Frame) -> Self {
        Self {
            output: job.place(frame).as_ref().map(Place::name).unwrap_or_default(),
            scene: job.language.input_file_name.clone(),
            frame: frame.clock.frames.number,
            clock: frame.clock.value,
            size: (job.render.width, job.render.height),
        }
    }

    /// Replaces the `%` words; unknown ones stay, and so does `%%`, as in POV-Ray.
    fn fill(&self, parameters: &str) -> String {
        let mut text = String::with_capacity(parameters.len());
        let mut letters = parameters.chars();
        while let Some(letter) = letters.next() {
            if letter != '%' {
                text.push(letter);
                continue;
            }
            match letters.next() {
                Some('o') => text.push_str(&self.output),
                Some('s') => text.push_str(&self.scene),
                Some('n') => text.push_str(&self.frame.to_string()),
                Some('k') => text.push_str(&format!("{:.6}", self.clock)),
                Some('w') => text.push_str(&self.size.0.to_string()),
                Some('h') => text.push_str(&self.size.1.to_string()),
                Some(other) => text.extend(['%', other]),
                None => text.push('%'),
            }
        }
        text
    }
}

impl Shellouts {
    /// Reads the commands from the options.
    pub fn new(settings: &Settings, allowed: bool) -> Self {
        let commands = MOMENTS.map(|(_, command, answer, _)| {
            shellout(settings.text(command).unwrap_or_default(), settings.text(answer))
        });
        Self { commands, allowed }
    }

    /// Whether there is a command that may not run.
    pub fn are_forbidden(&self) -> bool {
        !self.allowed && self.commands.iter().any(Option::is_some)
    }

    /// Runs the command of a moment, if there is one, and tells what its exit code asks for.
    ///
    /// What went wrong and what follows from it is said to `say`.
    pub fn run(&self, moment: Moment, values: &Values, say: &mut dyn FnMut(&str)) -> Action {
        let Some(shellout) = &self.commands[moment as usize] else { return Action::Ignore };
        let good = if self.allowed {
            start(&shellout.program, &values.fill(&shellout.parameters)).unwrap_or_else(|error| {
                say(&format!("cannot run '{}': {error}", shellout.program));
                false
            })
        } else {
            say(&format!("Execution of shellout '{}' prohibited", shellout.program));
            false
        };
        let action = if good == shellout.on_success { shellout.action } else { Action::Ignore };
        let wish = match action {
            Action::Ignore => return action,
            Action::Skip | Action::SkipAll | Action::Quit if moment == Moment::PostScene => {
                return Action::Ignore;
            }
            Action::Skip if moment == Moment::PreFrame => return action,
            Action::Skip if moment == Moment::PostFrame => "skip all remaining frames",
            Action::Skip | Action::SkipAll => "skip all frames",
            Action::Quit => "quit rendering",
            Action::Abort => "generate a user abort",
            Action::Fail => "generate a fatal error",
        };
        let name = MOMENTS[moment as usize].3;
        say(&format!(
            "Render halted because the {name} shell-out ('{}') requested POV-Ray to {wish}.",
            shellout.program
        ));
        action
    }
}

/// Reads a command and what its answer means; an empty command, or an answer that means nothing, is none.
fn shellout(command: &str, answer: Option<&str>) -> Option<Shellout> {
    let command = command.trim();
    let (program, parameters) = match value::quoted(command) {
        Some(parts) => parts,
        None => command.split_at(command.find([' ', '\t']).unwrap_or(command.len())),
    };
    let answer = answer.unwrap_or("I").trim();
    let letters = answer.strip_prefix(['-', '!']);
    let action = letters.unwrap_or(answer).chars().next().and_then(Action::of_letter)?;
    let (program, parameters) = (program.to_owned(), parameters.trim().to_owned());
    (!program.is_empty()).then_some(Shellout { program, parameters, action, on_success: letters.is_some() })
}

/// Runs a command by the system's shell and tells whether it succeeded.
fn start(program: &str, parameters: &str) -> std::io::Result<bool> {
    let (shell, option) = if cfg!(windows) { ("cmd", "/C") } else { ("sh", "-c") };
    let status = Command::new(shell).arg(option).arg(format!("{program} {parameters}")).status()?;
    Ok(status.success())
}

#[cfg(test)]
mod tests {
    use super::*;

    const VALUES: fn() -> Values = || Values {
        output: "out/a07.png".to_owned(),
        scene: "a.pov".to_owned(),
        frame: 7,
        clock: 0.25,
        size: (8, 6),
    };

    /// What POV-Ray's own shell got of these.
    #[test]
    fn percent_words_of_the_parameters_are_replaced() {
        let rows = [
            ("%o %s %n %k %w %h", "out/a07.png a.pov 7 0.250000 8 6"),
            ("%o%s%n", "out/a07.pnga.pov7"),
            ("%O %x 5%% %", "%O %x 5%% %"),
            ("%%o", "%%o"),
        ];
        for (parameters, expected) in rows {
            assert_eq!(VALUES().fill(parameters), expected, "{parameters}");
        }
    }

    #[test]
    fn the_program_is_the_first_word_and_may_be_quoted() {
        let rows = [
            ("sh  c.sh x", "sh", "c.sh x"),
            ("\"my tool\" \"%s\"", "my tool", "\"%s\""),
            ("\"echo %o\"", "echo %o", ""),
            ("tool", "tool", ""),
        ];
        for (command, program, parameters) in rows {
            let shellout = shellout(command, None).expect("a command");
            assert_eq!((&*shellout.program, &*shellout.parameters), (program, parameters));
            assert_eq!(shellout.action, Action::Ignore);
        }
        assert_eq!(shellout("  ", None), None);
    }

    #[test]
    fn an_answer_is_a_letter_that_may_be_turned_round() {
        let rows = [
            ("F", Some((Action::Fail, false))),
            ("-s", Some((Action::Skip, true))),
            ("!Quit", Some((Action::Quit, true))),
            ("Abort", Some((Action::SkipAll, false))),
            ("u", Some((Action::Abort, false))),
            ("-", None),
            ("", None),
            ("N", None),
        ];
        for (answer, expected) in rows {
            let read = shellout("tool", Some(answer)).map(|shellout| (shellout.action, shellout.on_success));
            assert_eq!(read, expected, "{answer}");
        }
    }

    #[test]
    fn a_program_that_may_not_run_counts_as_failed() {
        let mut settings = Settings::default();
        settings.read(Name::PreFrameCommand, "exit 0").expect("text");
        settings.read(Name::PreFrameReturn, "F").expect("text");
        for (allowed, expected) in [(true, Action::Ignore), (false, Action::Fail)] {
            let shellouts = Shellouts::new(&settings, allowed);
            assert_eq!(shellouts.are_forbidden(), !allowed);
            assert_eq!(shellouts.run(Moment::PreFrame, &VALUES(), &mut |_| ()), expected);
            assert_eq!(shellouts.run(Moment::PostFrame, &VALUES(), &mut |_| ()), Action::Ignore);
        }
    }
}
