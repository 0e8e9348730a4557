//! What `povista check` says about scenes that are read without an error.

use super::{Answer, Desk, SCENE};
use serde_json::Value;

/// A scene with an unused name, and one with an old spelling.
fn desk() -> Desk {
    let desk = Desk::new();
    desk.write("idle.pov", &format!("{SCENE}#declare Idle = 1;\n"));
    desk.write("old.pov", &format!("{SCENE}sphere {{ 9, 1 finish {{ ior 1.5 }} }}\n"));
    desk
}

fn text(answer: &Answer) -> String {
    String::from_utf8(answer.out.clone()).unwrap()
}

#[test]
fn findings_are_warnings_with_a_code_unless_said_otherwise() {
    let desk = desk();
    let answer = desk.povista("check idle.pov --format plain");
    assert_eq!(answer.code, Some(0));
    let told = text(&answer);
    assert!(told.contains("`Idle` is never used") && told.contains("code: povista::lint::unused"), "{told}");

    let rows = [
        ("--deny unused", Some(1), true),
        ("--deny all", Some(1), true),
        ("--deny all --allow unused", Some(0), false),
        ("--allow povista::lint::unused", Some(0), false),
        ("--allow all --warn unused", Some(0), true),
        ("--deny deprecated", Some(0), true),
    ];
    for (words, code, tells) in rows {
        let answer = desk.povista(&format!("check idle.pov --format plain {words}"));
        assert_eq!((answer.code, text(&answer).contains("Idle")), (code, tells), "{words}");
    }
    let answer = desk.povista("check idle.pov --deny nonsense");
    assert_eq!(answer.code, Some(1));
    assert!(answer.err.contains("missing_max_gradient"), "{}", answer.err);
}

#[test]
fn what_the_interpreter_warns_of_has_a_code_too() {
    let desk = Desk::new();
    desk.write("a.pov", "camera { } sphere { 0, 1 } light_source { 9, 1 } #declare A = 1; union { sphere { A, 1 } sphere { 1, 1 } }");
    let told = text(&desk.povista("check a.pov --format json"));
    let codes: Vec<Value> =
        told.lines().map(|line| serde_json::from_str::<Value>(line).unwrap()["code"].clone()).collect();
    assert!(codes.contains(&Value::from("povista::lint::missing_version")), "{told}");
    assert_eq!(desk.povista("check a.pov --deny missing-version").code, Some(1));
}

#[test]
fn files_of_others_are_not_judged_but_the_users_are() {
    let desk = desk();
    desk.write("own/a.pov", &format!("{SCENE}#include \"parts.inc\"\n#include \"others.inc\"\n"));
    desk.write("own/parts.inc", "#macro Never(Idle) 1 #end\n");
    desk.write("library/others.inc", "#macro Never2(Idle2) 1 #end\n");
    let told = text(&desk.povista("check own/a.pov -L own -L library --format plain"));
    assert!(told.contains("the parameter `Idle` is never used"), "{told}");
    assert!(!told.contains("Idle2"), "{told}");
}

#[test]
fn a_sarif_log_holds_all_that_is_told() {
    let desk = desk();
    let answer = desk.povista("check old.pov --format sarif");
    assert_eq!(answer.code, Some(0));
    let log: Value = serde_json::from_slice(&answer.out).unwrap();
    assert_eq!(log["version"], "2.1.0");
    let results = log["runs"][0]["results"].as_array().unwrap();
    let found = results.iter().find(|result| result["ruleId"] == "povista::lint::deprecated").unwrap();
    assert_eq!(found["level"], "warning");
    let place = &found["locations"][0]["physicalLocation"];
    assert_eq!(
        (&place["region"]["startLine"], &place["artifactLocation"]["uri"]),
        (&6.into(), &"old.pov".into())
    );
    // A scene with errors has a log as well.
    desk.write("bad.pov", "#version 3.7;\nsphere { 0, Radius }\n");
    let answer = desk.povista("check bad.pov --format sarif");
    assert_eq!(answer.code, Some(1));
    let log: Value = serde_json::from_slice(&answer.out).unwrap();
    assert_eq!(log["runs"][0]["results"][0]["level"], "error");
}
