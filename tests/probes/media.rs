//! Media (docs/spec/atmosphere-gi.md 2.13).

use povista::options::RenderOptions;

use crate::table::{assert_pixel, picture, scene};

const ORTHO: &str = "camera{orthographic location <0,0,-10> direction z right 1e-6*x up 1e-6*y}";
const BACK: &str = "background{rgb <.2,.4,.6>}";
const SUN: &str = "light_source{<0,100,2> rgb 1 parallel point_at <0,0,2>}";
const FAR: &str = "light_source{<0,100,0> rgb 1}";
const TOLERANCE: f32 = 1.01e-4;

/// The abbreviations of the tables.
fn expand(media: &str) -> String {
    let ramp = "density{gradient z color_map{[0 rgb 0][1 rgb 1]} scale 4}";
    let step = "density{gradient z color_map{[.4 rgb 0][.4 rgb 1]} scale 4}";
    // Displaced before its beginning, a sample falls into the period before.
    let long = "density{gradient z color_map{[0 rgb 0][1 rgb 1]} scale 40}";
    let words = media.split_inclusive(' ').map(|word| match word.trim() {
        "E" => "emission <.1,.05,.02> ",
        "A" => "absorption <.3,.2,.1> ",
        "RAMP" => ramp,
        "STEP" => step,
        "LONG" => long,
        _ => word,
    });
    words.collect()
}

/// A box from z = 0 to 4 filled with some media.
fn container(media: &str) -> String {
    format!("box{{<-5,-1,0>,<5,1,4> hollow pigment{{rgbt 1}} interior{{{media}}}}}")
}

fn filled(media: &str) -> String {
    container(&format!("media{{{}}}", expand(media)))
}

fn assert_seen(sdl: &str, observed: [f32; 3]) {
    assert_pixel(sdl, "3.7", &RenderOptions::new(1, 1), &observed, TOLERANCE);
}

fn assert_filled(media: &str, more: &str, observed: [f32; 3]) {
    assert_seen(&format!("{ORTHO} {BACK} {} {more}", filled(media)), observed);
}

#[test]
fn plain_media_glow_and_absorb() {
    assert_filled("absorption <.1,.2,.05>", "", [0.1341, 0.1797, 0.4912]);
    let rows = [
        ("E A ", [0.3173, 0.3268, 0.4703]),
        ("samples 100 E A ", [0.2959, 0.3185, 0.4684]),
        ("samples 1 E A ", [0.3700, 0.3468, 0.4749]),
        ("samples 3 E A ", [0.3700, 0.3468, 0.4749]),
        ("intervals 5 samples 1 E A ", [0.3700, 0.3468, 0.4749]),
        ("method 2 E A ", [0.2930, 0.3174, 0.4681]),
        ("method 2 samples 1 E A ", [0.2798, 0.3138, 0.4677]),
    ];
    for (media, observed) in rows {
        assert_filled(media, "", observed);
    }
    assert_filled("intervals 5 samples 1 E A ", FAR, [0.3074, 0.3230, 0.4695]);
    assert_filled("method 2 samples 2 intervals 4 E A ", FAR, [0.2930, 0.3173, 0.4681]);
}

#[test]
fn densities_are_sampled_as_the_methods_say() {
    let rows = [
        ("E RAMP ", [0.3714, 0.4857, 0.6343]),
        ("E aa_threshold 100 RAMP ", [0.3714, 0.4857, 0.6343]),
        ("samples 1000 E RAMP ", [0.3996, 0.4998, 0.6399]),
        ("method 2 samples 4 absorption .4 emission .1 RAMP ", [0.1912, 0.2810, 0.3709]),
        ("samples 20 absorption .4 emission .1 RAMP ", [0.2314, 0.3275, 0.4235]),
        ("A RAMP ", [0.1196, 0.2839, 0.5055]),
    ];
    for (media, observed) in rows {
        assert_filled(media, "", observed);
    }
    for (level, red) in [(1, 0.4222), (2, 0.4111), (3, 0.4111), (4, 0.4139), (5, 0.4139), (6, 0.4132)] {
        let media = format!("aa_level {level} emission <.1,0,0> STEP ");
        assert_filled(&media, "", [red, 0.4, 0.6]);
    }
}

#[test]
fn several_media_add_and_several_densities_multiply() {
    let two = container(&expand("media{ E RAMP } media{method 2 samples 1 intervals 2 absorption .1}"));
    assert_seen(&format!("{ORTHO} {BACK} {two}"), [0.2978, 0.3500, 0.4349]);
    assert_seen(&format!("{ORTHO} {BACK} {two} {SUN}"), [0.2904, 0.3463, 0.4335]);
    let media = "absorption .1 density{rgb <2,1,.5>} density{rgb .5}";
    assert_filled(media, "", [0.1341, 0.3275, 0.5429]);
    assert_filled("absorption .1 density{rgbft <1,1,1,.5,.5>}", "", [0.1341, 0.2681, 0.4022]);
}

