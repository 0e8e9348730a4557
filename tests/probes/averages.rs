//! What is random comes to the same mean as with POV-Ray: averages of many pictures of both.
//!
//! POV-Ray's random numbers are the same in every rendering: two pictures of a scene are one picture.
//! So its scenes are *stirred*: something that nobody sees takes another number of random numbers in
//! each picture before the others get theirs. And it has no more than [`RING`] numbers, taken again
//! and again: pictures that use them up don't make its mean any surer.

use std::path::Path;
use std::process::{Child, Command, Stdio};

use povista::options::RenderOptions;

use crate::table::picture;

/// Edge of the squares whose means are compared.
const BLOCK: usize = 8;

/// The size of the pictures; the scenes are read as for pictures of this shape.
const SIZE: [usize; 2] = [64, 48];

/// How many random numbers POV-Ray has for lights and media (docs/spec/atmosphere-gi.md 7).
const RING: f64 = 32768.0;

/// One kind of chance.
struct Kind {
    name: &'static str,
    scene: &'static str,
    stir: Stir,
}

/// Who takes random numbers from POV-Ray, `S` times for each pixel.
#[derive(Clone, Copy)]
enum Stir {
    /// Media before everything else.
    Media,
    /// A grid of lamps too dark to be seen.
    Lights,
    /// Lamps too dark to be seen on a surface with `crand`.
    Grain,
}

impl Stir {
    fn sdl(self) -> &'static str {
        match self {
            Self::Media => {
                "#declare S = 1 + mod(clock * 37, 251); box { <-9, -9, -7.4>, <9, 9, -7> hollow no_shadow \
                 no_reflection pigment { rgbt 1 } interior { media { method 1 samples S emission 1e-9 } } }"
            }
            Self::Lights => {
                "#declare S = 1 + mod(clock * 37, 127); \
                 light_source { <0, 9, -9> rgb 1e-7 area_light x, y, S, 1 jitter media_interaction off }"
            }
            Self::Grain => {
                "#declare S = 1 + mod(clock * 37, 67); \
                 #for (I, 1, S) light_source { <0, 9, -9> rgb 1e-7 shadowless } #end"
            }
        }
    }
}

const STAGE: &str = "#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -8> look_at 0 right x*4/3 angle 40 }
";

const LIT: &str = "light_source { <-6, 5, -4> rgb 0.9 }";

/// A container that fills the picture, so that all blocks take as many random numbers.
const VIEW: &str = "box { <-4, -3, -2>, <4, 3, 2> hollow pigment { rgbt 1 } interior";

const ROOM: &str = "plane { y, -1.5 pigment { rgb 0.9 } } plane { -z, -6 pigment { rgb 0.8 } }
sphere { <-1.2, -0.7, 0>, 0.8 pigment { rgb <0.9, 0.7, 0.5> } finish { phong 0.5 } }
box { <0.5, -1.5, -0.4>, <1.5, 0.8, 0.6> pigment { rgb <0.5, 0.7, 0.9> } }
";

