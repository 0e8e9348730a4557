//! The tables for the terminal.

use std::collections::BTreeMap;
use std::fmt::Write;

use crate::report::Report;
use crate::suite::Case;
use crate::timing::{Timing, mean_ratios};
use crate::verdict::Verdict;

/// What povista says before the name of a feature it can't render.
const UNSUPPORTED: &str = "not supported yet:";

/// One line per case and a line of sums.
pub fn cases(report: &Report) -> String {
    let width = width(report.cases.iter().map(|case| case.scene.as_str()));
    let mut table = format!(
        "{:width$}  {:8}  {:>5}  {:>6}  {:>6}  {:>6}  {:>8}  {:>8}\n",
        "scene", "verdict", "worst", "near %", "mean", "RMSE", "povray s", "povista s",
    );
    for case in report.cases {
        let _ = writeln!(table, "{}", row(case, width).trim_end());
    }
    let sums: Vec<String> = Verdict::ALL
        .into_iter()
        .filter(|&verdict| report.count(verdict) > 0)
        .map(|verdict| format!("{} {verdict}", report.count(verdict)))
        .collect();
    let _ = writeln!(table, "{} scenes: {}", report.cases.len(), sums.join(", "));
    table
}

fn row(case: &Case, width: usize) -> String {
    let figures = match &case.difference {
        Some(d) => {
            // Rounded down, so that 100 is all of them.
            let near = (d.near * 10_000.0).floor() / 100.0;
            format!("{:>5}  {near:>6.2}  {:>6.2}  {:>6.2}", d.worst, d.mean, d.rmse)
        }
        None => format!("{:29}", ""),
    };
    format!(
        "{:width$}  {:8}  {figures}  {:>8.2}  {:>9.2}  {}",
        case.scene, case.verdict, case.povray_seconds, case.povista_seconds, case.message
    )
}

/// What keeps scenes from matching, the commonest first: features povista refuses, then other
/// messages, each with its number of scenes.
pub fn features(report: &Report) -> String {
    let mut counts: BTreeMap<String, Vec<&str>> = BTreeMap::new();
    for case in report.cases {
        let what = match case.verdict {
            Verdict::Match | Verdict::Excluded => continue,
            Verdict::Differs => "another picture".to_owned(),
            _ => feature(&case.message),
        };
        counts.entry(what).or_default().push(&case.scene);
    }
    let mut counts: Vec<_> = counts.into_iter().collect();
    counts.sort_by_key(|(_, scenes)| std::cmp::Reverse(scenes.len()));
    let mut table = String::new();
    for (what, scenes) in counts {
        let _ = writeln!(table, "{:>4}  {what}  (such as {})", scenes.len(), scenes[0]);
    }
    table
}

/// What a message is about: the unsupported feature, or the message without its place.
fn feature(message: &str) -> String {
    if let Some((_, feature)) = message.split_once(UNSUPPORTED) {
        return format!("{UNSUPPORTED} {}", feature.trim());
    }
    let message = message.split_once("Error: ").map_or(message, |(_, what)| what);
    message.trim().to_owned()
}

/// One line per scene with least times and ratios, and their geometric mean.
pub fn timings(timings: &[Timing]) -> String {
    let width = width(timings.iter().map(|timing| timing.scene.as_str()));
    let mut table = format!(
        "{:width$}  {:>10}  {:>10}  {:>7}  {:>10}  {:>10}  {:>7}\n",
        "scene", "povray s", "povista s", "ratio", "povray CPU", "povista CPU", "ratio"
    );
    for timing in timings {
        let (a, b, ratio) = (timing.povray, timing.povista, timing.ratios());
        let _ = writeln!(
            table,
            "{:width$}  {:>10.3}  {:>10.3}  {:>6.1}x  {:>10.3}  {:>11.3}  {:>6.1}x",
            timing.scene, a.wall, b.wall, ratio.wall, a.cpu, b.cpu, ratio.cpu
        );
    }
    if let Some(mean) = mean_ratios(timings) {
        let _ = writeln!(
            table,
            "geometric mean of {} ratios: {:.1}x by the clock, {:.1}x in processor time",
            timings.len(),
            mean.wall,
            mean.cpu
        );
    }
    table
}

fn width<'a>(names: impl Iterator<Item = &'a str>) -> usize {
    names.map(|name| name.chars().count()).max().unwrap_or(0).max("scene".len())
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
            "scene          verdict   worst  near %    mean    RMSE  povray s  povista s\n\
             a.pov          match         3   99.99    0.12    0.50      1.00       0.50\n\
             long/name.pov  refused                                      1.00       0.50  error: not supported yet: media\n\
             2 scenes: 1 match, 1 refused\n"
        );
    }

    #[test]
    fn features_are_counted_wherever_they_stand() {
        let cases = [
            case("a.pov", Verdict::Refused, "File 'a.pov' line 3: Parse Error: not supported yet: media"),
            case("b.pov", Verdict::Refused, "error: bad number"),
            case("c.pov", Verdict::Refused, "File 'c.pov' line 9: Parse Error: not supported yet: media"),
            case("d.pov", Verdict::Match, ""),
        ];
        let report = Report { povray: "", povista: "", cases: &cases };
        assert_eq!(
            features(&report),
            "   2  not supported yet: media  (such as a.pov)\n   1  error: bad number  (such as b.pov)\n"
        );
    }
}
