//! A scene that writes numbers, read by both programs.

use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::thread;
use std::time::Duration;

use povista_compat::numbers::{FILE, printed};
use povista_compat::program::Program;

/// Processor seconds either program may use for a scene; povray takes a tenth of it.
const LIMIT: Duration = Duration::from_secs(200);

/// Points of three kinds in turn, as the body of a loop over I: a lattice that meets the edges of cells
/// exactly, a wide box, and two of a small box.
pub(crate) const MIXED: &str = "\
    #switch (mod(I, 4))\n\
    #case (0) #declare X = floor(rand(S)*49)/8 - 3; #declare Y = floor(rand(S)*49)/8 - 3; \
              #declare Z = floor(rand(S)*49)/8 - 3; #break\n\
    #case (1) #declare X = rand(S)*2000 - 1000; #declare Y = rand(S)*2000 - 1000; \
              #declare Z = rand(S)*2000 - 1000; #break\n\
    #else #declare X = rand(S)*20 - 10; #declare Y = rand(S)*20 - 10; #declare Z = rand(S)*20 - 10;\n\
    #end\n";

/// Points of a small and a wide box in turn.
pub(crate) const RANDOM: &str = "\
    #declare R = 20 + 1980*mod(I, 2);\n\
    #declare X = (rand(S) - 0.5)*R; #declare Y = (rand(S) - 0.5)*R; #declare Z = (rand(S) - 0.5)*R;\n";

/// A function, and which numbers of its result are compared.
pub(crate) struct Probe {
    /// What the table calls it.
    pub(crate) name: String,
    /// What stands between the braces of `function { … }`.
    pub(crate) function: String,
    /// What is written after a call: nothing, or members of a colour.
    pub(crate) members: &'static [&'static str],
    /// What the values were multiplied by before they wrapped at 1; 1 where they weren't.
    pub(crate) fold: f64,
}

/// How far a probe's numbers are from povray's.
pub(crate) struct Worst {
    /// The probe.
    pub(crate) name: String,
    /// The largest difference; infinite where one program has a number and the other none.
    pub(crate) error: f64,
    /// Where that is, and what povray and povista have there.
    detail: String,
}

/// Samples all `probes` at `count` points, each declared as X, Y, Z by `points`.
pub(crate) fn compare(probes: &[Probe], points: &str, count: usize) -> Vec<Worst> {
    let folder = tempfile::tempdir().unwrap();
    files(folder.path());
    let scene = scene(probes, points, count);
    let values = |program| printed(program, folder.path(), &scene, LIMIT).unwrap();
    let povray = Program::povray().unwrap_or_else(|error| panic!("{error}"));
    let povista = Program::povista().unwrap_or_else(|error| panic!("{error}"));
    let (ours, theirs) = thread::scope(|scope| {
        let theirs = scope.spawn(|| values(&povray));
        (values(&povista), theirs.join().unwrap())
    });
    let width = 3 + probes.iter().map(|probe| probe.members.len()).sum::<usize>();
    assert_eq!((theirs.len(), ours.len()), (width * count, width * count));
    let mut column = 3;
    probes
        .iter()
        .map(|probe| {
            let columns = column..column + probe.members.len();
            column = columns.end;
            let mut worst = Worst { name: probe.name.clone(), error: 0.0, detail: String::new() };
            for (theirs, ours) in theirs.chunks_exact(width).zip(ours.chunks_exact(width)) {
                assert_eq!(theirs[..3], ours[..3], "the points are the same");
                for (a, b) in theirs[columns.clone()].iter().zip(&ours[columns.clone()]) {
                    let error = difference(*a, *b, probe.fold);
                    if error > worst.error {
                        worst.error = error;
                        worst.detail = format!("{a} is {b} at {:?}", &theirs[..3]);
                    }
                }
            }
            worst
        })
        .collect()
}

/// How far `b` is from `a`, as numbers that wrap at 1 after having been multiplied by `fold`.
fn difference(a: f64, b: f64, fold: f64) -> f64 {
    if a == b || (a.is_nan() && b.is_nan()) {
        return 0.0;
    }
    let far = (a - b).abs();
    if far.is_nan() {
        return f64::INFINITY;
    }
    if fold == 1.0 { far } else { far.min(1.0 - far) / fold }
}

/// Prints the table and fails if an error is above `bound`.
pub(crate) fn judge(title: &str, table: &[Worst], bound: f64) {
    println!("{title}: largest difference of {} bodies, bound {bound:e}", table.len());
    for row in table {
        println!("  {:8.1e}  {}", row.error, row.name);
    }
    let wrong: Vec<_> = table.iter().filter(|row| row.error > bound).collect();
    let lines: String = wrong.iter().map(|row| format!("\n`{}`: {}", row.name, row.detail)).collect();
    assert!(
        wrong.is_empty(),
        "{} of {} bodies differ by more than {bound:e}:{lines}",
        wrong.len(),
        table.len()
    );
}

/// The bodies in a list, one a line.
pub(crate) fn bodies(list: &str) -> impl Iterator<Item = &str> {
    list.lines().filter(|line| !line.is_empty() && !line.starts_with('#'))
}

fn scene(probes: &[Probe], points: &str, count: usize) -> String {
    let mut text = "#version 3.7; global_settings { assumed_gamma 1 }\n".to_owned();
    for (n, probe) in probes.iter().enumerate() {
        writeln!(text, "#declare F{n} = function {{ {} }}", probe.function).unwrap();
    }
    write!(text, "#fopen Out \"{FILE}\" write\n#declare S = seed(7);\n#for (I, 1, {count})\n{points}")
        .unwrap();
    text.push_str("#write (Out, str(X,0,17), \" \", str(Y,0,17), \" \", str(Z,0,17), \"\\n\")\n");
    for (n, probe) in probes.iter().enumerate() {
        if let [member] = probe.members {
            writeln!(text, "#write (Out, str(F{n}(X,Y,Z){member},0,17), \"\\n\")").unwrap();
            continue;
        }
        writeln!(text, "#declare C = F{n}(X,Y,Z);").unwrap();
        for member in probe.members {
            writeln!(text, "#write (Out, str(C{member},0,17), \"\\n\")").unwrap();
        }
    }
    text.push_str("#end\n#fclose Out\n");
    text
}

/// Writes what the bodies refer to: an image, and densities of 8, 16 and 32 bits.
fn files(folder: &Path) {
    let ppm = "P3\n3 2\n255\n10 20 30  200 100 50  0 255 128\n77 88 99  5 250 125  60 60 61\n";
    fs::write(folder.join("probe.ppm"), ppm).unwrap();
    let blocks = [("eight", [3, 2, 4], 1), ("sixteen", [5, 6, 4], 2), ("thirtytwo", [4, 3, 7], 4)];
    let mut state = 1_u32;
    for (name, size, width) in blocks {
        let mut bytes: Vec<u8> = size.iter().flat_map(|side| [0, *side as u8]).collect();
        bytes.extend((0..size.iter().product::<usize>() * width).map(|_| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 24) as u8
        }));
        fs::write(folder.join(format!("{name}.df3")), bytes).unwrap();
    }
}
