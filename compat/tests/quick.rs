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
use povista_compat::suite::Suite;

/// Processor seconds for one scene of the quick set; the slowest takes POV-Ray a tenth of it.
const LIMIT: Duration = Duration::from_secs(60);

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
    let surprises = expectations.surprises(&cases);
    assert!(
        surprises.is_empty(),
        "{} of {} scenes are not as expected, see {}:\n{}",
        surprises.len(),
        cases.len(),
        folder.join("report.html").display(),
        surprises.join("\n")
    );
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
