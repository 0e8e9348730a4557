//! How time and memory grow with a scene: `cargo bench --bench scaling [-- KIND…]`.
//!
//! Scenes of 10² to 10⁶ things of a kind (`POVISTA_MOST=7` goes to 10⁷), each stage's time, the most
//! memory taken, and the exponent n^e that fits each stage best; POV-Ray beside it as long as it takes
//! less than a minute. Leaves `benches/results/scaling.csv`.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::time::{Duration, Instant};

/// What grows.
#[derive(Clone, Copy)]
struct Kind {
    name: &'static str,
    /// The scene with so many of them.
    scene: fn(usize) -> String,
    /// The picture's width, height and the number of threads.
    picture: fn(usize) -> (usize, usize, usize),
    /// Powers of ten, the greatest last.
    sizes: [u32; 2],
}

const STAGE: &str = "#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0.5, 0.5, -1.6> look_at 0.5 right x*image_width/image_height angle 45 }
light_source { <5, 9, -9> rgb 1 }
background { rgb 0.1 }
#declare R = seed(1);
";

const KINDS: [Kind; 7] = [
    Kind { name: "spheres", scene: spheres, picture: small, sizes: [2, 6] },
    Kind { name: "triangles", scene: triangles, picture: small, sizes: [2, 6] },
    Kind { name: "cutters", scene: cutters, picture: small, sizes: [2, 5] },
    Kind { name: "turns", scene: turns, picture: small, sizes: [2, 6] },
    Kind { name: "lights", scene: lights, picture: small, sizes: [1, 3] },
    Kind { name: "pixels", scene: |_| spheres(1000), picture: square, sizes: [2, 6] },
    Kind { name: "threads", scene: |_| spheres(10_000), picture: threads, sizes: [0, 0] },
];

fn small(_: usize) -> (usize, usize, usize) {
    (200, 150, 1)
}

fn square(pixels: usize) -> (usize, usize, usize) {
    let edge = (pixels as f64).sqrt().round() as usize;
    (edge, edge, 1)
}

fn threads(threads: usize) -> (usize, usize, usize) {
    (640, 480, threads)
}

/// Balls in a cube, as large as leaves it half empty to the eye.
fn spheres(count: usize) -> String {
    let radius = 0.4 / (count as f64).cbrt();
    format!(
        "{STAGE}#for (I, 1, {count}) sphere {{ <rand(R), rand(R), rand(R)>, {radius} pigment {{ rgb <rand(R), 0.5, 0.5> }} }} #end\n"
    )
}

/// A wavy sheet, its numbers written out.
fn triangles(count: usize) -> String {
    let edge = ((count as f64 / 2.0).sqrt().ceil() as usize).max(1);
    let mut text = format!("{STAGE}mesh2 {{ vertex_vectors {{ {}", (edge + 1) * (edge + 1));
    for (x, z) in (0..=edge).flat_map(|z| (0..=edge).map(move |x| (x, z))) {
        let (x, z) = (x as f64 / edge as f64, z as f64 / edge as f64);
        let y = 0.4 + 0.1 * (17.0 * x).sin() * (13.0 * z).cos();
        let _ = write!(text, ",\n<{x:.6}, {y:.6}, {z:.6}>");
    }
    let _ = write!(text, " }} face_indices {{ {}", 2 * edge * edge);
    for (x, z) in (0..edge).flat_map(|z| (0..edge).map(move |x| (x, z))) {
        let a = z * (edge + 1) + x;
        let (b, c, d) = (a + 1, a + edge + 1, a + edge + 2);
        let _ = write!(text, ",\n<{a}, {b}, {d}>, <{a}, {d}, {c}>");
    }
    text + " } pigment { rgb <0.8, 0.6, 0.4> } }\n"
}

