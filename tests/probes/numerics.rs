//! Extremes of light and air: never a number that is none, and the right limit where there is one.

use povista::options::RenderOptions;

use crate::table::{picture, scene};

const BACK: &str = "background{rgb <.2,.4,.6>}";
const LAMP: &str = "light_source{<3,5,-4> rgb 1}";

/// The pixels of a small picture, all of them finite.
fn pixels(sdl: &str) -> Vec<[f32; 4]> {
    let image =
        picture(&scene(sdl, "3.7"), &RenderOptions::new(12, 9)).unwrap_or_else(|e| panic!("{sdl}: {e}"));
    let pixels = image.image.pixels;
    assert!(pixels.iter().flatten().all(|component| component.is_finite()), "{sdl}");
    pixels
}

/// The pixel in the middle.
fn middle(sdl: &str) -> [f32; 3] {
    let [r, g, b, _] = pixels(sdl)[6 + 4 * 12];
    [r, g, b]
}

fn ball(media: &str) -> String {
    format!(
        "camera{{location -5*z}} {BACK} sphere{{0,1 hollow pigment{{rgbt 1}} interior{{media{{{media}}}}}}}"
    )
}

#[test]
fn media_of_any_depth_stay_finite_and_dense_ones_hide_what_is_behind() {
    let density = "density{spherical poly_wave .001}";
    for depth in ["0", "1e-9", "1e-3", "1", "30", "1e3", "1e6", "1e12"] {
        for method in [1, 2, 3] {
            for kind in [1, 2, 3, 4, 5] {
                for density in ["", density] {
                    let media = format!(
                        "method {method} samples 3,5 absorption {depth} emission {depth} \
                         scattering{{{kind},{depth}}} {density}"
                    );
                    pixels(&format!("{} {LAMP}", ball(&media)));
                }
            }
        }
        let hidden = middle(&ball(&format!("absorption {depth}")));
        if depth.parse::<f32>().unwrap_or(0.0) > 100.0 {
            assert_eq!(hidden, [0.0; 3], "{depth}");
        }
    }
    assert_eq!(middle(&ball("absorption 0")), [0.2, 0.4, 0.6]);
}

#[test]
fn media_that_give_instead_of_taking_stay_finite() {
    for media in ["absorption -1", "absorption -1e6", "emission -1", "scattering{5,1 eccentricity 1}"] {
        pixels(&format!("{} {LAMP}", ball(media)));
    }
    for media in
        ["scattering{5,1 eccentricity -1}", "scattering{1,-1}", "ratio 0 intervals 5 scattering{1,1}"]
    {
        pixels(&format!("{} {LAMP}", ball(media)));
    }
}

/// Where two faces lie in one place POV-Ray and povista go through one of them: the second box is
/// never entered. The least gap makes them two.
#[test]
fn containers_that_nearly_touch_add_up() {
    let filled = |from: f64, to: f64| {
        format!(
            "box{{<-9,-9,{from}>,<9,9,{to}> hollow pigment{{rgbt 1}} interior{{media{{absorption .3}}}}}}"
        )
    };
    let eye = format!("camera{{orthographic location -9*z right x up y}} {BACK}");
    let behind = |depth: f64| 0.2 * (-0.3 * depth).exp();
    for (start, depth) in [(1.500_000_001, 4.0), (1.5, 1.5), (1.499_999_999, 4.0)] {
        let [red, ..] = middle(&format!("{eye} {} {}", filled(0.0, 1.5), filled(start, 4.0)));
        assert!((f64::from(red) - behind(depth)).abs() < 1e-5, "{start}: {red}");
    }
}

#[test]
fn eyes_and_lamps_may_be_anywhere() {
    let room = "sphere{0,1 hollow pigment{rgbt 1} interior{media{scattering{1,.3}}}} \
        sphere{0,20 inverse hollow pigment{rgb .5}}";
    for eye in ["0", "-z", "z", "-.9999999999*z", "-5*z"] {
        for lamp in ["0", "-z", "z", "<.5,.5,-.3>", "-5*z", "<0,20,0>"] {
            for kind in ["", "spotlight point_at y falloff 30", "parallel point_at <1,2,3>"] {
                pixels(&format!(
                    "camera{{location {eye} direction z}} light_source{{{lamp} rgb 1 {kind}}} {room}"
                ));
            }
        }
    }
}

#[test]
fn a_lamp_inside_of_an_opaque_body_lights_nothing_outside() {
    let sdl = "camera{location -5*z} light_source{0 rgb 1} sphere{0,1 pigment{rgb 1} finish{ambient 0}} \
        plane{-z,-5 pigment{rgb 1} finish{ambient 0}}";
    assert!(pixels(sdl).iter().all(|pixel| pixel[..3] == [0.0; 3]));
}

#[test]
fn cones_of_any_angle_and_grids_of_no_size_are_lights() {
    let lit = |light: &str| {
        middle(&format!(
            "camera{{location -5*z}} light_source{{-5*z rgb 1 {light}}} \
             plane{{-z,0 pigment{{rgb 1}} finish{{ambient 0 diffuse 1}}}}"
        ))
    };
    let plain = lit("");
    assert!(plain[0] > 0.9);
    assert_eq!(lit("area_light 0,0,4,4"), plain);
    assert_eq!(lit("area_light 0,0,1,1 adaptive 3 jitter"), plain);
    assert_eq!(lit("spotlight point_at 0 radius 90 falloff 90 tightness 0"), plain);
    for spot in ["radius 0 falloff 0", "radius 0 falloff 90", "radius 90 falloff 0", "falloff 180 radius 170"]
    {
        lit(&format!("spotlight point_at 0 {spot}"));
    }
    lit("cylinder point_at 0 radius 0 falloff 0");
    lit("spotlight point_at -5*z");
    lit("parallel point_at -5*z");
    lit("fade_distance 1e-300 fade_power 1000");
}

#[test]
fn lenses_without_an_opening_are_no_lenses() {
    let seen = |lens: &str| {
        pixels(&format!("camera{{location -5*z {lens}}} {BACK} {LAMP} sphere{{0,1 pigment{{rgb 1}}}}"))
    };
    assert_eq!(seen("aperture 0 blur_samples 10 focal_point 0"), seen(""));
    seen("aperture 1e9 blur_samples 5 focal_point 0");
    seen("aperture 1 blur_samples 1 focal_point -5*z");
}

#[test]
fn fog_and_rainbows_of_any_size_stay_finite() {
    let eye = "camera{location <0,1,-5>} plane{y,0 hollow pigment{rgb .5}}";
    for distance in ["1e-300", "1e-9", "1", "1e9", "1e300", "-1"] {
        for kind in
            ["", "fog_type 2 fog_alt 0", "fog_type 2 fog_alt 1e-30 fog_offset 1", "fog_type 2 fog_alt 1e30"]
        {
            pixels(&format!("{eye} {LAMP} fog{{distance {distance} rgb .7 {kind}}}"));
        }
        let bow = "direction z angle 10 color_map{[0 rgb 1][1 rgb 0]}";
        for width in ["1e-300", "1e300"] {
            pixels(&format!("{eye} {LAMP} rainbow{{{bow} distance {distance} width {width}}}"));
        }
    }
}
