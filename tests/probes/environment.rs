//! Sky, fog and rainbow (docs/spec/atmosphere-gi.md 1.9, docs/spec/shading.md 20).

use povista::options::RenderOptions;

use crate::table::assert_pixel;

const ORTHO: &str = "camera{orthographic location <0,0,-10> direction z right 1e-6*x up 1e-6*y}";
const BLUE: &str = "plane{-z,0 pigment{rgb <.2,.4,.8>} finish{ambient 0 emission 1 diffuse 0}}";
const BACK: &str = "background{rgb <.2,.4,.6>}";
const ARC: &str = "rainbow{direction z angle 30 width 10 distance 1e6";
const RED_TO_BLUE: &str = "color_map{[0 rgb <1,0,0>][1 rgb <0,0,1>]}";

fn assert_color(sdl: &str, version: &str, observed: [f32; 3]) {
    assert_pixel(sdl, version, &RenderOptions::new(1, 1), &observed, 1.01e-4);
}

/// With alpha output; the table has straight colours, the picture premultiplied ones.
fn assert_alpha(sdl: &str, version: &str, [r, g, b, alpha]: [f32; 4]) {
    let options = RenderOptions { output_alpha: true, ..RenderOptions::new(1, 1) };
    let observed = [r * alpha, g * alpha, b * alpha, alpha];
    assert_pixel(sdl, version, &options, &observed, 1.5e-4);
}

/// A ray `theta` degrees off z, turned `azimuth` degrees from up.
fn towards(theta: f64, azimuth: f64) -> String {
    format!(
        "camera{{location 0 direction vrotate(vrotate(z,-{theta}*x),{azimuth}*z) right <1e-6,0,0> up <0,1e-6,0>}}"
    )
}

fn looking(direction: &str) -> String {
    format!("camera{{location 0 direction vnormalize({direction}) right <1e-6,0,0> up <0,1e-6,0>}}")
}

#[test]
fn fog_ends_at_what_it_hides() {
    let rows = [
        ("fog{distance 10 rgb <1,.5,0>}", [0.7057, 0.4632, 0.2943]),
        ("fog{distance 10 rgbt <1,.5,0,.6>}", [0.52, 0.44, 0.48]),
        ("fog{distance 10 rgbf <1,.5,0,.5>}", [0.7057, 0.4264, 0.1472]),
        ("fog{distance 10 rgb <1,.5,0>} fog{distance 20 rgb <0,0,1>}", [0.6768, 0.4053, 0.5720]),
        ("fog{distance 10 rgb <1,.5,0> turbulence .5}", [0.6473, 0.4559, 0.3527]),
        (
            "fog{distance 10 rgb <1,.5,0> turbulence <1,2,3> turb_depth 1 octaves 3 lambda 3 omega .7}",
            [0.5816, 0.4477, 0.4184],
        ),
        ("fog{distance 10 rgb <1,.5,0> fog_type 2 fog_offset 1}", [0.7057, 0.4632, 0.2943]),
        ("fog{distance 10 rgb <1,.5,0> fog_type 2 fog_offset -1}", [0.2, 0.4, 0.8]),
    ];
    for (fog, observed) in rows {
        assert_color(&format!("{ORTHO} {BLUE} {fog}"), "3.7", observed);
    }
    let inside = format!("{ORTHO} {} fog{{distance 10 rgb <1,.5,0>}}", BLUE.replace("-z", "z"));
    assert_color(&inside, "3.7", [0.2, 0.4, 0.8]);
    assert_color(&format!("{ORTHO} {BACK} fog{{distance 10 rgb <1,.5,0>}}"), "3.7", [1.0, 0.5, 0.0]);
    let thin = format!("{ORTHO} {BACK} fog{{distance 10 rgbt <1,.5,0,.25>}}");
    assert_color(&thin, "3.7", [0.8, 0.475, 0.15]);
}

#[test]
fn ground_fog_lies_low() {
    let scene = "camera{location <0,5,0> direction z right x up y*.75 look_at <0,0,5>} \
        plane{y,-1 hollow pigment{rgb .2} finish{ambient 0 emission 1 diffuse 0}} \
        fog{fog_type 2 distance 10 fog_offset 1 fog_alt 2 rgb 1}";
    assert_color(scene, "3.7", [0.5592; 3]);
}

#[test]
fn fog_acts_on_every_ray_that_is_traced() {
    let mirror =
        "fog{distance 10 rgb <1,.5,0>} plane{-z,0 pigment{rgb 0} finish{ambient 0 diffuse 0 reflection 1}}";
    let at_level = |level| format!("global_settings{{max_trace_level {level}}} {ORTHO} {mirror}");
    assert_color(&at_level(1), "3.7", [0.6321, 0.3161, 0.0]);
    assert_color(&at_level(2), "3.7", [1.0, 0.5, 0.0]);
}

#[test]
fn fog_dims_the_lights_that_ask_for_it() {
    let ground = "camera{location <0,1,0> direction -y right 1e-6*x up 1e-6*z} \
        plane{y,0 pigment{rgb 1} finish{ambient 0 diffuse 1}} fog{distance 10 rgb 0}";
    let lamp = |more: &str| format!("{ground} light_source{{<0,8,0> rgb <1,.5,.25> {more}}}");
    assert_color(&lamp(""), "3.7", [0.9048, 0.4524, 0.2262]);
    assert_color(&lamp("media_attenuation on"), "3.7", [0.4066, 0.2033, 0.1016]);
    assert_color(&lamp("media_attenuation on media_interaction off"), "3.7", [0.9048, 0.4524, 0.2262]);
    let within = |hollow: &str| {
        let lamp = lamp("media_attenuation on");
        format!("{lamp} box{{<-5,2,-5>,<5,6,5> pigment{{rgbt 1}} {hollow}}}")
    };
    assert_color(&within(""), "3.7", [0.6065, 0.3033, 0.1516]);
    assert_color(&within("hollow"), "3.7", [0.4066, 0.2033, 0.1016]);
}

