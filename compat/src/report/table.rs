//! The tables for the terminal.

use std::collections::BTreeMap;
use std::fmt::Write;

use crate::reading::Reading;
use crate::report::Report;
use crate::suite::Case;
use crate::timing::{Times, Timing, mean_ratios};
use crate::verdict::Verdict;

/// What heads the columns of [`times`].
const TIMES: &str = "povray s povista s  ratio  povray CPU povista CPU  ratio";

/// One line per case and a line of sums; times and their ratio where they were taken.
pub fn cases(report: &Report) -> String {
    let timings: Vec<Timing> = report.cases.iter().filter_map(|case| case.times).collect();
    let timed = !timings.is_empty();
    let name = |case: &Case| case.scene.chars().count();
    let width = report.cases.iter().map(name).max().unwrap_or(0).max("scene".len());
    let head = format!(
        "{:width$}  {:8}  {:>5}  {:>6}  {:>6}  {:>6}  {}",
        "scene",
        "verdict",
        "worst",
        "near %",
        "mean",
        "RMSE",
        if timed { TIMES } else { "" }
    );
    let mut table = format!("{}\n", head.trim_end());
    for case in report.cases {
        let row = format!("{:width$}  {:8}  {}  ", case.scene, case.verdict, figures(case));
        let _ = writeln!(table, "{}", (row + &times(case.times.as_ref(), timed) + &case.message).trim_end());
    }
    let sums: Vec<String> = Verdict::ALL
        .into_iter()
        .filter(|&verdict| report.count(verdict) > 0)
        .map(|verdict| format!("{} {verdict}", report.count(verdict)))
        .collect();
    let _ = writeln!(table, "{} scenes: {}", report.cases.len(), sums.join(", "));
    table + &mean(&timings)
}

fn figures(case: &Case) -> String {
    match &case.difference {
        Some(d) => {
            format!("{:>5}  {:>6.2}  {:>6.2}  {:>6.2}", d.worst, d.near_percent(), d.mean, d.rmse)
        }
        None => format!("{:29}", ""),
    }
}

fn times(timing: Option<&Timing>, timed: bool) -> String {
    match timing {
        Some(timing) => {
            let (a, b, ratio) = (timing.povray, timing.povista, timing.ratios());
            format!(
                "{:>8.3} {:>9.3} {:>5.1}x  {:>10.3} {:>11.3} {:>5.1}x  ",
                a.wall, b.wall, ratio.wall, a.cpu, b.cpu, ratio.cpu
            )
        }
        None if timed => format!("{:57}", ""),
        None => String::new(),
    }
}

/// The line below a table of times.
fn mean(timings: &[Timing]) -> String {
    mean_ratios(timings).map_or_else(String::new, |Times { wall, cpu }| {
        let count = timings.len();
        format!("geometric mean of {count} ratios: {wall:.1}x by the clock, {cpu:.1}x in CPU time\n")
    })
}

/// One line per scene with the times of reading it, and the mean of the ratios.
pub fn reading_times(scenes: &[(String, Timing)]) -> String {
    let width = scenes.iter().map(|(scene, _)| scene.chars().count()).max().unwrap_or(0).max("scene".len());
    let row = |(scene, timing): &(String, Timing)| {
        format!("{}\n", format!("{scene:width$}  {}", times(Some(timing), true)).trim_end())
    };
    let rows: String = scenes.iter().map(row).collect();
    let timings: Vec<Timing> = scenes.iter().map(|&(_, timing)| timing).collect();
    format!("{:width$}  {TIMES}\n{rows}{}", "scene", mean(&timings))
}

/// What keeps scenes from matching, the commonest first: features povista refuses, then other
/// messages, each with its number of scenes.
pub fn features(report: &Report) -> String {
    let failing = report.cases.iter().filter_map(|case| match case.verdict {
        Verdict::Match | Verdict::Excluded => None,
        Verdict::Differs => Some((case.scene.as_str(), "another picture".to_owned())),
        _ => Some((case.scene.as_str(), feature(&case.message))),
    });
    counted(failing)
}

