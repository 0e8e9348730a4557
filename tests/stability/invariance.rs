//! The same picture in every size and place: a whole scene, camera and light along, is scaled or moved.
//!
//! To count the pixels that change in POV-Ray's pictures too, and write both to `invariance.txt`:
//!
//! ```text
//! POVISTA_STABILITY=renew cargo test --profile testing --test stability invariance
//! ```

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use povista::compile::compile;
use povista::diag::Collect;
use povista::interp::interpret;
use povista::options::{LanguageOptions, RenderOptions};
use povista::render::render;
use povista::source::{Library, Source, Sources};

const WIDTH: u32 = 160;
const HEIGHT: u32 = 120;

/// Powers of ten by which the scene is scaled.
const SCALES: [i32; 6] = [-6, -4, -2, 2, 4, 6];

/// Powers of ten by which it is moved.
const MOVES: [i32; 4] = [2, 4, 6, 7];

/// Colours further apart than this, of 255, are another colour.
const NEAR: i32 = 2;

/// Pixels on edges, where rounding may decide.
const EDGES: usize = 3;

/// The objects, of about size 1.
const OBJECTS: [(&str, &str); 32] = [
    ("sphere", "sphere { 0, 1 }"),
    ("ellipsoid", "sphere { 0, 1 scale <1, 0.7, 0.8> }"),
    ("plane", "plane { <0.2, 1, -0.3>, -0.3 }"),
    ("box", "box { -0.8, 0.8 rotate <20, 30, 0> }"),
    ("cylinder", "cylinder { -y, y, 0.7 rotate 20*x }"),
    ("cone", "cone { -y, 0.9, y, 0.2 rotate 20*x }"),
    ("torus", "torus { 0.75, 0.25 rotate 30*x }"),
    ("thin torus", "torus { 1, 0.02 rotate 30*x }"),
    ("disc", "disc { 0, <0.2, 0.5, -1>, 1, 0.3 }"),
    ("triangle", "triangle { <-1,-1,0>, <1,-1,0.3>, <0,1,0> }"),
    (
        "smooth_triangle",
        "smooth_triangle { <-1,-1,0>, <-1,-1,-2>, <1,-1,0.3>, <1,-1,-2>, <0,1,0>, <0,1,-2> }",
    ),
    ("polygon", "polygon { 4, <-1,-1,0>, <1,-1,0>, <0,1,0>, <-1,-1,0> }"),
    (
        "mesh",
        "mesh { triangle { <-1,-1,0>, <1,-1,0.3>, <0,1,0> } triangle { <-1,-1,0>, <0,1,0>, <-1,1,0.4> } }",
    ),
    (
        "mesh2",
        "mesh2 { vertex_vectors { 4, <-1,-1,0>, <1,-1,0.3>, <0,1,0>, <-1,1,0.4> } face_indices { 2, <0,1,2>, <0,2,3> } }",
    ),
    ("quadric", "quadric { <1,1.5,1>, <0.1,0,0>, <0,0,0>, -1 }"),
    (
        "cubic",
        "cubic { <1,0,0,0,0,0,0,0,0,0, 0,0,0,0,0,-1,0,0,0,0> clipped_by { sphere { 0, 1.2 } } rotate 60*x }",
    ),
    (
        "quartic",
        "quartic { <1,0,0,0,2,0,0,2,0,-1.25, 0,0,0,0,0,0,0,0,0,0, 1,0,0,2,0,1,0,0,0,0, 1,0,-1.25,0,0.25> rotate 30*x }",
    ),
    (
        "poly",
        "polynomial { 6, xyz(6,0,0): 1, xyz(0,6,0): 1, xyz(0,0,6): 1, xyz(0,0,0): -0.3 rotate <20, 30, 0> }",
    ),
    (
        "blob",
        "blob { threshold 0.4 sphere { <-0.4,0,0>, 0.9, 1 } cylinder { <0.4,0.3,0>, <0.4,-0.5,0>, 0.8, 1 } }",
    ),
    ("superellipsoid", "superellipsoid { <0.4,0.6> scale 0.8 rotate <20,30,0> }"),
    (
        "lathe",
        "lathe { cubic_spline 6, <0.1,-1.5>, <0.4,-1>, <0.9,-0.2>, <0.5,0.5>, <0.2,1>, <0,2> rotate 20*x }",
    ),
    ("sor", "sor { 6, <0.2,-1.5>, <0.5,-1>, <0.9,-0.4>, <0.4,0.2>, <0.6,0.9>, <0.3,2> rotate 20*x }"),
    (
        "prism",
        "prism { cubic_spline -0.5, 0.5, 7, <-0.8,0.8>, <-0.8,-0.8>, <0.7,-0.6>, <0.9,0.7>, <-0.8,0.8>, <-0.8,-0.8>, <0.7,-0.6> rotate -60*x }",
    ),
    (
        "sphere_sweep",
        "sphere_sweep { b_spline 5, <-1.5,-1,0>, 0.3, <-0.7,0,0>, 0.4, <0,0.8,0>, 0.3, <0.8,0,0.2>, 0.5, <1.5,-1,0>, 0.3 }",
    ),
    (
        "isosurface",
        "isosurface { function { x*x*x*x + y*y*y*y + z*z - 0.6 } max_gradient 4.5 contained_by { box { -1, 1 } } }",
    ),
    (
        "parametric",
        "parametric { function { sin(u)*cos(v) }, function { sin(u)*sin(v) }, function { 0.8*cos(u) } <0,0>, <pi,2*pi> contained_by { sphere { 0, 1.1 } } max_gradient 2 accuracy 0.0001 }",
    ),
    (
        "bicubic_patch",
        "bicubic_patch { type 1 flatness 0.001 u_steps 4 v_steps 4 <-1,-1,0.5>, <-0.3,-1,-0.5>, <0.3,-1,0.5>, <1,-1,0>, <-1,-0.3,0>, <-0.3,-0.3,-1>, <0.3,-0.3,0.5>, <1,-0.3,0>, <-1,0.3,0>, <-0.3,0.3,0.5>, <0.3,0.3,-1>, <1,0.3,0>, <-1,1,0>, <-0.3,1,0>, <0.3,1,0>, <1,1,0.5> }",
    ),
    ("text", "text { ttf \"timrom.ttf\" \"ag\" 0.3, 0 translate <-0.45,-0.2,0> scale 2 }"),
    ("ovus", "ovus { 0.6, 0.4 translate -0.2*y }"),
    (
        "julia_fractal",
        "julia_fractal { <-0.083,0,-0.83,-0.025> quaternion sqr max_iteration 6 precision 20 }",
    ),
    (
        "height_field",
        "height_field { function 20,20 { 0.5+0.3*sin(x*9)*cos(y*7) } translate -0.5 scale <2,1,2> rotate -50*x }",
    ),
    (
        "csg",
        "difference { box { -0.8, 0.8 } sphere { <0.3,0.4,-0.8>, 0.6 } cylinder { -z, z, 0.3 } rotate <20, 30, 0> }",
    ),
];