#[test]
fn skies_are_seen_by_direction() {
    let sky = "sky_sphere{pigment{gradient y color_map{[0 rgb <1,0,0>][1 rgb <0,0,1>]}}}";
    let rows = [
        ("<0,.5,1>", [0.5528, 0.0, 0.4472]),
        ("<0,-.25,1>", [0.2425, 0.0, 0.7575]),
        ("<1,1,1>", [0.4226, 0.0, 0.5774]),
    ];
    for (direction, observed) in rows {
        assert_color(&format!("{} {sky}", looking(direction)), "3.7", observed);
    }
    let moved = sky.replace("}}}", "}} translate -.3*y}");
    assert_color(&format!("{} {moved}", looking("<0,.5,1>")), "3.7", [0.2528, 0.0, 0.7472]);
}

#[test]
fn sky_pigments_compose_by_version() {
    let layers = "background{rgb <.8,.6,.4>} sky_sphere{RED pigment{rgbft <.2,.4,.6,.3,.2>} \
        pigment{rgbft <.5,.5,1,.1,.6>} EMISSION}";
    let red = layers.replace("RED", "pigment{rgb <1,0,0>}").replace("EMISSION", "");
    assert_color(&red, "3.7", [0.384, 0.28, 0.51]);
    assert_color(&red, "3.6", [0.37, 0.29, 0.51]);
    let bright = layers.replace("RED", "").replace("EMISSION", "emission <.5,1,1>");
    assert_color(&bright, "3.7", [0.2427, 0.4048, 0.6164]);
    assert_color(&bright, "3.6", [0.2084, 0.3656, 0.5652]);
    assert_alpha(&bright, "3.7", [0.2427, 0.4048, 0.6164, 1.0]);
    assert_alpha(&bright, "3.6", [0.0; 4]);
}

#[test]
fn backgrounds_are_transparent_only_with_alpha_output() {
    let written = "background{rgbft <.8,.6,.4,.5,.5>}";
    assert_color(written, "3.7", [0.4, 0.3, 0.2]);
    assert_color(written, "3.6", [0.8, 0.6, 0.4]);
    let half = "background{rgbt <.2,.4,.6,.5>}";
    assert_alpha(half, "3.7", [0.2, 0.4, 0.6, 0.5]);
    assert_alpha(BACK, "3.7", [0.2, 0.4, 0.6, 1.0]);
    assert_alpha("", "3.7", [0.0; 4]);
    assert_alpha("background{rgbf <.2,.4,.6,.5>}", "3.7", [0.1222, 0.2444, 0.3666, 0.8183]);
    let mirror = "plane{-z,0 pigment{rgb 0} finish{ambient 0 diffuse 0 reflection .5}}";
    assert_alpha(&format!("camera{{location -z}} {half} {mirror}"), "3.7", [0.1, 0.2, 0.3, 1.0]);
    let foggy = format!("{half} fog{{distance 10 rgbt <1,.5,0,.25>}}");
    assert_alpha(&foggy, "3.7", [0.8857, 0.4857, 0.0857, 0.8750]);
}

#[test]
fn a_rainbow_lies_at_its_angle() {
    let rows = [
        (24.9, [0.2, 0.4, 0.6]),
        (25.1, [0.99, 0.0, 0.01]),
        (27.5, [0.75, 0.0, 0.25]),
        (30.0, [0.5, 0.0, 0.5]),
        (35.1, [0.2, 0.4, 0.6]),
    ];
    for (theta, observed) in rows {
        assert_color(&format!("{} {BACK} {ARC} {RED_TO_BLUE}}}", towards(theta, 0.0)), "3.7", observed);
    }
    let clear = "color_map{[0 rgbt <1,0,0,.25>][1 rgbt <0,0,1,.75>]}";
    assert_color(&format!("{} {BACK} {ARC} {clear}}}", towards(30.0, 0.0)), "3.7", [0.35, 0.2, 0.55]);
    let tinted = "color_map{[0 rgbft <1,0,0,.5,.25>][1 rgbft <1,0,0,.5,.25>]}";
    assert_color(&format!("{} {BACK} {ARC} {tinted}}}", towards(30.0, 0.0)), "3.7", [0.8, 0.0625, 0.0938]);
}

#[test]
fn a_rainbow_fades_towards_the_ends_of_its_arc() {
    let rows = [
        (45.0, [0.5, 0.0, 0.5]),
        (50.0, [0.4778, 0.0296, 0.5074]),
        (60.0, [0.35, 0.2, 0.55]),
        (74.0, [0.2010, 0.3987, 0.5997]),
        (76.0, [0.2, 0.4, 0.6]),
    ];
    for (azimuth, observed) in rows {
        let arc = format!("{ARC} arc_angle 150 falloff_angle 90 {RED_TO_BLUE}}}");
        assert_color(&format!("{} {BACK} {arc}", towards(30.0, azimuth)), "3.7", observed);
    }
    let endless = format!("{ARC} falloff_angle 90 {RED_TO_BLUE}}}");
    assert_color(&format!("{} {BACK} {endless}", towards(30.0, 170.0)), "3.7", [0.4999, 0.0002, 0.5]);
}
