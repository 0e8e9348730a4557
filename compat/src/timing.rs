//! Both programs timed on the same scenes: in turn, nothing beside, no cache.

use std::io;
use std::time::Duration;

use nix::sys::resource::{UsageWho, getrusage};
use nix::sys::time::TimeVal;
use serde::Serialize;

use crate::program::{Outcome, Program};
use crate::scene::Scene;

/// Least times of one program on one scene, in seconds.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Times {
    /// By the clock.
    pub wall: f64,
    /// On all processors together, as user and as system.
    pub cpu: f64,
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
    /// How many times faster povista is by the clock and in processor time.
    pub fn ratios(&self) -> Times {
        Times { wall: self.povray.wall / self.povista.wall, cpu: self.povray.cpu / self.povista.cpu }
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
    let unknown = Times { wall: f64::INFINITY, cpu: f64::INFINITY };
    let mut timing = Timing { povray: unknown, povista: unknown };
    for _ in 0..rounds.max(1) {
        for (program, least) in [(povray, &mut timing.povray), (povista, &mut timing.povista)] {
            let Some(times) = once(program, scene, threads, limit)? else {
                return Ok(None);
            };
            least.wall = least.wall.min(times.wall);
            least.cpu = least.cpu.min(times.cpu);
        }
    }
    Ok(Some(timing))
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
    let cpu = (children()? - before).max(f64::EPSILON);
    Ok(matches!(rendering.outcome, Outcome::Picture(_)).then_some(Times { wall: rendering.wall, cpu }))
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
    fn processor_time_is_the_childs() {
        let before = children().unwrap();
        let script = "i=0; while [ $i -lt 200000 ]; do i=$((i+1)); done";
        assert!(std::process::Command::new("sh").args(["-c", script]).status().unwrap().success());
        assert!(children().unwrap() - before > 0.02);
    }
}
