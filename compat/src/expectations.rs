//! The scenes known not to match, each with its reason, and the surprises against that list.
//!
//! The file holds a line `SCENE: REASON` for each, sorted; `#` opens a comment. A scene that is
//! listed and matches is as much a surprise as one that isn't and doesn't: the list stays true.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::fs;
use std::io;
use std::path::Path;

use crate::scene::{invalid, lines};
use crate::suite::Case;
use crate::verdict::Verdict;

/// What heads the file.
const HEAD: &str = "\
# Scenes that are known not to match POV-Ray's picture, each with the reason: `SCENE: REASON`.
# A listed scene that matches fails the suite, as does one that doesn't match and isn't listed.
# `povista-compat all --update` adds, renews and removes lines; reasons somebody wrote stay.
";

/// Scenes known not to match, and why.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Expectations {
    reasons: BTreeMap<String, String>,
}

impl Expectations {
    /// Reads the list; a missing file is an empty one.
    pub fn read(list: &Path) -> io::Result<Self> {
        match fs::read_to_string(list) {
            Ok(text) => Expectations::parse(&text).map_err(|e| invalid(format!("{}: {e}", list.display()))),
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(Expectations::default()),
            Err(error) => Err(error),
        }
    }

    fn parse(text: &str) -> Result<Self, String> {
        let mut reasons = BTreeMap::new();
        for line in lines(text) {
            let (scene, reason) = line.split_once(':').unwrap_or((line, ""));
            if reason.trim().is_empty() {
                return Err(format!("`{scene}` has no reason: want `SCENE: REASON`"));
            }
            if reasons.insert(scene.trim().to_owned(), reason.trim().to_owned()).is_some() {
                return Err(format!("`{scene}` is listed twice"));
            }
        }
        Ok(Expectations { reasons })
    }

    /// Why a scene is known not to match, if it is.
    pub fn reason(&self, scene: &str) -> Option<&str> {
        self.reasons.get(scene).map(String::as_str)
    }

    /// One sentence for each case that isn't as listed. A crash is never as expected.
    pub fn surprises(&self, cases: &[Case]) -> Vec<String> {
        cases.iter().filter_map(|case| self.surprise(case)).collect()
    }

    fn surprise(&self, case: &Case) -> Option<String> {
        let scene = &case.scene;
        match (case.verdict, self.reason(scene)) {
            (Verdict::Match, Some(reason)) => {
                Some(format!("{scene} matches, but is listed in compat/expectations: {reason}"))
            }
            (Verdict::Match, None) => None,
            (Verdict::Crashed, _) | (_, None) => Some(format!("{scene} {}: {}", case.verdict, finding(case))),
            (_, Some(_)) => None,
        }
    }

    /// Listed scenes that are not among `scenes`, where those are all there are.
    pub fn unknown<'a>(&'a self, scenes: impl Iterator<Item = &'a str>) -> Vec<String> {
        let scenes: BTreeSet<&str> = scenes.collect();
        let unknown = self.reasons.keys().filter(|scene| !scenes.contains(scene.as_str()));
        unknown
            .map(|scene| format!("{scene} is listed in compat/expectations, but there is no such scene"))
            .collect()
    }

    /// The list made true to `cases`: matches leave, failures enter with what was found. Scenes that
    /// were not rendered stay, as do reasons that somebody wrote.
    pub fn updated(&self, cases: &[Case]) -> Self {
        let mut reasons = self.reasons.clone();
        for case in cases {
            let written = reasons.remove(&case.scene).filter(|reason| !is_finding(reason));
            if case.verdict != Verdict::Match {
                let reason = written.unwrap_or_else(|| format!("{}, {}", case.verdict, finding(case)));
                reasons.insert(case.scene.clone(), reason);
            }
        }
        Expectations { reasons }
    }

    /// Writes the list.
    pub fn write(&self, list: &Path) -> io::Result<()> {
        let mut text = HEAD.to_owned();
        for (scene, reason) in &self.reasons {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{scene}: {reason}");
        }
        fs::write(list, text)
    }
}

/// Whether a reason was put together by [`Expectations::updated`].
fn is_finding(reason: &str) -> bool {
    reason.split_once(", ").is_some_and(|(verdict, _)| Verdict::ALL.iter().any(|v| v.to_string() == verdict))
}

/// What was found about a case, on one line.
fn finding(case: &Case) -> String {
    match &case.difference {
        Some(d) if case.message.is_empty() => {
            format!("{:.2} % of pixels near, mean {:.2}, RMSE {:.2}", d.near_percent(), d.mean, d.rmse)
        }
        _ => case.message.clone(),
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    pub(crate) fn case(scene: &str, verdict: Verdict, message: &str) -> Case {
        Case {
            scene: scene.to_owned(),
            verdict,
            message: message.to_owned(),
            difference: None,
            spread: None,
            times: None,
            reference_seconds: 0.0,
            pictures: [None, None, None],
        }
    }

    fn cases() -> [Case; 5] {
        [
            case("good.pov", Verdict::Match, ""),
            case("mended.pov", Verdict::Match, ""),
            case("known.pov", Verdict::Refused, "not supported yet: media"),
            case("broken.pov", Verdict::Refused, "not supported yet: photons"),
            case("dead.pov", Verdict::Crashed, "signal 11"),
        ]
    }

    const LIST: &str =
        "# known\nmended.pov: rounding of spheres\nknown.pov: media: next\n\ndead.pov: deep recursion\n";

    #[test]
    fn only_what_is_not_as_listed_surprises() {
        assert_eq!(
            Expectations::parse(LIST).unwrap().surprises(&cases()),
            [
                "mended.pov matches, but is listed in compat/expectations: rounding of spheres",
                "broken.pov refused: not supported yet: photons",
                "dead.pov crashed: signal 11",
            ]
        );
    }

    #[test]
    fn every_line_has_a_reason_and_a_scene_of_its_own() {
        assert_eq!(Expectations::parse("a.pov").unwrap_err(), "`a.pov` has no reason: want `SCENE: REASON`");
        assert_eq!(Expectations::parse("a.pov: x\na.pov: y").unwrap_err(), "`a.pov` is listed twice");
    }

    #[test]
    fn updating_drops_matches_adds_failures_and_keeps_reasons() {
        let folder = tempfile::tempdir().unwrap();
        let list = folder.path().join("expectations");
        Expectations::parse(LIST).unwrap().updated(&cases()).write(&list).unwrap();
        let text = fs::read_to_string(&list).unwrap();
        assert_eq!(
            text.strip_prefix(HEAD).unwrap(),
            "broken.pov: refused, not supported yet: photons\ndead.pov: deep recursion\nknown.pov: media: next\n"
        );
        let again = Expectations::read(&list).unwrap();
        let found =
            [case("broken.pov", Verdict::Crashed, "signal 6"), case("known.pov", Verdict::Timeout, "")];
        let again = again.updated(&found);
        assert_eq!(again.reason("broken.pov"), Some("crashed, signal 6"));
        assert_eq!(again.reason("known.pov"), Some("media: next"));
    }

    #[test]
    fn a_listed_scene_that_is_gone_is_told() {
        let list = Expectations::parse("gone.pov: media").unwrap();
        assert_eq!(
            list.unknown(["good.pov"].into_iter()),
            ["gone.pov is listed in compat/expectations, but there is no such scene"]
        );
    }
}
