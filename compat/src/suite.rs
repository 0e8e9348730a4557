//! Many scenes rendered by both programs, several at a time, and judged.

use std::io;
use std::time::Duration;

use serde::Serialize;

use crate::cache::Cache;
use crate::parallel::each;
use crate::picture::{Difference, Picture};
use crate::program::{Outcome, Program};
use crate::scene::{Scene, invalid};
use crate::timing::Timing;
use crate::verdict::{Verdict, same, same_within_spread};

/// Numbers of threads with which POV-Ray is asked again how much its picture varies.
const SPREAD_THREADS: [u32; 3] = [2, 4, 8];

/// The two programs and how they are run.
#[derive(Debug)]
pub struct Suite {
    /// The reference.
    pub povray: Program,
    /// What is judged; without it only references are made.
    pub povista: Option<Program>,
    /// Where references are kept.
    pub cache: Cache,
    /// Scenes in work at once; POV-Ray sleeps half a second per start, so more than there are cores.
    pub jobs: usize,
    /// Processor time either program may use for one scene.
    pub limit: Duration,
}

/// All that is known of one scene.
#[derive(Clone, Debug, Serialize)]
pub struct Case {
    /// The scene's name.
    pub scene: String,
    /// What it came to.
    pub verdict: Verdict,
    /// povista's or POV-Ray's own words where there is no picture, else how a verdict came about.
    pub message: String,
    /// The figures, where both made pictures of one size.
    pub difference: Option<Difference>,
    /// POV-Ray's own difference between one thread and two, where that was asked.
    pub spread: Option<Difference>,
    /// Times of both, where they were taken for their own sake.
    pub times: Option<Timing>,
    /// About how many seconds POV-Ray took, beside other runs: to start slow scenes first, never a claim.
    #[serde(skip)]
    pub reference_seconds: f64,
    /// PNG files of POV-Ray, povista and the heat map, as far as they exist.
    #[serde(skip)]
    pub pictures: [Option<Vec<u8>>; 3],
}

impl Suite {
    /// Compares all `scenes`, slow ones first, telling `done` of each; the result is in their order.
    pub fn compare(&self, scenes: &[Scene], done: impl Fn(&Case) + Sync) -> io::Result<Vec<Case>> {
        let mut order: Vec<usize> = (0..scenes.len()).collect();
        order.sort_by_key(|&index| std::cmp::Reverse(scenes[index].seconds));
        let compare = |index: usize| {
            let case = self.case(&scenes[index])?;
            done(&case);
            Ok(case)
        };
        each(&order, self.jobs, compare).into_iter().collect()
    }

    /// Compares one scene.
    pub fn case(&self, scene: &Scene) -> io::Result<Case> {
        let reference = self.cache.reference(&self.povray, scene, 1, self.limit)?;
        let mut case = Case {
            scene: scene.name.clone(),
            verdict: Verdict::Excluded,
            message: String::new(),
            difference: None,
            spread: None,
            times: None,
            reference_seconds: reference.wall,
            pictures: [None, None, None],
        };
        let theirs = match reference.outcome {
            Outcome::Picture(png) => png,
            outcome => {
                case.message = format!("povray: {}", no_picture(outcome).1);
                return Ok(case);
            }
        };
        case.pictures[0] = Some(theirs.clone());
        let Some(povista) = &self.povista else {
            case.message = "reference only".to_owned();
            return Ok(case);
        };
        match povista.render(scene, 1, self.limit)?.outcome {
            Outcome::Picture(ours) => self.judge(scene, &mut case, &theirs, ours)?,
            outcome => (case.verdict, case.message) = no_picture(outcome),
        }
        Ok(case)
    }