/// The whole scene, scaled and then moved.
fn scene(object: &str, scale: f64, far: f64) -> String {
    format!(
        "#version 3.7; global_settings {{ assumed_gamma 1 }}\n\
         #declare S = {scale:e}; #declare T = <1, -0.75, 0.5>*{far:e};\n\
         camera {{ location <0, 1, -4>*S + T look_at T right 4/3*x angle 40 }}\n\
         light_source {{ <-3, 5, -8>*S + T rgb 1 }}\n\
         object {{ {object} scale S translate T pigment {{ rgb <0.9, 0.7, 0.4> }} }}\n"
    )
}

/// Where the font is.
const INCLUDES: &str = "/usr/share/povray-3.7/include";

type Pixels = Vec<[i32; 3]>;

fn ours(text: &str) -> Pixels {
    let mut sources = Sources::new(Library::default());
    let main = sources.add(Source::new("scene.pov", "", text.as_bytes().to_vec()));
    let mut sink = Collect::default();
    let options = LanguageOptions { library_paths: vec![INCLUDES.into()], ..LanguageOptions::default() };
    let scene = interpret(main, &mut sources, &options, &mut sink);
    let scene = scene.unwrap_or_else(|| panic!("{text}: {:?}", sink.diagnostics));
    let options = RenderOptions::new(WIDTH, HEIGHT);
    let image = render(&compile(scene, &options).world, &options, &()).image;
    let byte = |linear: f32| (255.0 * linear.clamp(0.0, 1.0).powf(1.0 / 2.2)).round() as i32;
    image.pixels.iter().map(|&[r, g, b, _]| [r, g, b].map(byte)).collect()
}