/// A block with holes.
fn cutters(count: usize) -> String {
    let radius = 0.3 / (count as f64).sqrt();
    format!(
        "{STAGE}difference {{ box {{ 0, 1 }} #for (I, 1, {count}) sphere {{ <rand(R), rand(R), 0.3*rand(R)>, {radius} }} #end pigment {{ rgb <0.5, 0.7, 0.9> }} }}\n"
    )
}

/// A loop that makes nothing.
fn turns(count: usize) -> String {
    format!(
        "{STAGE}#declare I = 0; #declare S = 0;\n#while (I < {count})\n #declare S = S + sin(I)*rand(R);\n #declare I = I + 1;\n#end\nsphere {{ 0.5, 0.3 pigment {{ rgb 1 }} }}\n"
    )
}

/// Lights over a few balls.
fn lights(count: usize) -> String {
    format!(
        "{STAGE}#for (I, 1, 20) sphere {{ <rand(R), rand(R), rand(R)>, 0.12 pigment {{ rgb 0.7 }} }} #end\n#for (I, 1, {count}) light_source {{ 6*<rand(R) - 0.5, rand(R), -rand(R)> rgb 1/{count} }} #end\n"
    )
}

/// Seconds of reading, building and rendering, and the most memory in MiB.
#[derive(Clone, Copy)]
struct Cost {
    stages: [f64; 3],
    memory: f64,
    whole: Duration,
}

/// Runs a program and watches its memory.
fn run(command: &mut Command) -> Option<(String, f64, Duration)> {
    let start = Instant::now();
    let mut child = command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped()).spawn().ok()?;
    let mut pipe = child.stderr.take()?;
    let reader = std::thread::spawn(move || {
        let mut text = Vec::new();
        let _ = std::io::Read::read_to_end(&mut pipe, &mut text);
        String::from_utf8_lossy(&text).into_owned()
    });
    let status = PathBuf::from(format!("/proc/{}/status", child.id()));
    let mut most = 0.0_f64;
    let ended = loop {
        let now = std::fs::read_to_string(&status).unwrap_or_default();
        let kilobytes =
            now.lines().find_map(|line| line.strip_prefix("VmHWM:")?.split_whitespace().next()?.parse().ok());
        most = most.max(kilobytes.unwrap_or(0.0));
        if let Some(ended) = child.try_wait().ok()? {
            break ended;
        }
        std::thread::sleep(Duration::from_millis(2));
    };
    let said = reader.join().ok()?;
    ended.success().then_some((said, most / 1024.0, start.elapsed()))
}

/// The number before ` s` after a word of povista's summary.
fn stage(said: &str, name: &str) -> Option<f64> {
    said.split_once(&format!("{name} "))?.1.split_whitespace().next()?.parse().ok()
}

/// The processor seconds of a stage of POV-Ray's, below `Parse Time:` and its kin.
fn their_stage(said: &str, name: &str) -> Option<f64> {
    let (_, rest) = said.split_once(name)?;
    let (before, _) = rest.split_once(" CPU-seconds")?;
    before.rsplit(' ').next()?.parse().ok()
}

fn ours(scene: &Path, (width, height, threads): (usize, usize, usize)) -> Option<Cost> {
    let picture = scene.with_extension("png");
    let (said, memory, whole) = run(Command::new(env!("CARGO_BIN_EXE_povista"))
        .arg(scene)
        .args(["--size", &format!("{width}x{height}"), "--threads", &threads.to_string()])
        .args(["--max-turns", "1000000000", "-o"])
        .arg(picture))?;
    Some(Cost {
        stages: [stage(&said, "read")?, stage(&said, "compile")?, stage(&said, "render")?],
        memory,
        whole,
    })
}

fn theirs(scene: &Path, (width, height, threads): (usize, usize, usize)) -> Option<Cost> {
    let (said, memory, whole) = run(Command::new("povray")
        .arg(format!("+I{}", scene.display()))
        .arg(format!("+O{}", scene.with_extension("theirs.png").display()))
        .args([format!("+W{width}"), format!("+H{height}"), format!("+WT{threads}")])
        .args(["-D", "-A"]))?;
    let bounding = their_stage(&said, "Bounding Time:").unwrap_or(0.0);
    Some(Cost {
        stages: [their_stage(&said, "Parse Time:")?, bounding, their_stage(&said, "Trace Time:")?],
        memory,
        whole,
    })
}