    /// Fills in what follows from two pictures. POV-Ray is only asked how much its own picture
    /// varies where that decides.
    fn judge(&self, scene: &Scene, case: &mut Case, theirs: &[u8], ours: Vec<u8>) -> io::Result<()> {
        let reference = decode(theirs)?;
        let picture = decode(&ours)?;
        case.pictures[1] = Some(ours);
        case.verdict = Verdict::Differs;
        case.difference = reference.difference(&picture);
        let Some(difference) = &case.difference else {
            let ((w, h), (rw, rh)) = (picture.size(), reference.size());
            case.message = format!("the picture is {w}x{h}, POV-Ray's {rw}x{rh}");
            return Ok(());
        };
        case.pictures[2] = Some(reference.heat_map(&picture).map_err(io::Error::other)?);
        if same(difference) {
            case.verdict = Verdict::Match;
            return Ok(());
        }
        // On a busy machine the first of several threads may do nearly all the work in the old order.
        for threads in SPREAD_THREADS {
            let again = self.cache.reference(&self.povray, scene, threads, self.limit)?;
            if let Outcome::Picture(png) = again.outcome {
                let spread = reference.difference(&decode(&png)?);
                let wider = |known: &Difference| spread.is_some_and(|spread| spread.rmse > known.rmse);
                if case.spread.as_ref().is_none_or(wider) {
                    case.spread = spread;
                }
            }
            if case.spread.is_some_and(|spread| same_within_spread(difference, &spread)) {
                case.verdict = Verdict::Match;
                case.message = "within POV-Ray's own spread".to_owned();
                break;
            }
        }
        Ok(())
    }
}

fn decode(png: &[u8]) -> io::Result<Picture> {
    Picture::decode(png).map_err(|error| invalid(error.to_string()))
}