/// `None` where it refuses the scene.
fn theirs(text: &str, folder: &Path) -> Option<Pixels> {
    std::fs::write(folder.join("scene.pov"), text).expect("the folder can be written to");
    let size = [format!("+W{WIDTH}"), format!("+H{HEIGHT}")];
    let output = Command::new("povray")
        .current_dir(folder)
        .args(["+Iscene.pov", "+Oout.png", "-D"])
        .args(size)
        .output();
    if !output.is_ok_and(|output| output.status.success()) {
        return None;
    }
    let image = image::open(folder.join("out.png")).ok()?.to_rgb8();
    Some(image.pixels().map(|pixel| pixel.0.map(i32::from)).collect())
}

fn changed(a: &Pixels, b: &Pixels) -> usize {
    let far = |(a, b): (&[i32; 3], &[i32; 3])| a.iter().zip(b).any(|(a, b)| (a - b).abs() > NEAR);
    a.iter().zip(b).filter(|pair| far(*pair)).count()
}

/// How many pixels change in each size and place; `None` for a refusal.
fn changes(object: &str, picture: impl Fn(&str) -> Option<Pixels>) -> Vec<Option<usize>> {
    let still = picture(&scene(object, 1.0, 0.0)).expect("the scene is rendered as it stands");
    let sizes = SCALES.iter().map(|&power| (10f64.powi(power), 0.0));
    let places = MOVES.iter().map(|&power| (1.0, 10f64.powi(power)));
    let other = sizes.chain(places).map(|(scale, far)| picture(&scene(object, scale, far)));
    other.map(|other| Some(changed(&still, &other?))).collect()
}

fn path() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/stability/invariance.txt")
}

fn row(name: &str, program: &str, changes: &[Option<usize>]) -> String {
    let mut row = format!("{name:<16} {program:<8}");
    for change in changes {
        let cell = change.map_or("-".to_owned(), |count| count.to_string());
        write!(row, " {cell:>6}").expect("strings can be written to");
    }
    row
}

#[test]
fn pictures_do_not_depend_on_size_and_place() {
    let renew = std::env::var("POVISTA_STABILITY").is_ok_and(|word| word == "renew");
    let mut table = String::from("pixels of 19200 that change by more than 2 of 255; - is a scene refused\n");
    write!(table, "{:<25}", "").expect("strings can be written to");
    let heads =
        SCALES.iter().map(|power| format!("x1e{power}")).chain(MOVES.iter().map(|p| format!("+1e{p}")));
    heads.for_each(|head| write!(table, " {head:>6}").expect("strings can be written to"));
    table.push('\n');
    let folder = tempfile::tempdir().expect("there is room for a folder");
    let mut wrong = Vec::new();
    for (name, object) in OBJECTS {
        let counts = changes(object, |text| Some(ours(text)));
        let line = row(name, "povista", &counts);
        println!("{line}");
        table += &format!("{line}\n");
        if counts.iter().any(|count| count.is_none_or(|count| count > EDGES)) {
            wrong.push(line);
        }
        if renew {
            let line = row(name, "POV-Ray", &changes(object, |text| theirs(text, folder.path())));
            println!("{line}");
            table += &format!("{line}\n");
        }
    }
    if renew {
        std::fs::write(path(), table).expect("the table can be written");
    }
    assert!(wrong.is_empty(), "pictures change:\n{}", wrong.join("\n"));
}
