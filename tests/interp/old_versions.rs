use super::probe;

/// docs/spec/language.md 6.8: before version 3.0 the words of pigment, normal and finish stand in the
/// texture itself.
#[test]
fn free_form_textures() {
    let texture = |version: &str, body: &str| {
        format!("#version {version}; sphere {{ <0 0 0> 1 texture {{ {body} }} }}")
    };
    let map = "color_map { [0 1 color red 1 color blue 1] }";
    let accepted = [
        "color red 1 ambient 0.3 diffuse 0.7".to_owned(),
        "color red 1.0 green 0.5 phong 1.0 phong_size 10".to_owned(),
        format!("bozo {map} turbulence 0.5 ambient 0.3 bumps 0.3 scale <1 1 1>"),
        "pigment { color red 1 } ambient 0.3".to_owned(),
        "color red 1 finish { ambient 0.3 }".to_owned(),
        "ambient 0.3 color red 1".to_owned(),
        "bumps 0.5 scale 2 wood turbulence 0.3 scale 3 specular 1 roughness 0.01 metallic".to_owned(),
        "checker color red 1 color blue 1 phong 1".to_owned(),
        "tiles { texture { color red 1 } tile2 texture { color blue 1 } }".to_owned(),
        "color red 1 normal { bumps 0.3 } ripples 0.5 frequency 10 phase 0.3".to_owned(),
        "color red 1 mandel 10".to_owned(),
    ];
    let refused = [
        "checker texture { color red 1 } texture { color blue 1 }",
        "color red 1 ; ambient 0.3",
        "color red 1 colour_of_the_sky",
    ];
    let mut rows = Vec::new();
    rows.extend(accepted.iter().map(|body| (texture("2.0", body), "")));
    rows.push((texture("2.0", "0.05 color red 1"), "W"));
    rows.extend(refused.iter().map(|body| (texture("2.0", body), "E")));
    rows.extend(["3.0", "3.7"].map(|version| (texture(version, "color red 1 ambient 0.3"), "E")));
    let declared = "#version 2.0; #declare C = color red 1 #declare T = texture { C ambient 0.3 } \
                    sphere { <0 0 0> 1 texture { T phong 1 color blue 1 } }";
    rows.push((declared.to_owned(), ""));
    let rows: Vec<(&str, &str)> = rows.iter().map(|(scene, wanted)| (&**scene, *wanted)).collect();
    probe(&rows);
}

#[test]
fn what_a_version_asks_for() {
    probe(&[
        ("#version 3.0 #debug \"a\\n\"", "a"),
        ("#version 3.1 #debug \"a\\n\"", "a P"),
        ("#version 3.0; #macro M() #end", "E"),
        ("#version 3.0; #declare A=3 #debug \"a\\n\"", "a"),
        ("#version 3.1; #declare A=3 #debug \"a\\n\"", "a P"),
        ("#version 3.5; #declare A=3", "E"),
    ]);
}
