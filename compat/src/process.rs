//! One run of a program: its own copy of the scene's folder, bounded time and memory.

use std::fs::{self, File};
use std::io;
use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use tempfile::TempDir;
use walkdir::WalkDir;

/// Address space a program may use, in KiB; more is a failed allocation, not a frozen machine.
const MEMORY_KIB: u64 = 8 << 20;

/// A program that sleeps or waits may take this many times its CPU limit by the clock.
const WALL_PER_CPU: u32 = 4;

/// A scene's folder larger than this is not copied.
const FOLDER_BYTES: u64 = 1 << 30;

/// A program that ignores its CPU limit is killed this many seconds later.
const HARD_SECONDS: u64 = 5;

/// Signal the kernel sends a program past its CPU limit.
const SIGXCPU: i32 = 24;

/// A private copy of a scene's folder, so scenes that write files leave the installed ones alone.
#[derive(Debug)]
pub struct Sandbox {
    root: TempDir,
}

impl Sandbox {
    /// Copies `folder` with all it holds.
    pub fn copy_of(folder: &Path) -> io::Result<Self> {
        let sandbox = Sandbox { root: tempfile::Builder::new().prefix("povista-compat-").tempdir()? };
        let inner = sandbox.scene_folder();
        let mut bytes = 0;
        for entry in WalkDir::new(folder).follow_links(true) {
            let entry = entry?;
            let below = entry.path().strip_prefix(folder).map_err(io::Error::other)?;
            let to = inner.join(below);
            if entry.file_type().is_dir() {
                fs::create_dir_all(to)?;
                continue;
            }
            bytes += entry.metadata()?.len();
            if bytes > FOLDER_BYTES {
                return Err(io::Error::other(format!("{} is too large to copy", folder.display())));
            }
            fs::write(to, fs::read(entry.path())?)?;
        }
        Ok(sandbox)
    }

    /// The copy: the program's working directory.
    pub fn scene_folder(&self) -> PathBuf {
        self.root.path().join("scene")
    }

    /// Where the program is told to put its picture, beside the copy.
    pub fn picture(&self) -> PathBuf {
        self.root.path().join("out.png")
    }

    /// Runs `program` in the copy until it ends or has used `cpu` of processor time.
    pub fn run(&self, program: &Path, arguments: &[String], cpu: Duration) -> io::Result<Finished> {
        let text = self.root.path().join("text");
        let file = File::create(&text)?;
        let seconds = cpu.as_secs().max(1);
        let start = Instant::now();
        // The shell sets the limits and becomes the program, so its process id is the program's.
        let mut child = Command::new("/bin/sh")
            .arg("-c")
            .arg(format!(
                "ulimit -c 0; ulimit -t {}; ulimit -S -t {seconds}; ulimit -v {MEMORY_KIB}; exec \"$0\" \"$@\"",
                seconds + HARD_SECONDS
            ))
            .arg(program)
            .args(arguments)
            .current_dir(self.scene_folder())
            .stdin(Stdio::null())
            .stdout(file.try_clone()?)
            .stderr(file)
            .spawn()?;
        let status = wait(&mut child, start + cpu * WALL_PER_CPU)?;
        let wall = start.elapsed();
        let text = String::from_utf8_lossy(&fs::read(&text)?).into_owned();
        Ok(Finished { ended: status.map_or(Ended::OutOfTime, Ended::from), text, wall })
    }
}

/// Waits for `child` until `deadline`, when it is killed and there is no status.
fn wait(child: &mut Child, deadline: Instant) -> io::Result<Option<ExitStatus>> {
    let mut pause = Duration::from_micros(200);
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(Some(status));
        }
        if Instant::now() > deadline {
            child.kill()?;
            child.wait()?;
            return Ok(None);
        }
        thread::sleep(pause);
        pause = (pause * 5 / 4).min(Duration::from_millis(5));
    }
}

/// How a process ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ended {
    /// By itself, with this exit code.
    Code(i32),
    /// By this signal.
    Signal(i32),
    /// Stopped at its limit.
    OutOfTime,
}

impl From<ExitStatus> for Ended {
    fn from(status: ExitStatus) -> Self {
        match (status.code(), status.signal()) {
            (Some(code), _) => Ended::Code(code),
            (None, Some(SIGXCPU)) => Ended::OutOfTime,
            (None, signal) => Ended::Signal(signal.unwrap_or(0)),
        }
    }
}

/// What a process left behind.
#[derive(Clone, Debug)]
pub struct Finished {
    /// How it ended.
    pub ended: Ended,
    /// All it wrote to standard output and standard error.
    pub text: String,
    /// Time by the clock.
    pub wall: Duration,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shell(script: &str, cpu: u64) -> Finished {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("a.inc"), "kept").unwrap();
        let sandbox = Sandbox::copy_of(folder.path()).unwrap();
        let arguments = ["-c".to_owned(), script.to_owned()];
        let finished = sandbox.run(Path::new("/bin/sh"), &arguments, Duration::from_secs(cpu)).unwrap();
        assert_eq!(fs::read_to_string(folder.path().join("a.inc")).unwrap(), "kept");
        finished
    }

    #[test]
    fn a_program_works_on_a_copy() {
        let finished = shell("cat a.inc >&2; echo changed > a.inc; exit 3", 10);
        assert_eq!(finished.ended, Ended::Code(3));
        assert_eq!(finished.text, "kept");
    }

    #[test]
    fn an_endless_loop_is_stopped() {
        assert_eq!(shell("while :; do :; done", 1).ended, Ended::OutOfTime);
    }

    #[test]
    fn a_sleeper_is_stopped_by_the_clock() {
        assert_eq!(shell("exec sleep 60", 1).ended, Ended::OutOfTime);
    }

    #[test]
    fn a_signal_is_told_from_an_exit_code() {
        assert_eq!(shell("kill -s ABRT $$", 10).ended, Ended::Signal(6));
    }
}