const KINDS: [Kind; 12] = [
    Kind {
        name: "media, method 1",
        scene: "LIT VIEW { media {
            method 1 samples 4 intervals 2 emission 0.3 absorption 0.2 density { spherical scale 2 } } } }",
        stir: Stir::Media,
    },
    Kind {
        name: "media, method 1, samples while they vary",
        scene: "LIT VIEW { media {
            method 1 samples 3, 9 variance 0.0005 emission 0.3 density { spherical scale 2 } } } }",
        stir: Stir::Media,
    },
    Kind {
        name: "media, method 2, jitter",
        scene: "LIT VIEW { media {
            method 2 samples 6 jitter 0.7 emission 0.3 density { spherical scale 2 } } } }",
        stir: Stir::Media,
    },
    Kind {
        name: "media, method 2, samples while they vary",
        scene: "LIT sphere { 0, 2 hollow pigment { rgbt 1 } interior { media { method 2 samples 4, 12
            variance 0.0001 emission 0.3 absorption 0.3 density { gradient y sine_wave } } } }",
        stir: Stir::Media,
    },
    Kind {
        name: "media, method 3, jitter",
        scene: "LIT VIEW { media {
            method 3 samples 2 aa_threshold 9 jitter 1 scattering { 1, 0.3 } density { spherical scale 2 } } } }",
        stir: Stir::Media,
    },
    Kind {
        name: "media of the air, lit by a cone",
        scene: "light_source { <-2, 5, 0> rgb 2 spotlight point_at 0 radius 20 falloff 30 }
            plane { -z, -6 pigment { rgb 0.5 } }
            sphere { 0, 0.7 pigment { rgb 0.9 } }
            media { method 1 samples 4 intervals 3 scattering { 2, 0.06 } }",
        stir: Stir::Media,
    },
    Kind {
        name: "shadow of media, method 1",
        scene: "light_source { <0, 6, -2> rgb 0.9 } plane { y, -1.5 pigment { rgb 0.9 } }
            sphere { y, 1 hollow pigment { rgbt 1 } interior { media {
            method 1 samples 3 absorption 1 density { spherical } } } }",
        stir: Stir::Media,
    },
    Kind {
        name: "area_light, jitter",
        scene: "light_source { <-4, 5, -4> rgb 0.9 area_light 3*x, 3*z, 3, 2 jitter } ROOM",
        stir: Stir::Lights,
    },
    Kind {
        name: "area_light, adaptive, circular, orient, jitter",
        scene: "light_source { <4, 5, -4> rgb 0.9 area_light 3*x, 3*z, 5, 5 adaptive 0 circular orient jitter } ROOM",
        stir: Stir::Lights,
    },
    Kind {
        name: "area_light, area_illumination, jitter",
        scene: "light_source { <2, 3, -2> rgb 0.9 area_light 4*x, 4*z, 2, 2 jitter area_illumination } ROOM",
        stir: Stir::Lights,
    },
    Kind {
        name: "finish, crand",
        scene:
            "light_source { <-4, 5, -4> rgb <0.9, 0.6, 0.3> } light_source { <4, 5, -8> rgb <0.1, 0.3, 0.6> }
            plane { -z, -2 pigment { rgb 0.9 } finish { crand 0.3 } }
            sphere { 0, 1 pigment { rgb 0.8 } finish { crand 0.5 diffuse 0.9 } }",
        stir: Stir::Grain,
    },
    Kind {
        name: "rainbow, jitter",
        scene: "plane { -z, -20 pigment { rgb <0.45, 0.55, 0.7> } finish { emission 1 } }
            rainbow { direction <0.1, -0.2, 1> angle 10 width 12 distance 20 jitter 0.1
            color_map { [0 rgbt <0.6, 0, 1, 0.5>] [0.3 rgbt <0, 0.3, 1, 0.3>] [0.6 rgbt <0.3, 1, 0.2, 0.3>]
            [1 rgbt <1, 0.1, 0, 0.5>] } }",
        stir: Stir::Lights,
    },
];

impl Kind {
    /// The scene, after `first`.
    fn text(&self, first: &str) -> String {
        format!(
            "{STAGE}{first}\n{}",
            self.scene.replace("LIT", LIT).replace("ROOM", ROOM).replace("VIEW", VIEW)
        )
    }
}

/// Sums over the pictures of one program, for every colour of every block.
#[derive(Default)]
struct Means {
    sums: Vec<f64>,
    squares: Vec<f64>,
    count: f64,
}

impl Means {
    /// Adds a picture: rows of pixels with three components.
    fn add(&mut self, components: &[f64]) {
        let [across, down] = SIZE.map(|edge| edge / BLOCK);
        self.sums.resize(3 * across * down, 0.0);
        self.squares.resize(3 * across * down, 0.0);
        let mut means = vec![0.0; 3 * across * down];
        for (place, component) in components.iter().enumerate() {
            let (x, y) = (place / 3 % SIZE[0], place / 3 / SIZE[0]);
            let block = y / BLOCK * across + x / BLOCK;
            means[3 * block + place % 3] += component.clamp(0.0, 1.0) / (BLOCK * BLOCK) as f64;
        }
        for (index, mean) in means.into_iter().enumerate() {
            self.sums[index] += mean;
            self.squares[index] += mean * mean;
        }
        self.count += 1.0;
    }

    /// The mean of a block, and the square of its standard error if the pictures are independent.
    fn of(&self, index: usize) -> (f64, f64) {
        let mean = self.sums[index] / self.count;
        let variance = (self.squares[index] / self.count - mean * mean).max(0.0);
        (mean, variance / (self.count - 1.0))
    }
}

