use super::*;
use crate::diag::{Code, Collect};
use crate::interp::interpret;
use crate::options::LanguageOptions;
use crate::source::{Library, Source};

const START: &str = "#version 3.7; global_settings { assumed_gamma 1 }\n";

/// What is said about the text of a scene: code and message of each finding.
fn findings(scene: &str) -> Vec<(Code, String)> {
    let (main, sources, _) = read(scene);
    text(main, &sources, |_| true).into_iter().map(|found| (found.code, found.message)).collect()
}

fn codes(scene: &str) -> Vec<Code> {
    findings(scene).into_iter().map(|(code, _)| code).collect()
}

/// What is said about where things are.
fn places(scene: &str) -> Vec<Code> {
    geometry(read(scene).2).into_iter().map(|found| found.code).collect()
}

fn read(scene: &str) -> (FileId, Sources, crate::scene::Scene) {
    let mut sources = Sources::new(Library::default());
    let main = sources.add(Source::new("a.pov", "", format!("{START}{scene}").into()));
    let mut sink = Collect::default();
    let read = interpret(main, &mut sources, &LanguageOptions::default(), &mut sink);
    (main, sources, read.unwrap_or_else(|| panic!("{:?}", sink.diagnostics)))
}

#[test]
fn names_that_nothing_uses_are_told_once() {
    let found = findings("#declare A = 1; #declare A = 2; #declare B = 3; sphere { 0, B }");
    assert_eq!(found, [(Code::Unused, "`A` is never used".to_owned())]);
    let found = findings("#macro Never(X) X #end #declare _Meant = 1;");
    assert_eq!(found, [(Code::Unused, "the macro `Never` is never used".to_owned())]);
    assert!(codes("#ifndef (A) #declare A = 1; #end").is_empty());
    assert!(codes("#declare A = 1; #debug \"A + 1\"").is_empty());
}

#[test]
fn a_parameter_is_used_by_its_macro_or_by_one_that_is_called() {
    let found = findings("#macro M(Used, Idle) #local R = Used; R #end sphere { 0, M(1, 2) }");
    assert_eq!(found, [(Code::Unused, "the parameter `Idle` is never used".to_owned())]);
    assert!(codes("#macro F() Seen #end #macro M(Seen) F() #end sphere { 0, M(1) }").is_empty());
}

#[test]
fn a_local_name_that_hides_one_of_the_scene_is_told() {
    let scene = "#declare Radius = 1; #macro M(I) #local Radius = I; Radius #end sphere { 0, M(Radius) }";
    assert_eq!(codes(scene), [Code::Shadowed]);
    let counters = "#declare I = 1; #macro M(I) I #end sphere { 0, M(I) }";
    assert!(codes(counters).is_empty());
}

#[test]
fn a_name_like_a_reserved_word_is_told() {
    let found = findings("#declare lookat = 1; sphere { 0, lookat }");
    let message = "`lookat` is easily taken for the reserved word `look_at`".to_owned();
    assert_eq!(found, [(Code::ReservedLooking, message)]);
    assert!(codes("#declare Lookat = 1; #declare n = 1; sphere { n, Lookat }").is_empty());
}

#[test]
fn a_default_that_is_replaced_at_once_is_told() {
    let scene = "#default { pigment { rgb 1 } } #default { texture { pigment { rgb x } } } sphere { 0, 1 }";
    assert_eq!(codes(scene), [Code::OverwrittenDefault]);
    let used =
        "#default { pigment { rgb 1 } } sphere { 0, 1 } #default { pigment { rgb x } } sphere { 3, 1 }";
    assert!(codes(used).is_empty());
    assert!(codes("#default { pigment { rgb 1 } finish { phong 1 } } sphere { 0, 1 }").is_empty());
}

#[test]
fn an_old_spelling_is_told() {
    let scene = "blob { threshold 0.5 component 1, 1, 0 sphere { 0, 1, 1 } }";
    assert_eq!(findings(scene), [(Code::Deprecated, "`component` is an old spelling".to_owned())]);
}

#[test]
fn an_isosurface_without_a_gradient_is_told() {
    let scene = "isosurface { function { x } contained_by { box { -1, 1 } }";
    assert_eq!(codes(&format!("{scene} }}")), [Code::MissingMaxGradient]);
    assert!(codes(&format!("{scene} max_gradient 2 }}")).is_empty());
    assert!(codes(&format!("{scene} evaluate 1, 1.2, 0.9 }}")).is_empty());
}

#[test]
fn a_camera_in_the_dark_is_told_but_not_one_in_a_room() {
    let sphere = "sphere { 0, 2 pigment { rgb 1 } }";
    assert_eq!(places(&format!("{sphere} light_source {{ 9, 1 }}")), [Code::CameraInside]);
    assert!(places(&format!("{sphere} light_source {{ <0, 1, 0>, 1 }}")).is_empty());
    assert!(places("sphere { 0, 2 pigment { rgbt 1 } } light_source { 9, 1 }").is_empty());
    assert!(places("sphere { 0, 2 hollow } light_source { 9, 1 }").is_empty());
    let wall = "difference { box { -2, 2 } box { <1, -1, -1>, <1.5, 1, 1> } pigment { rgb 1 } }";
    assert_eq!(places(&format!("{wall} light_source {{ 9, 1 }}")), [Code::CameraInside]);
}

#[test]
fn a_light_that_is_shut_in_is_told() {
    let scene =
        |object: &str| format!("camera {{ location -9 }} light_source {{ 0, 1 translate y }} {object}");
    assert_eq!(places(&scene("sphere { y, 0.5 }")), [Code::LightInside]);
    assert!(places(&scene("sphere { y, 0.5 no_shadow }")).is_empty());
    assert!(places(&scene("sphere { -3*y, 0.5 }")).is_empty());
    assert!(
        places("light_source { 0, 1 looks_like { sphere { 0, 0.5 } } } camera { location -9 }").is_empty()
    );
}

#[test]
fn a_comment_allows_a_finding_in_its_line_or_the_next() {
    assert!(codes("#declare A = 1; // povista: allow(unused)").is_empty());
    assert!(codes("// povista: allow(shadowed, unused)\n#declare A = 1;").is_empty());
    assert_eq!(codes("// povista: allow(shadowed)\n#declare A = 1;"), [Code::Unused]);
}

#[test]
fn files_of_others_are_read_but_not_judged() {
    let mut sources = Sources::new(Library::default());
    let main = sources.add(Source::new("a.pov", "", "#declare Option = 1; #declare Idle = 2;".into()));
    sources.add(Source::new("b.inc", "", "#macro M(A) Option #end #local B = 1;".into()));
    let found = text(main, &sources, |_| false);
    let messages: Vec<&str> = found.iter().map(|diagnostic| &*diagnostic.message).collect();
    assert_eq!(messages, ["`Idle` is never used"]);
    assert_eq!(text(main, &sources, |_| true).len(), 3);
}
