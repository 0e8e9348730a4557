//! The tables of docs/spec/shading.md, straight from the file.

use crate::table::{Row, assert_rows, rows};

/// Rows that show an artefact POV-Ray's users never asked for, with what povista gives instead.
const BETTER: [(&str, &str); 6] = [
    ("plane{z,0.00009 ", "surfaces nearer than 1e-4 are seen"),
    ("plane{z,1.1e7 ", "surfaces farther than 1e7 are seen"),
    ("disc{z*4.99905,z,1 ", "blockers nearer than 1e-3 to the surface cast shadows"),
    ("disc{z*-9.99905,z,1 ", "blockers nearer than 1e-3 to the light cast shadows"),
    ("area_light 14*x,14*y,2,2 jitter", "random numbers belong to the pixel, not to the thread"),
    ("crand .4", "random numbers belong to the pixel, not to the thread"),
];

fn section(number: &str) -> Vec<Row> {
    let mut rows = rows("docs/spec/shading.md", number);
    rows.retain(|row| !BETTER.iter().any(|(part, _)| row.sdl.contains(part)));
    rows
}

macro_rules! chapters {
    ($($name:ident: $number:literal, $least:literal;)*) => {
        $(
            #[test]
            fn $name() {
                let rows = section($number);
                assert!(rows.len() >= $least, "the table of section {} has only {} rows", $number, rows.len());
                assert_rows(&rows);
            }
        )*
    };
}

chapters! {
    rays_see_what_their_kind_may_see: "3", 6;
    the_ray_tree_ends_at_its_level_and_weight: "4", 10;
    hits_are_accepted_at_any_distance: "5", 4;
    textures_are_chosen_and_blended: "6", 6;
    layers_filter_what_is_behind: "7", 15;
    finishes_answer_light: "9", 20;
    interiors_refract: "10", 5;
    interiors_nest: "11", 8;
    interiors_dim_light: "12", 8;
    dispersion_splits_light: "13", 4;
    mirrors_reflect: "14", 12;
    shadows_take_colour: "15", 14;
    lights_have_shapes: "16", 29;
    area_lights_soften_shadows: "17", 30;
    light_groups_keep_to_themselves: "18", 12;
    skies_and_fogs_compose: "19", 12;
}