/// What keeps scenes from being read, the commonest first, and how many are read.
pub fn readings(readings: &[Reading]) -> String {
    let failing = readings.iter().filter_map(|reading| {
        let error = reading.error.as_ref()?;
        Some((reading.scene.as_str(), feature(error)))
    });
    let failing: Vec<_> = failing.collect();
    let read = readings.len() - failing.len();
    format!("{}{read} of {} scenes are read without error\n", counted(failing.into_iter()), readings.len())
}

/// One line for each different reason, with the number of its scenes and one of them.
fn counted<'a>(failing: impl Iterator<Item = (&'a str, String)>) -> String {
    let mut counts: BTreeMap<String, Vec<&str>> = BTreeMap::new();
    for (scene, reason) in failing {
        counts.entry(reason).or_default().push(scene);
    }
    let mut counts: Vec<_> = counts.into_iter().collect();
    counts.sort_by_key(|(_, scenes)| std::cmp::Reverse(scenes.len()));
    let line = |(reason, scenes): &(String, Vec<&str>)| {
        format!("{:>4}  {reason}  (such as {})\n", scenes.len(), scenes[0])
    };
    counts.iter().map(line).collect()
}

/// What a message is about: all of it but its place.
fn feature(message: &str) -> String {
    message.split_once("Error: ").map_or(message, |(_, what)| what).trim().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expectations::tests::case;
    use crate::picture::Difference;

    #[test]
    fn a_row_for_each_case_and_the_sums() {
        let mut good = case("a.pov", Verdict::Match, "");
        good.difference = Some(Difference { worst: 3, near: 0.99999, mean: 0.125, rmse: 0.5 });
        let refused = case("long/name.pov", Verdict::Refused, "error: not supported yet: media");
        let report = Report { povray: "", povista: "", cases: &[good, refused] };
        assert_eq!(
            cases(&report),
            "scene          verdict   worst  near %    mean    RMSE\n\
             a.pov          match         3   99.99    0.12    0.50\n\
             long/name.pov  refused                                  error: not supported yet: media\n\
             2 scenes: 1 match, 1 refused\n"
        );
    }

    #[test]
    fn times_stand_under_their_heads() {
        let mut good = case("a.pov", Verdict::Match, "");
        let times = |seconds| Times { wall: seconds, cpu: seconds / 2.0 };
        good.times = Some(Timing { povray: times(3.0), povista: times(0.5) });
        let report =
            Report { povray: "", povista: "", cases: &[good, case("b.pov", Verdict::Refused, "no")] };
        assert_eq!(
            cases(&report),
            "scene  verdict   worst  near %    mean    RMSE  povray s povista s  ratio  povray CPU povista CPU  ratio\n\
             a.pov  match                                       3.000     0.500   6.0x       1.500       0.250   6.0x\n\
             b.pov  refused                                                                                           no\n\
             2 scenes: 1 match, 1 refused\n\
             geometric mean of 1 ratios: 6.0x by the clock, 6.0x in CPU time\n"
        );
    }

    #[test]
    fn features_are_counted_wherever_they_stand() {
        let cases = [
            case("a.pov", Verdict::Refused, "File 'a.pov' line 3: Parse Error: `media` is not supported yet"),
            case("b.pov", Verdict::Refused, "error: bad number"),
            case("c.pov", Verdict::Refused, "File 'c.pov' line 9: Parse Error: `media` is not supported yet"),
            case("d.pov", Verdict::Match, ""),
        ];
        let report = Report { povray: "", povista: "", cases: &cases };
        assert_eq!(
            features(&report),
            "   2  `media` is not supported yet  (such as a.pov)\n   1  error: bad number  (such as b.pov)\n"
        );
    }

    #[test]
    fn what_is_not_read_is_counted() {
        let reading = |scene: &str, error: Option<&str>| Reading {
            scene: scene.to_owned(),
            error: error.map(str::to_owned),
        };
        let all = [reading("a.pov", None), reading("b.pov", Some("File 'b.pov' line 1: Parse Error: odd"))];
        assert_eq!(readings(&all), "   1  odd  (such as b.pov)\n1 of 2 scenes are read without error\n");
    }
}
