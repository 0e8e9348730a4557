//! Scenes that nobody would write: pieces of installed ones, torn apart and put together again. Whatever
//! comes out is read and compiled in time, within memory, and without a panic.
//!
//! A run lasts a few seconds; `POVISTA_FUZZ_SECONDS` makes it longer, `POVISTA_FUZZ_SEED` starts another one.
//! The scene at hand is kept in `target/fuzz/scene.pov`, so that one that ends the process is known. What
//! longer runs took and found is in `tests/fuzz/log.txt`, and what they found in `tests/fuzz/found`.

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use std::time::{Duration, Instant};

use povista::compile::compile;
use povista::diag::Collect;
use povista::interp::interpret;
use povista::options::{LanguageOptions, RenderOptions};
use povista::source::{Library, Permissions, Source, Sources};

const INSTALLED: [&str; 2] = ["/usr/share/povray-3.7/include", "/usr/share/doc/povray/examples"];
/// Bytes of the longest file that is torn apart.
const LONGEST: u64 = 30_000;
/// How long one scene may take: the corpus takes a tenth of it, and the limits of scenes some more.
const SLOW: Duration = Duration::from_secs(10);
/// Bytes of memory a scene may take.
const MEMORY: u64 = 1 << 30;

/// Tokens that are likely to matter wherever they stand.
const SPICE: [&str; 56] = [
    "0",
    "-1",
    "1e400",
    "1e9",
    "-1e9",
    "0.5",
    "1e-300",
    "<0,0,0>",
    "<1,2,3,4,5>",
    "x",
    "\"\"",
    "\"a\\qb\"",
    "{",
    "}",
    "(",
    ")",
    "[",
    "]",
    "<",
    ">",
    ",",
    ";",
    ".",
    "#end",
    "#else",
    "#if(1)",
    "#while(1)",
    "#break",
    "#switch(1)",
    "#case(1)",
    "#macro M(A)",
    "M(M)",
    "#declare A=",
    "#local A=",
    "#undef A",
    "array[3]",
    "#for(I,1,3)",
    "function{x}",
    "function(x){",
    "sphere{0,1}",
    "union{",
    "mesh{",
    "texture{",
    "pigment{",
    "color_map{",
    "[0 rgb 1]",
    "scale 0",
    "inverse",
    "rgb",
    "-",
    "/",
    "?",
    ":",
    "#version 3.1;",
    "#default{",
    "/*",
];

/// Numbers that look random and are the same on every machine.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, count: usize) -> usize {
        (self.next() % count.max(1) as u64) as usize
    }
}

/// The texts to tear apart, split into tokens with the blanks that follow.
fn corpus() -> Vec<Vec<String>> {
    let mut folders: Vec<PathBuf> = INSTALLED.iter().map(PathBuf::from).collect();
    folders.push(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests"));
    let mut files = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).into_iter().flatten().flatten() {
            let path = entry.path();
            match path.extension().and_then(|extension| extension.to_str()) {
                _ if path.is_dir() => folders.push(path),
                Some("pov" | "inc") if path.metadata().is_ok_and(|file| file.len() < LONGEST) => {
                    files.push(path)
                }
                _ => {}
            }
        }
    }
    files.sort();
    files.iter().map(|file| tokens(&String::from_utf8_lossy(&fs::read(file).unwrap()))).collect()
}

fn tokens(text: &str) -> Vec<String> {
    let mut tokens: Vec<String> = Vec::new();
    let word = |c: char| c.is_alphanumeric() || c == '_' || c == '.' || c == '#';
    let mut before = ' ';
    for c in text.chars() {
        match tokens.last_mut() {
            Some(token) if c.is_whitespace() || (word(before) && word(c)) => token.push(c),
            _ => tokens.push(c.to_string()),
        }
        before = c;
    }
    tokens
}