#[test]
fn lamps_are_scattered() {
    let media = "scattering{1,<.1,.2,.3>}";
    let clear = "scattering{1,<.1,.2,.3> extinction 0}";
    assert_filled(media, SUN, [0.4424, 0.6613, 0.7519]);
    assert_filled(clear, SUN, [0.6, 1.0, 1.0]);
    assert_filled("scattering{1,<.1,.2,.3> extinction .5}", SUN, [0.5144, 0.8849, 1.0]);
    for light in
        ["", "light_source{<0,100,2> rgb 1 media_interaction off}", "light_source{9*y rgb 1 shadowless}"]
    {
        assert_filled(media, light, [0.1341, 0.1797, 0.1807]);
    }
    let shadow = "box{<-1,.5,1.05>,<1,.6,2.03> pigment{rgb 0} finish{ambient 0 diffuse 0}}";
    assert_seen(&format!("{ORTHO} {SUN} {shadow} {}", filled(clear)), [0.2833, 0.5667, 0.8500]);
}

#[test]
fn phase_functions_are_averaged_over_all_media() {
    let rayleigh = "media{scattering{4,<.1,.2,.3> extinction 0}}";
    let isotropic = "media{scattering{1,<.1,.2,.3> extinction 0}}";
    for (more, red) in [(isotropic, 0.9198), ("media{emission .05}", 0.7599)] {
        let both = container(&format!("{rayleigh} {more}"));
        let seen = picture(&scene(&format!("{ORTHO} {BACK} {both} {SUN}"), "3.7"), &RenderOptions::new(1, 1));
        let [ours, ..] = seen.unwrap().image.pixels[0];
        assert!((ours - red).abs() < TOLERANCE, "{more}: {ours} not {red}");
    }
}

#[test]
fn spotlights_light_the_media_in_their_cone() {
    let spot = |radius: &str| {
        format!(
            "{ORTHO} light_source{{<0,10,2> rgb 1 spotlight radius {radius} falloff 5.71059314 tightness 0 \
             point_at <0,0,2>}}"
        )
    };
    let fading = spot("0");
    let media = "scattering{1,<.1,.2,.3> extinction 0}";
    assert_seen(&format!("{fading} {}", filled(media)), [0.1528, 0.3055, 0.4583]);
    let many = filled(&format!("samples 100 {media}"));
    assert_seen(&format!("{fading} {many}"), [0.1396, 0.2791, 0.4187]);
    let sharp = spot("5.71059314");
    for method in ["method 2", "method 3"] {
        assert_seen(&format!("{sharp} {}", filled(&format!("{method} {media}"))), [0.2, 0.4, 0.6]);
    }
}

#[test]
fn nested_and_overlapping_media_add() {
    let filled = |from: f64, to: f64, density: f64| {
        format!(
            "box{{<-5,-5,{from}>,<5,5,{to}> hollow pigment{{rgbt 1}} interior{{media{{absorption {density}}}}}}}"
        )
    };
    let nested = format!("{ORTHO} {BACK} {} {}", filled(0.0, 4.0, 0.1), filled(1.0, 3.0, 0.2));
    assert_seen(&nested, [0.0899, 0.1797, 0.2696]);
    let overlapping = format!("{ORTHO} {BACK} {} {}", filled(0.0, 3.0, 0.1), filled(2.0, 4.0, 0.2));
    assert_seen(&overlapping, [0.0993, 0.1986, 0.2979]);
}

#[test]
fn solid_objects_displace_media() {
    let solid = container("media{absorption .1}").replace("hollow", "");
    assert_seen(&format!("{ORTHO} {BACK} {solid}"), [0.2, 0.4, 0.6]);
    let outer = container("media{absorption .1}");
    let clear = "box{<-5,-.5,1>,<5,.5,3> pigment{rgbt 1}}";
    assert_seen(&format!("{ORTHO} {BACK} {outer} {clear}"), [0.1637, 0.3275, 0.4912]);
}

#[test]
fn the_camera_may_be_inside_of_media() {
    let around = format!(
        "camera{{orthographic location 0 direction z right 1e-6*x up 1e-6*y}} {BACK} \
         plane{{y,50 hollow pigment{{rgbt 1}} interior{{media{{absorption .1}}}}}}"
    );
    assert_seen(&around, [0.2, 0.4, 0.6]);
    let wall = "box{<-5,-5,10>,<5,5,11> pigment{rgb 1} finish{emission 1 ambient 0 diffuse 0}}";
    assert_seen(&format!("{around} {wall}"), [0.3679; 3]);
}