/// The exponent of the line through the logarithms of what takes long enough to be measured.
fn exponent(points: &[(usize, f64)]) -> Option<f64> {
    let logs: Vec<(f64, f64)> =
        points.iter().filter(|(_, t)| *t >= 0.01).map(|(n, t)| ((*n as f64).ln(), t.ln())).collect();
    let count = logs.len() as f64;
    let mean = |f: fn(&(f64, f64)) -> f64| logs.iter().map(f).sum::<f64>() / count;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let above: f64 = logs.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    let below: f64 = logs.iter().map(|p| (p.0 - x).powi(2)).sum();
    (logs.len() > 1 && below > 0.0).then(|| above / below)
}

/// Measures a kind and adds its lines to the table.
fn measure(kind: &Kind, most: u32, folder: &Path, table: &mut String) -> std::io::Result<()> {
    let last = if kind.sizes[1] == 6 { most } else { kind.sizes[1] };
    let sizes: Vec<usize> = match kind.name {
        "threads" => vec![1, 2],
        _ => (kind.sizes[0]..=last).map(|power| 10_usize.pow(power)).collect(),
    };
    println!(
        "{}\n{:>10} {:<8} {:>9} {:>9} {:>9} {:>9}",
        kind.name, "", "", "read s", "build s", "trace s", "MiB"
    );
    for (name, program) in [("povista", ours as fn(&Path, _) -> Option<Cost>), ("POV-Ray", theirs)] {
        let mut costs: Vec<(usize, Cost)> = Vec::new();
        for &size in &sizes {
            let path = folder.join(format!("{}-{size}.pov", kind.name));
            std::fs::write(&path, (kind.scene)(size))?;
            let Some(cost) = program(&path, (kind.picture)(size)) else {
                println!("{size:>10} {name:<8} no picture");
                break;
            };
            let [read, build, trace] = cost.stages;
            println!("{size:>10} {name:<8} {read:>9.3} {build:>9.3} {trace:>9.3} {:>9.1}", cost.memory);
            let _ = writeln!(
                table,
                "{},{name},{size},{read:.4},{build:.4},{trace:.4},{:.1}",
                kind.name, cost.memory
            );
            costs.push((size, cost));
            if cost.whole > Duration::from_secs(60) {
                break;
            }
        }
        let fits = [0, 1, 2].map(|stage| {
            let points: Vec<(usize, f64)> = costs.iter().map(|(n, cost)| (*n, cost.stages[stage])).collect();
            exponent(&points).map_or_else(|| "-".to_owned(), |e| format!("n^{e:.2}"))
        });
        println!("{:>10} {name:<8} {:>9} {:>9} {:>9}", "", fits[0], fits[1], fits[2]);
    }
    Ok(())
}

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).filter(|word| !word.starts_with("--bench")).collect();
    // `cargo test --benches` only wants to know whether it starts.
    if words.iter().any(|word| word == "--test") {
        return ExitCode::SUCCESS;
    }
    let most = std::env::var("POVISTA_MOST").ok().and_then(|most| most.parse().ok()).unwrap_or(6);
    let mut table = "kind,program,size,read_s,build_s,trace_s,memory_mib\n".to_owned();
    let done = tempfile::tempdir().and_then(|folder| {
        for kind in KINDS.iter().filter(|kind| words.is_empty() || words.iter().any(|word| word == kind.name))
        {
            measure(kind, most, folder.path(), &mut table)?;
        }
        let results = Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/results");
        std::fs::create_dir_all(&results)?;
        std::fs::write(results.join("scaling.csv"), table)
    });
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("scaling: {error}");
            ExitCode::FAILURE
        }
    }
}