/// A scene made of some of the corpus.
fn scene(corpus: &[Vec<String>], random: &mut Random) -> Vec<u8> {
    let mut text = corpus[random.below(corpus.len())].clone();
    let piece = |random: &mut Random, text: &[String]| {
        let start = random.below(text.len());
        let most = if random.below(8) == 0 { text.len() } else { 12 };
        let end = (start + 1 + random.below(most)).min(text.len());
        start..end.max(start)
    };
    for _ in 0..=random.below(10) {
        let range = piece(random, &text);
        let at = random.below(text.len() + 1);
        match random.below(8) {
            0 | 1 => drop(text.drain(range)),
            2 => {
                let copy = text[range].to_vec();
                let times = if random.below(50) == 0 { 300 } else { 1 };
                for _ in 0..times {
                    text.splice(at..at, copy.iter().cloned());
                }
            }
            3 => {
                let other = &corpus[random.below(corpus.len())];
                let range = piece(random, other);
                text.splice(at..at, other[range].iter().cloned());
            }
            4 => text.truncate(at),
            5 if range.len() > 1 => text.swap(range.start, range.end - 1),
            _ => {
                let spice = format!("{} ", SPICE[random.below(SPICE.len())]);
                text.splice(range.start..(range.start + random.below(2)).min(text.len()), [spice]);
            }
        }
        if text.is_empty() {
            text.push("#".to_owned());
        }
    }
    let mut bytes = text.concat().into_bytes();
    if random.below(20) == 0 && !bytes.is_empty() {
        for _ in 0..=random.below(5) {
            let at = random.below(bytes.len());
            bytes[at] = random.next() as u8;
        }
    }
    bytes
}

/// Reads a scene, and compiles it if there is one.
fn run(bytes: Vec<u8>) {
    let permissions = Permissions {
        read: Some(
            INSTALLED.iter().map(|folder| povista::source::Folder::new(Path::new(folder), true)).collect(),
        ),
        ..Permissions::write_only_in(Vec::new())
    };
    let paths = vec![INSTALLED[0].into()];
    let mut sources = Sources::new(Library { paths, permissions, ..Library::default() });
    let main = sources.add(Source::new("scene.pov", "", bytes));
    let options = LanguageOptions {
        image_width: 8,
        image_height: 6,
        max_steps: 100_000,
        max_memory: MEMORY,
        ..LanguageOptions::default()
    };
    if let Some(scene) = interpret(main, &mut sources, &options, &mut Collect::default()) {
        drop(compile(scene, &RenderOptions::new(8, 6)));
    }
}

/// What this thread has worked so far: it may stand behind others for long.
fn worked() -> Duration {
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    let told = fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = told.and_then(|text| text.split_whitespace().next()?.parse().ok());
    nanoseconds.map_or_else(|| START.elapsed(), Duration::from_nanos)
}

fn variable(name: &str, otherwise: u64) -> u64 {
    std::env::var(name).ok().and_then(|value| value.parse().ok()).unwrap_or(otherwise)
}

#[test]
fn no_scene_is_too_much() {
    let corpus = corpus();
    assert!(corpus.len() > 300, "install povray-examples and povray-includes");
    let seconds = variable("POVISTA_FUZZ_SECONDS", 5);
    let first = variable("POVISTA_FUZZ_SEED", 1);
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("target/fuzz");
    fs::create_dir_all(&folder).unwrap();
    let start = Instant::now();
    let mut bad = Vec::new();
    let mut seed = first;
    while start.elapsed() < Duration::from_secs(seconds) {
        let bytes = scene(&corpus, &mut Random(seed));
        fs::write(folder.join("scene.pov"), &bytes).unwrap();
        let begun = worked();
        let panicked = catch_unwind(AssertUnwindSafe(|| run(bytes.clone()))).is_err();
        let memory = memory_stats::memory_stats().map_or(0, |memory| memory.physical_mem as u64);
        let verdict = if panicked {
            "panics"
        } else if worked() - begun > SLOW {
            "is slow"
        } else if memory > 2 * MEMORY {
            "takes memory"
        } else {
            seed += 1;
            continue;
        };
        fs::write(folder.join(format!("{seed}.pov")), bytes).unwrap();
        println!("{seed}.pov {verdict}: {:?}, {} MB", worked() - begun, memory >> 20);
        bad.push(format!("{seed}.pov {verdict}"));
        seed += 1;
    }
    println!("{} scenes, seeds {first} to {}, {seconds} seconds", seed - first, seed - 1);
    assert!(bad.is_empty(), "{} of them, in {}:\n{}", bad.len(), folder.display(), bad.join("\n"));
}

/// Found by longer runs.
#[test]
fn what_was_found_does_no_harm_any_more() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fuzz/found");
    for entry in fs::read_dir(folder).into_iter().flatten() {
        let path = entry.unwrap().path();
        let begun = worked();
        run(fs::read(&path).unwrap());
        assert!(worked() - begun < SLOW, "{} is slow", path.display());
    }
}
