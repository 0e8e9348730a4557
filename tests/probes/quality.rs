//! What quality levels leave out (docs/spec/shading.md 20).

use povista::options::RenderOptions;

use crate::table::assert_pixel;

fn assert_levels(sdl: &str, rows: &[(u8, [f32; 3])]) {
    for &(quality, observed) in rows {
        let options = RenderOptions { quality, ..RenderOptions::new(1, 1) };
        assert_pixel(sdl, "3.7", &options, &observed, 6e-5);
    }
}

#[test]
fn low_quality_shows_plain_and_quick_colours() {
    let layered = "background{rgb <0,0,.3>} light_source{<5,0,0> rgb 1} \
        box{<2.5,-1,2.4>,<2.6,1,2.6> pigment{rgb 1}} \
        plane{z,5 texture{pigment{rgb <.9,.5,.2>} finish{ambient .1 diffuse .6 reflection .2}} \
        texture{pigment{rgbt <.2,.5,.9,.5> quick_color rgb <0,1,0>} finish{ambient .1 diffuse .6}}}";
    let rows = [
        (0, [0.0, 1.0, 0.0]),
        (1, [0.0, 1.0, 0.0]),
        (2, [0.0, 0.5243, 0.0]),
        (4, [0.0, 0.1, 0.0]),
        (5, [0.0, 0.1, 0.0]),
        (6, [0.055, 0.05, 0.055]),
        (7, [0.055, 0.05, 0.055]),
        (8, [0.055, 0.05, 0.115]),
        (9, [0.055, 0.05, 0.115]),
        (11, [0.055, 0.05, 0.115]),
    ];
    assert_levels(layered, &rows);
}

#[test]
fn transparency_begins_at_six() {
    let clear = "background{rgb <0,0,.3>} light_source{0 rgb 1} \
        plane{z,5 pigment{rgbt <1,.5,.2,.5>} finish{ambient .1 diffuse .6}}";
    let rows = [
        (1, [1.0, 0.5, 0.2]),
        (2, [0.35, 0.175, 0.07]),
        (5, [0.35, 0.175, 0.07]),
        (6, [0.35, 0.175, 0.22]),
        (9, [0.35, 0.175, 0.22]),
    ];
    assert_levels(clear, &rows);
}

#[test]
fn area_lights_are_points_below_five() {
    let area = "AT(3,2) light_source{<1,2,-10> rgb 1 area_light 4*x,4*y,5,5} FLOOR \
        box{<-3,-3,-3>,<2.1,2.6,-2.9> pigment{rgb 1}}";
    let rows = [(0, [1.0; 3]), (3, [0.9912; 3]), (4, [0.0; 3]), (5, [0.4491; 3]), (9, [0.4491; 3])];
    assert_levels(area, &rows);
}

#[test]
fn bumps_begin_at_eight() {
    let bumpy = "AT(.7,0) light_source{0 rgb 1} \
        plane{z,5 pigment{rgb 1} normal{gradient x 2 scale 3} finish{ambient 0 diffuse 1}}";
    assert_levels(bumpy, &[(1, [1.0; 3]), (2, [0.9903; 3]), (7, [0.9903; 3]), (8, [0.9926; 3])]);
}

#[test]
fn the_lowest_layer_shows_at_quality_one() {
    let layers = "plane{z,5 texture{pigment{rgb <.9,.5,.2>}} texture{pigment{rgbt <.2,.5,.9,.5>}}}";
    assert_levels(layers, &[(0, [0.9, 0.5, 0.2]), (1, [0.9, 0.5, 0.2]), (2, [0.055, 0.05, 0.055])]);
}
