//! What is random comes to the same mean as with POV-Ray: averages of many pictures of both.

use std::path::Path;
use std::process::Command;

use povista::options::RenderOptions;

use crate::table::picture;

/// Edge of the squares whose means are compared.
const BLOCK: usize = 8;

/// Sums over the pictures of one program, for every colour of every block.
#[derive(Default)]
struct Means {
    sums: Vec<f64>,
    squares: Vec<f64>,
    count: f64,
}

impl Means {
    /// Adds a picture: rows of pixels with three components.
    fn add(&mut self, width: usize, components: &[f64]) {
        let rows = components.len() / (3 * width);
        let (across, down) = (width / BLOCK, rows / BLOCK);
        self.sums.resize(3 * across * down, 0.0);
        self.squares.resize(3 * across * down, 0.0);
        let mut means = vec![0.0; 3 * across * down];
        for (place, component) in components.iter().enumerate() {
            let (x, y) = (place / 3 % width, place / 3 / width);
            if x / BLOCK < across && y / BLOCK < down {
                let block = y / BLOCK * across + x / BLOCK;
                means[3 * block + place % 3] += component.clamp(0.0, 1.0) / (BLOCK * BLOCK) as f64;
            }
        }
        for (index, mean) in means.into_iter().enumerate() {
            self.sums[index] += mean;
            self.squares[index] += mean * mean;
        }
        self.count += 1.0;
    }

    /// The mean of a block, and the square of its standard error.
    fn of(&self, index: usize) -> (f64, f64) {
        let mean = self.sums[index] / self.count;
        let variance = (self.squares[index] / self.count - mean * mean).max(0.0);
        (mean, variance / (self.count - 1.0))
    }
}

/// The share of blocks whose means are within so many standard errors, after so many pictures each.
fn agreement(scene: &str, pictures: u64, errors: f64) -> f64 {
    // Scenes are read as for a picture of this shape.
    const WIDTH: usize = 64;
    const HEIGHT: usize = 48;
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/render").join(scene);
    let text = std::fs::read_to_string(&file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    let folder = tempfile::tempdir().unwrap();
    let (mut ours, mut theirs) = (Means::default(), Means::default());
    for number in 0..pictures {
        let options = RenderOptions { seed: number, ..RenderOptions::new(WIDTH as u32, HEIGHT as u32) };
        let image = picture(&text, &options).unwrap().image;
        let components = image.pixels.iter().flat_map(|pixel| pixel[..3].iter().map(|&c| f64::from(c)));
        ours.add(WIDTH, &components.collect::<Vec<_>>());
        // Other blocks take POV-Ray's random numbers in another order.
        let output = folder.path().join("theirs.ppm");
        let run = Command::new("povray")
            .args([format!("+I{}", file.display()), format!("+O{}", output.display())])
            .args([format!("+W{WIDTH}"), format!("+H{HEIGHT}"), format!("+BS{}", 4 + number)])
            .args(["+FP16", "File_Gamma=1.0", "-D", "-A", "-J", "+WT2"])
            .output()
            .unwrap_or_else(|error| panic!("povray: {error}"));
        assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
        let theirs_now = image::open(&output).unwrap().into_rgb16();
        let components: Vec<f64> = theirs_now.iter().map(|&c| f64::from(c) / 65535.0).collect();
        theirs.add(WIDTH, &components);
    }
    let near = |&index: &usize| {
        let ((a, va), (b, vb)) = (ours.of(index), theirs.of(index));
        // Sixteen bits and single precision are the least error.
        (a - b).abs() <= errors * (va + vb).sqrt() + 2e-5
    };
    let blocks = ours.sums.len();
    (0..blocks).filter(near).count() as f64 / blocks as f64
}

#[test]
fn random_media_come_near_povrays_mean() {
    // Standard errors of so few pictures are uncertain themselves.
    let share = agreement("media/random.pov", 8, 4.0);
    assert!(share >= 0.98, "{share}");
}

#[test]
#[ignore = "takes POV-Ray two minutes"]
fn random_pictures_come_to_povrays_mean() {
    for scene in ["media/random.pov", "light/jittered-area-light.pov", "atmosphere/jittered-rainbow.pov"] {
        let share = agreement(scene, 64, 3.0);
        println!("{scene}: {:.2} % of the blocks agree", 100.0 * share);
        assert!(share >= 0.99, "{scene}: {share}");
    }
}