/// Starts POV-Ray on the pictures of a kind, `NN.ppm` in a folder.
fn povray(kind: &Kind, folder: &Path, pictures: u64) -> Child {
    let scene = folder.join("scene.pov");
    std::fs::write(&scene, kind.text(kind.stir.sdl())).unwrap();
    Command::new("povray")
        .args([format!("+I{}", scene.display()), format!("+O{}", folder.join("f.ppm").display())])
        .args([format!("+W{}", SIZE[0]), format!("+H{}", SIZE[1]), "+KFI1".into(), format!("+KFF{pictures}")])
        .args(["+KI1".into(), format!("+KF{pictures}")])
        .args(["+FP16", "File_Gamma=1.0", "-D", "-A", "-J", "+WT1"])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap_or_else(|error| panic!("povray: {error}"))
}

/// POV-Ray's pictures in a folder.
fn read(folder: &Path) -> Means {
    let mut means = Means::default();
    let mut files: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    for file in files.iter().filter(|file| file.extension().is_some_and(|extension| extension == "ppm")) {
        let samples = image::open(file).unwrap().into_rgb16();
        means.add(&samples.iter().map(|&sample| f64::from(sample) / 65535.0).collect::<Vec<_>>());
    }
    means
}

/// Our pictures, each with another seed, and the random numbers a block takes.
fn ours(kind: &Kind, pictures: u64) -> (Means, f64) {
    let mut means = Means::default();
    let mut drawn = 0;
    for seed in 0..pictures {
        let options = RenderOptions { seed, ..RenderOptions::new(SIZE[0] as u32, SIZE[1] as u32) };
        let rendered =
            picture(&kind.text(""), &options).unwrap_or_else(|error| panic!("{}: {error}", kind.name));
        let pixels = &rendered.image.pixels;
        let components = pixels.iter().flat_map(|pixel| pixel[..3].iter().map(|&c| f64::from(c)));
        means.add(&components.collect::<Vec<_>>());
        drawn += rendered.statistics.random_numbers;
    }
    let blocks = pictures as usize * means.sums.len() / 3;
    (means, drawn as f64 / blocks as f64)
}

/// How far apart the means of blocks are, in standard errors of their difference, from negative where
/// ours is darker.
fn distances(ours: &Means, theirs: &Means, drawn: f64, stir: Stir) -> Vec<f64> {
    // The numbers of `crand` are no ring.
    let again = if matches!(stir, Stir::Grain) { 1.0 } else { (theirs.count * drawn / RING).max(1.0) };
    let distance = |index| {
        let ((a, va), (b, vb)) = (ours.of(index), theirs.of(index));
        // Sixteen bits and single precision are the least error.
        let apart = (a - b).abs() - 2e-5;
        if apart <= 0.0 { 0.0 } else { (a - b).signum() * apart / (va + vb * again).sqrt() }
    };
    (0..ours.sums.len()).map(distance).collect()
}

#[test]
fn random_pictures_come_to_povrays_mean() {
    const PICTURES: u64 = 64;
    let folders: Vec<_> = KINDS.iter().map(|_| tempfile::tempdir().unwrap()).collect();
    let running: Vec<_> =
        KINDS.iter().zip(&folders).map(|(kind, folder)| povray(kind, folder.path(), PICTURES)).collect();
    let mut apart = Vec::new();
    for ((kind, folder), mut child) in KINDS.iter().zip(&folders).zip(running) {
        let (ours, drawn) = ours(kind, PICTURES);
        assert!(child.wait().unwrap().success(), "POV-Ray failed at {}", kind.name);
        let theirs = read(folder.path());
        assert_eq!(theirs.count, PICTURES as f64, "{}", kind.name);
        let distances = distances(&ours, &theirs, drawn, kind.stir);
        let near = distances.iter().filter(|distance| distance.abs() <= 3.0).count();
        let share = 100.0 * near as f64 / distances.len() as f64;
        let mean = distances.iter().sum::<f64>() / distances.len() as f64;
        let square =
            distances.iter().map(|distance| distance * distance).sum::<f64>() / distances.len() as f64;
        println!("| {} | {drawn:.0} | {share:.2} % | {mean:+.2} | {:.2} |", kind.name, square.sqrt());
        if share < 99.0 {
            apart.push(kind.name);
        }
    }
    assert!(apart.is_empty(), "{apart:?}");
}