#[test]
fn media_of_the_air_reach_to_the_end_of_the_world() {
    assert_seen(&format!("{ORTHO} {BACK} media{{absorption 1e-10*<1,2,3>}}"), [0.0271, 0.0073, 0.0015]);
    let wall = "plane{-z,0 pigment{rgb <.2,.4,.8>} finish{ambient 0 emission 1 diffuse 0}}";
    let bow = "rainbow{direction z angle 0 width 20 distance 10 color_map{[0 rgb <1,0,0>][1 rgb <1,0,0>]}}";
    let all = "media{absorption .05 emission <0,.02,0>} fog{distance 20 rgb <0,0,1>}";
    assert_seen(&format!("{ORTHO} {wall} {bow} {all}"), [0.2596, 0.1536, 0.5017]);
}

#[test]
fn media_hide_what_is_transparent_behind() {
    let sdl = format!("{ORTHO} {}", filled("emission <.05,.1,.15> absorption <.1,.2,.3>"));
    let options = RenderOptions { output_alpha: true, ..RenderOptions::new(1, 1) };
    let [r, g, b, alpha] = [0.3395, 0.5859, 0.7681, 0.5019];
    assert_pixel(&sdl, "3.7", &options, &[r * alpha, g * alpha, b * alpha, alpha], 1.5e-4);
}

const DOWN: &str = "camera{orthographic location <0,1,0> direction -y right 1e-6*x up 1e-6*z}";
const GROUND: &str = "plane{y,0 pigment{rgb 1} finish{ambient 0 diffuse 1}}";

#[test]
fn media_inside_objects_dim_every_lamp_up_to_the_last_surface() {
    let light = "light_source{<0,8,0> rgb <1,.5,.25>}";
    let rows = [
        (2.0, 6.0, [0.6703, 0.2247, 0.2047]),
        (-2.0, 16.0, [0.9048, 0.4094, 0.2378]),
        (2.0, 16.0, [1.0, 0.5, 0.25]),
        (-2.0, 5.0, [0.5488, 0.1506, 0.1852]),
    ];
    for (low, high, observed) in rows {
        let media = "media{absorption <.1,.2,.05>}";
        let cloud = format!("box{{<-5,{low},-5>,<5,{high},5> hollow pigment{{rgbt 1}} interior{{{media}}}}}");
        assert_seen(&format!("{DOWN} {GROUND} {light} {cloud}"), observed);
    }
    let ramp = "density{gradient y color_map{[0 rgb 0][1 rgb 1]} scale 4 translate 2*y}";
    for (method, observed) in [("", [0.8425, 0.7097, 0.9179]), ("method 2", [0.8187, 0.6703, 0.9048])] {
        let media = format!("media{{{method} absorption <.1,.2,.05> {ramp}}}");
        let cloud = format!("box{{<-5,2,-5>,<5,6,5> hollow pigment{{rgbt 1}} interior{{{media}}}}}");
        assert_seen(&format!("{DOWN} {GROUND} light_source{{<0,8,0> rgb 1}} {cloud}"), observed);
    }
}

#[test]
fn media_of_the_air_dim_lamps_around_solid_objects_too() {
    let sdl = format!(
        "{DOWN} {GROUND} light_source{{<0,8,0> rgb <1,.5,.25> media_attenuation on}} \
         media{{absorption <.1,.2,.05>}} box{{<-5,2,-5>,<5,6,5> pigment{{rgbt 1}}}}"
    );
    assert_seen(&sdl, [0.4066, 0.0826, 0.1594]);
}

/// Mean and standard deviation of the red of many pixels.
fn spread(sdl: &str, version: &str, size: u32) -> (f32, f32) {
    let seen = picture(&scene(sdl, version), &RenderOptions::new(size, size)).unwrap();
    let reds: Vec<f32> = seen.image.pixels.iter().map(|pixel| pixel[0]).collect();
    let count = reds.len() as f32;
    let mean = reds.iter().sum::<f32>() / count;
    let variance = reds.iter().map(|red| (red - mean).powi(2)).sum::<f32>() / count;
    (mean, variance.sqrt())
}

#[test]
fn random_samples_vary_as_much_as_observed() {
    let rows = [
        ("method 1 E A ", "3.7", 0.2928, 0.025),
        ("method 1 E RAMP ", "3.7", 0.400, 0.037),
        ("method 1 samples 1,10 E RAMP ", "3.7", 0.400, 0.114),
        ("method 1 samples 2,10 E RAMP ", "3.7", 0.400, 0.073),
        ("method 2 jitter 1 E RAMP ", "3.7", 0.399, 0.019),
        ("method 3 jitter 1 samples 10 aa_threshold 100 emission .1 LONG ", "3.7", 0.2282, 0.01105),
        ("emission .1 RAMP ", "3.1", 0.4000, 0.0038),
    ];
    for (media, version, mean, deviation) in rows {
        let (ours, spread) = spread(&format!("{ORTHO} {BACK} {}", filled(media)), version, 32);
        let error = deviation / 32.0;
        assert!((ours - mean).abs() < 4.0 * error + 5e-4, "{media}: mean {ours}");
        assert!((spread - deviation).abs() < 0.1 * deviation, "{media}: spread {spread}");
    }
}