/// The verdict on a program that made no picture, and why.
fn no_picture(outcome: Outcome) -> (Verdict, String) {
    match outcome {
        Outcome::Picture(_) => (Verdict::Differs, String::new()),
        Outcome::Refused(message) => (Verdict::Refused, message),
        Outcome::Crashed(message) => (Verdict::Crashed, message),
        Outcome::OutOfTime => (Verdict::Timeout, "no picture within the limit".to_owned()),
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use std::fs;
    use std::os::unix::fs::PermissionsExt;
    use std::path::Path;

    use super::*;
    use crate::picture::tests::png;

    /// Writes an executable script. Starting it may meet the file still open for writing in a
    /// process another test is forking off, so it waits until it starts.
    pub(crate) fn write_program(path: &Path, script: &str) {
        fs::write(path, script).unwrap();
        fs::set_permissions(path, fs::Permissions::from_mode(0o755)).unwrap();
        let scratch = tempfile::tempdir().unwrap();
        let try_start = || std::process::Command::new(path).arg("--version").current_dir(&scratch).output();
        while try_start().is_err_and(|e| e.kind() == io::ErrorKind::ExecutableFileBusy) {}
    }

    /// Two programs that copy a picture kept beside each scene, so every verdict can be had at will:
    /// POV-Ray `NAME.theirs` (`NAME.theirs2` with two threads), povista `NAME.ours`.
    struct Bench {
        folder: tempfile::TempDir,
    }

    impl Bench {
        fn new() -> Self {
            let bench = Bench { folder: tempfile::tempdir().unwrap() };
            fs::create_dir(bench.folder.path().join("scenes")).unwrap();
            bench
        }

        fn program(&self, name: &str, suffix: &str, version: &str) -> Program {
            let path = self.folder.path().join(name);
            let script = format!(
                "#!/bin/sh\n\
                 [ \"$1\" = --version ] && echo '{version}' && exit\n\
                 for word; do case $word in\n\
                 +I*) in=${{word#+I}};; +O*) out=${{word#+O}};; +WT2) two=2;;\n\
                 esac; done\n\
                 . ./\"$in\"\n\
                 cp \"$in.{suffix}$two\" \"$out\" 2>/dev/null || cp \"$in.{suffix}\" \"$out\"\n"
            );
            write_program(&path, &script);
            Program::at(path, "").unwrap()
        }

        /// A scene is a shell script here, and can misbehave at will.
        fn scene(&self, name: &str, text: &str, pictures: &[(&str, u8)]) -> Scene {
            let path = self.folder.path().join("scenes").join(name);
            fs::write(&path, text).unwrap();
            for (suffix, grey) in pictures {
                let noisy = suffix.ends_with('2');
                let picture = png(8, 8, |x, _| [if noisy && x < 4 { 0 } else { *grey }; 3]);
                fs::write(format!("{}.{suffix}", path.display()), picture).unwrap();
            }
            Scene { name: name.to_owned(), path, switches: Vec::new(), seconds: 0 }
        }

        fn suite(&self) -> Suite {
            Suite {
                povray: self.program("povray", "theirs", "POV-Ray 3.7"),
                povista: Some(self.program("povista", "ours", "povista 0")),
                cache: Cache::at(self.folder.path().join("cache")).unwrap(),
                jobs: 2,
                limit: Duration::from_secs(1),
            }
        }
    }

    #[test]
    fn each_kind_of_ending_has_its_verdict() {
        let bench = Bench::new();
        let both = [("theirs", 100), ("ours", 100)];
        let ours_only = "case $0 in */povista)";
        let scenes = [
            bench.scene("same.pov", "", &both),
            bench.scene("other.pov", "", &[("theirs", 100), ("ours", 110)]),
            bench.scene(
                "media.pov",
                &format!("{ours_only} echo 'error: not supported yet: media' >&2; exit 1;; esac"),
                &both,
            ),
            bench.scene("panic.pov", &format!("{ours_only} kill -s ABRT $$;; esac"), &both),
            bench.scene("endless.pov", &format!("{ours_only} while :; do :; done;; esac"), &both),
            bench.scene("broken.pov", "echo 'Parse Error: no' >&2; exit 1", &both),
        ];
        let cases = bench.suite().compare(&scenes, |_| ()).unwrap();
        let verdicts: Vec<_> =
            cases.iter().map(|c| (c.scene.as_str(), c.verdict, c.message.as_str())).collect();
        assert_eq!(
            verdicts,
            [
                ("same.pov", Verdict::Match, ""),
                ("other.pov", Verdict::Differs, ""),
                ("media.pov", Verdict::Refused, "error: not supported yet: media"),
                ("panic.pov", Verdict::Crashed, "signal 6"),
                ("endless.pov", Verdict::Timeout, "no picture within the limit"),
                ("broken.pov", Verdict::Excluded, "povray: Parse Error: no"),
            ]
        );
        assert_eq!(cases[0].difference.unwrap().worst, 0);
        assert_eq!(cases[1].difference.unwrap().near, 0.0);
        assert_eq!(cases[1].spread.unwrap().worst, 0);
        assert!(cases[1].pictures.iter().all(Option::is_some));
    }

    #[test]
    fn a_scene_that_varies_by_itself_matches_within_its_spread() {
        let bench = Bench::new();
        let scene = bench.scene("noise.pov", "", &[("theirs", 100), ("theirs2", 100), ("ours", 120)]);
        let case = bench.suite().case(&scene).unwrap();
        assert_eq!(case.verdict, Verdict::Match);
        assert_eq!(case.message, "within POV-Ray's own spread");
        assert_eq!(case.spread.unwrap().rmse, 5000_f64.sqrt());
    }

    #[test]
    fn a_picture_of_another_size_differs() {
        let bench = Bench::new();
        let scene = bench.scene("size.pov", "", &[("theirs", 100)]);
        fs::write(format!("{}.ours", scene.path.display()), png(8, 9, |_, _| [100; 3])).unwrap();
        let case = bench.suite().case(&scene).unwrap();
        assert_eq!(case.verdict, Verdict::Differs);
        assert_eq!(case.message, "the picture is 8x9, POV-Ray's 8x8");
    }
}
