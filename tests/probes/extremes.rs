//! Extremes of light and air beside POV-Ray's pictures of them: the same where POV-Ray is right.

use std::process::{Child, Command, Stdio};

use povista::options::RenderOptions;

use crate::table::picture;

const SIZE: [u32; 2] = [32, 24];

const EYE: &str = "camera{location -5*z right x*4/3 angle 40} background{rgb <.2,.4,.6>}";
const LAMP: &str = "light_source{<3,5,-4> rgb 1}";
const ROOM: &str = "plane{-z,-3 pigment{rgb 1}} sphere{<.5,.2,0>,.6 pigment{rgb <1,.8,.6>}}";

/// A ball of media before a wall.
fn ball(media: &str) -> String {
    format!(
        "{EYE} {LAMP} sphere{{0,1 hollow pigment{{rgbt 1}} interior{{media{{{media}}}}}}} \
         plane{{-z,-3 pigment{{checker rgb 1 rgb .3}}}}"
    )
}

/// A room with one lamp of some kind.
fn lit(kind: &str) -> String {
    format!("{EYE} light_source{{<-2,2,-4> rgb 1 {kind}}} {ROOM}")
}

/// A scene is shown in full before it is compared, so that one run tells of all that differ.
fn assert_same(scenes: &[(String, String)]) {
    let folder = tempfile::tempdir().unwrap();
    let start = |(number, (_, sdl)): (usize, &(String, String))| -> Child {
        let text = format!("#version 3.7; global_settings{{assumed_gamma 1}} {sdl}");
        let file = folder.path().join(format!("{number}.pov"));
        std::fs::write(&file, text).unwrap();
        Command::new("povray")
            .args([format!("+I{}", file.display()), format!("+O{}", file.with_extension("ppm").display())])
            .args([format!("+W{}", SIZE[0]), format!("+H{}", SIZE[1])])
            .args(["+FP16", "File_Gamma=1.0", "-D", "-A", "+WT1"])
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap_or_else(|error| panic!("povray: {error}"))
    };
    let running: Vec<Child> = scenes.iter().enumerate().map(start).collect();
    let mut wrong = Vec::new();
    for ((number, (name, sdl)), mut child) in scenes.iter().enumerate().zip(running) {
        assert!(child.wait().unwrap().success(), "POV-Ray refuses {name}");
        let theirs = image::open(folder.path().join(format!("{number}.ppm"))).unwrap().into_rgb16();
        let text = format!("#version 3.7; global_settings{{assumed_gamma 1}} {sdl}");
        let ours =
            picture(&text, &RenderOptions::new(SIZE[0], SIZE[1])).unwrap_or_else(|e| panic!("{name}: {e}"));
        let apart = |(ours, theirs): (&[f32; 4], &image::Rgb<u16>)| {
            let far =
                |i: usize| (ours[i].clamp(0.0, 1.0) - f32::from(theirs[i]) / 65535.0).abs() > 2.0 / 255.0;
            (0..3).any(far)
        };
        let count = ours.image.pixels.iter().zip(theirs.pixels()).filter(|&pair| apart(pair)).count();
        if count * 200 > ours.image.pixels.len() {
            wrong.push(format!("{name}: {count} pixels"));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

fn named<const N: usize>(
    kind: &str,
    rows: [&str; N],
    scene: impl Fn(&str) -> String,
) -> Vec<(String, String)> {
    rows.iter().map(|row| (format!("{kind}: {row}"), scene(row))).collect()
}

#[test]
fn media_of_every_optical_depth_look_the_same() {
    let mut scenes = Vec::new();
    for depth in ["0", "1e-6", "1e-3", "1", "30", "1e3", "1e6"] {
        let media = [
            &*format!("absorption <1,.5,.25>*{depth}"),
            &format!("absorption <1,.5,.25>*{depth} emission .2*{depth}"),
            &format!("scattering{{5,<1,.5,.25>*{depth} eccentricity .5}}"),
            &format!("method 2 absorption {depth} emission .3*{depth} density{{spherical}}"),
        ];
        scenes.extend(named("depth", media, ball));
    }
    assert_same(&scenes);
}

#[test]
fn intervals_and_containers_that_meet_look_the_same() {
    let beams = |kind: &str, more: &str| {
        let at = |x: &str| format!("light_source{{<{x},4,0> rgb .7 {kind} point_at <{x},0,0> {more}}}");
        format!("{} {} {}", ball("intervals 3 scattering{1,.4}"), at("-.25"), at(".25"))
    };
    let filled = |from: f64, to: f64, depth: f64| {
        format!(
            "box{{<-1,-1,{from}>,<1,1,{to}> hollow pigment{{rgbt 1}} \
             interior{{media{{absorption {depth} emission .1}}}}}}"
        )
    };
    let inside = "camera{location 0 direction z right x*4/3 angle 60}";
    let around = |media: &str, lamp: &str| {
        format!(
            "{inside} light_source{{{lamp} rgb 1}} sphere{{0,2 hollow pigment{{rgbt .8}} \
             interior{{media{{{media}}}}}}} plane{{-z,-6 pigment{{checker rgb 1 rgb .3}}}} plane{{y,-1 pigment{{rgb .7}}}}"
        )
    };
    assert_same(&[
        ("beams that touch".into(), beams("cylinder", "radius .25 falloff .25")),
        ("beams that overlap".into(), beams("cylinder", "radius .3 falloff .4")),
        ("cones that overlap".into(), beams("spotlight", "radius 5 falloff 8")),
        (
            "containers with a gap".into(),
            format!("{EYE} {LAMP} {} {}", filled(-1.0, 0.0, 0.3), filled(0.01, 1.0, 0.6)),
        ),
        (
            "containers that overlap".into(),
            format!("{EYE} {LAMP} {} {}", filled(-1.0, 0.01, 0.3), filled(0.0, 1.0, 0.6)),
        ),
        ("inside, lamp outside".into(), around("absorption .2 scattering{1,.2}", "<3,5,-4>")),
        ("inside with the lamp".into(), around("absorption .2 scattering{1,.2}", "<.3,.4,.2>")),
    ]);
}

#[test]
fn lamps_in_and_on_objects_look_the_same() {
    let scene = |lamp: &str, more: &str| {
        format!(
            "{EYE} light_source{{{lamp} rgb 1}} {more} plane{{-z,-3 pigment{{rgb 1}}}} plane{{y,-1.5 pigment{{rgb 1}}}}"
        )
    };
    assert_same(&[
        ("in glass".into(), scene("0", "sphere{0,1 pigment{rgbf <1,.7,.5,.8>} interior{ior 1.5}}")),
        ("in an opaque body".into(), scene("0", "sphere{0,1 pigment{rgb 1}}")),
        (
            "in media".into(),
            scene("0", "sphere{0,1 hollow pigment{rgbt 1} interior{media{scattering{1,.5}}}}"),
        ),
        ("on a clear ball".into(), scene("-z", "sphere{0,1 hollow pigment{rgbt .8}}")),
    ]);
}

#[test]
fn cones_of_every_angle_look_the_same() {
    let angles = [
        "radius 0 falloff 0",
        "radius 0 falloff 90",
        "radius 90 falloff 90",
        "radius 90 falloff 0",
        "radius 89 falloff 90 tightness 3",
        "radius 20 falloff 20",
        "radius 0 falloff 120",
    ];
    let mut scenes = named("cone", angles, |angles| lit(&format!("spotlight point_at 0 {angles}")));
    scenes.extend(named("beam", ["0", "1e-6", "1", "1e6"], |size| {
        lit(&format!("cylinder point_at 0 radius {size} falloff {size}"))
    }));
    assert_same(&scenes);
}

/// POV-Ray leaves media dark below a cone of exactly 90 degrees, though surfaces are lit. With us it
/// lights as one of 89.99 degrees does.
#[test]
fn a_cone_of_a_half_space_lights_media() {
    let seen = |falloff: f64| {
        let sdl = format!(
            "#version 3.7; global_settings{{assumed_gamma 1}} {EYE} \
             light_source{{<-2,2,-4> rgb 1 spotlight point_at 0 radius 0 falloff {falloff}}} \
             sphere{{0,1 hollow pigment{{rgbt 1}} interior{{media{{scattering{{1,.5}}}}}}}}"
        );
        picture(&sdl, &RenderOptions::new(SIZE[0], SIZE[1])).unwrap().image.pixels
    };
    for (exact, nearly) in seen(90.0).iter().zip(seen(89.99)) {
        assert!((0..3).all(|i| (exact[i] - nearly[i]).abs() < 1e-3), "{exact:?} {nearly:?}");
    }
}

#[test]
fn grids_and_lenses_without_size_look_the_same() {
    let grids = [
        "area_light 0,0,4,4",
        "area_light 0,0,5,5 adaptive 1",
        "area_light x,0,5,5",
        "area_light 0,0,4,4 circular orient",
        "area_light 2*x,2*y,1,1",
        "area_light 2*x,2*y,1,7",
        "area_light 0,0,3,3 area_illumination",
    ];
    let lenses = [
        "aperture 0 blur_samples 10 focal_point 0",
        "aperture 1e-9 blur_samples 7 focal_point 0",
        "aperture .4 blur_samples 1 focal_point 0",
        "aperture 3 blur_samples 4 focal_point 0",
    ];
    let mut scenes = named("grid", grids, lit);
    scenes.extend(named("lens", lenses, |lens| {
        format!("{} {LAMP} {ROOM}", EYE.replace("camera{", &format!("camera{{{lens} ")))
    }));
    assert_same(&scenes);
}

/// Where POV-Ray stops at 256 intervals.
#[test]
fn media_may_have_any_number_of_intervals() {
    let seen = |intervals: u32| {
        let sdl = ball(&format!("intervals {intervals} method 2 samples 1 emission .3 density{{spherical}}"));
        let text = format!("#version 3.7; global_settings{{assumed_gamma 1}} {sdl}");
        picture(&text, &RenderOptions::new(8, 6)).unwrap().image.pixels
    };
    for (few, many) in seen(256).iter().zip(seen(4000)) {
        assert!((0..3).all(|i| (few[i] - many[i]).abs() < 1e-4), "{few:?} {many:?}");
    }
}
