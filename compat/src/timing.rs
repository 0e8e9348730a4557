//! Both programs timed on the same scenes: in turn, nothing beside, no cache.

use std::io;
use std::time::Duration;

use nix::sys::resource::{UsageWho, getrusage};
use nix::sys::time::TimeVal;
use serde::Serialize;

use crate::program::{Outcome, Program};
use crate::scene::Scene;

/// A time below this, in seconds, is not told from none.
const LEAST: f64 = 1e-4;

/// Least times of one program on one scene, in seconds.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Times {
    /// By the clock.
    pub wall: f64,
    /// On all processors together, as user and as system.
    pub cpu: f64,
}

impl Times {
    /// Lowers each time to that of another run, where that is less.
    fn least(&mut self, other: Times) {
        self.wall = self.wall.min(other.wall);
        self.cpu = self.cpu.min(other.cpu);
    }
}

/// Both programs on one scene.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Timing {
    /// POV-Ray's least times.
    pub povray: Times,
    /// povista's least times.
    pub povista: Times,
}

impl Timing {
    /// What any run is less than.
    const UNKNOWN: Timing = {
        let times = Times { wall: f64::INFINITY, cpu: f64::INFINITY };
        Timing { povray: times, povista: times }
    };

    /// How many times faster povista is by the clock and in processor time.
    pub fn ratios(&self) -> Times {
        let ratio = |povray: f64, povista: f64| povray / povista.max(LEAST);
        Times {
            wall: ratio(self.povray.wall, self.povista.wall),
            cpu: ratio(self.povray.cpu, self.povista.cpu),
        }
    }
}

/// Times one scene in `rounds` pairs of runs; nothing where either program makes no picture.
pub fn time(
    povray: &Program,
    povista: &Program,
    scene: &Scene,
    threads: u32,
    rounds: usize,
    limit: Duration,
) -> io::Result<Option<Timing>> {
    let mut timing = Timing::UNKNOWN;
    for _ in 0..rounds.max(1) {
        for (program, least) in [(povray, &mut timing.povray), (povista, &mut timing.povista)] {
            let Some(times) = once(program, scene, threads, limit)? else {
                return Ok(None);
            };
            least.least(times);
        }
    }
    Ok(Some(timing))
}

/// Times the reading of one scene alone: what POV-Ray calls its parse time against all of a run of
/// `povista check`, start-up included. Nothing where either doesn't read it.
pub fn time_reading(
    povray: &Program,
    povista: &Program,
    scene: &Scene,
    rounds: usize,
    limit: Duration,
) -> io::Result<Option<Timing>> {
    let mut timing = Timing::UNKNOWN;
    let arguments = [&format!("+I{}", scene.file_name()), "+W1", "+H1", "-D", "-F", "+WT1"];
    let arguments = arguments.map(str::to_owned);
    for _ in 0..rounds.max(1) {
        let finished = povray.run(scene, &arguments, limit)?;
        let Some(times) = parse_time(&finished.text) else { return Ok(None) };
        timing.povray.least(times);
        let before = children()?;
        let (finished, None) = povista.check(scene, limit)? else { return Ok(None) };
        timing.povista.least(Times { wall: finished.wall.as_secs_f64(), cpu: children()? - before });
    }
    Ok(Some(timing))
}

/// The parse time among POV-Ray's closing statistics.
fn parse_time(text: &str) -> Option<Times> {
    let (_, text) = text.split_once("Parse Time:")?;
    let (wall, text) = text.split_once('(')?.1.split_once(" seconds)")?;
    let (_, cpu) = text.split_once(" CPU-seconds")?.0.rsplit_once(' ')?;
    Some(Times { wall: wall.parse().ok()?, cpu: cpu.parse().ok()? })
}

/// The geometric mean of the timings' ratios; nothing of none.
pub fn mean_ratios(timings: &[Timing]) -> Option<Times> {
    let mean = |ratio: fn(Times) -> f64| {
        let logs: f64 = timings.iter().map(|timing| ratio(timing.ratios()).ln()).sum();
        (logs / timings.len() as f64).exp()
    };
    (!timings.is_empty()).then(|| Times { wall: mean(|r| r.wall), cpu: mean(|r| r.cpu) })
}

/// One run. Processor time is that of all children that ended meanwhile, of which there is one.
fn once(program: &Program, scene: &Scene, threads: u32, limit: Duration) -> io::Result<Option<Times>> {
    let before = children()?;
    let rendering = program.render(scene, threads, limit)?;
    let times = Times { wall: rendering.wall, cpu: children()? - before };
    Ok(matches!(rendering.outcome, Outcome::Picture(_)).then_some(times))
}

/// Processor seconds of all children that have ended.
fn children() -> io::Result<f64> {
    let usage = getrusage(UsageWho::RUSAGE_CHILDREN)?;
    let seconds = |time: TimeVal| time.tv_sec() as f64 + time.tv_usec() as f64 * 1e-6;
    Ok(seconds(usage.user_time()) + seconds(usage.system_time()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ratios_are_averaged_geometrically() {
        let timing = |povray, povista| Timing {
            povray: Times { wall: povray, cpu: 8.0 },
            povista: Times { wall: povista, cpu: 2.0 },
        };
        let mean = mean_ratios(&[timing(1.0, 1.0), timing(9.0, 1.0)]).unwrap();
        assert!((mean.wall - 3.0).abs() < 1e-12 && (mean.cpu - 4.0).abs() < 1e-12, "{mean:?}");
        assert_eq!(mean_ratios(&[]), None);
    }

    #[test]
    fn parse_time_is_read_from_the_closing_statistics() {
        let text = "Render Statistics\n  Photon Time:      No photons\n  \
            Parse Time:       0 hours  0 minutes 12 seconds (12.296 seconds)\n              \
            using 1 thread(s) with 11.288 CPU-seconds total\n  \
            Bounding Time:    0 hours  0 minutes  0 seconds (0.001 seconds)\n";
        assert_eq!(parse_time(text), Some(Times { wall: 12.296, cpu: 11.288 }));
        assert_eq!(parse_time("Fatal error in parser: no"), None);
    }

    #[test]
    fn processor_time_is_the_childs() {
        let before = children().unwrap();
        let script = "i=0; while [ $i -lt 200000 ]; do i=$((i+1)); done";
        assert!(std::process::Command::new("sh").args(["-c", script]).status().unwrap().success());
        assert!(children().unwrap() - before > 0.02);
    }
}
