//! The quick set against Debian's povray: every scene must come out as `compat/expectations` says.
//!
//! A missing povray, povray-examples or povista fails the test; nothing is skipped.

use std::path::Path;
use std::thread;
use std::time::Duration;

use povista_compat::cache::Cache;
use povista_compat::expectations::Expectations;
use povista_compat::program::Program;
use povista_compat::report::{self, Report};
use povista_compat::scene::Places;
use povista_compat::suite::{Case, Suite};

/// Processor seconds for one scene of the quick set; the slowest takes POV-Ray a tenth of it.
const LIMIT: Duration = Duration::from_secs(60);

/// Chapters whose scenes leave POV-Ray no room: nothing in them is random, thin or noisy.
const EXACT: [&str; 5] = ["ray_tree", "csg", "transform", "finish", "camera"];

/// Share of near pixels asked of those.
const EXACT_SHARE: f64 = 0.999;

#[test]
fn quick_set_is_as_expected() {
    let places = Places::here();
    let povray = Program::povray().unwrap_or_else(|error| panic!("{error}"));
    let povista = Program::povista().unwrap_or_else(|error| panic!("{error}"));
    let cores = thread::available_parallelism().map_or(1, usize::from);
    let suite = Suite {
        povray: povray.clone(),
        povista: Some(povista.clone()),
        cache: Cache::here(&places).unwrap(),
        jobs: cores + cores.div_ceil(2),
        limit: LIMIT,
    };
    let scenes = places.quick().unwrap_or_else(|error| panic!("{error}"));
    let cases = suite.compare(&scenes, |_| ()).unwrap();
    let expectations = Expectations::read(&places.list("expectations")).unwrap();
    let report = Report { povray: &povray.version, povista: &povista.version, cases: &cases };
    let folder = places.list("report");
    report.write(&folder, |scene| expectations.reason(scene).map(str::to_owned)).unwrap();
    println!("{}", report::cases(&report));
    let mut surprises = expectations.surprises(&cases);
    surprises.extend(inexact(&cases, &expectations));
    assert!(
        surprises.is_empty(),
        "{} of {} scenes are not as expected, see {}:\n{}",
        surprises.len(),
        cases.len(),
        folder.join("report.html").display(),
        surprises.join("\n")
    );
}

/// One sentence for each scene of the exact chapters that is less near than they ask.
fn inexact(cases: &[Case], expectations: &Expectations) -> Vec<String> {
    let exact = |case: &&Case| {
        let chapter = case.scene.strip_prefix("tests/render/").and_then(|below| below.split('/').next());
        chapter.is_some_and(|chapter| EXACT.contains(&chapter)) && expectations.reason(&case.scene).is_none()
    };
    let cases = cases.iter().filter(exact);
    let short = cases.filter_map(|case| Some((case, case.difference?))).filter(|(_, d)| d.near < EXACT_SHARE);
    short.map(|(case, d)| format!("{}: only {:.2} % of pixels near", case.scene, d.near_percent())).collect()
}

#[test]
fn every_list_names_scenes_that_exist() {
    let places = Places::here();
    let all = places.all().unwrap_or_else(|error| panic!("{error}"));
    let names = || all.iter().map(|scene| scene.name.as_str());
    let expectations = Expectations::read(&places.list("expectations")).unwrap();
    assert_eq!(expectations.unknown(names()), Vec::<String>::new());
    for scene in places.regressed().unwrap() {
        assert!(names().any(|name| name == scene), "compat/regressions.txt: there is no {scene}");
    }
    assert!(names().all(|name| !Path::new(name).is_absolute()));
}
