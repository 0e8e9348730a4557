//! Reads probe tables and renders their scenes.
//!
//! A row is `| SDL | red green blue |`; SDL may use the abbreviations of docs/spec/shading.md 1 and be
//! followed by a note such as `— #version 3.6`.

use std::fs;
use std::path::Path;

use povista::compile;
use povista::diag::{Collect, plain};
use povista::interp::interpret;
use povista::options::{LanguageOptions, RenderOptions};
use povista::render::{Rendered, render};
use povista::source::{Library, Source, Sources};

/// One probe: a scene and what POV-Ray showed.
#[derive(Debug)]
pub(crate) struct Row {
    /// The scene as the table has it.
    pub(crate) sdl: String,
    /// `#version` of the scene.
    pub(crate) version: String,
    /// Three numbers.
    pub(crate) observed: [f64; 3],
    /// Whether the numbers are a direction, stored as colours by `DIRSKY`.
    pub(crate) direction: bool,
}

/// How far a 16-bit sample may be off: half a step of each rounding and the single precision of both.
const STEP: f64 = 2.5e-5;

/// Rows that are directions have four decimals.
const DIRECTION: f64 = 1.6e-4;

const DIRSKY: &str = "#declare F=function(x,y,z){x*0.5+0.5};
sky_sphere{pigment{average pigment_map{
[1 function{F(x,y,z)} color_map{[0 rgb 0][1 rgb <3,0,0>]}]
[1 function{F(y,y,z)} color_map{[0 rgb 0][1 rgb <0,3,0>]}]
[1 function{F(z,y,z)} color_map{[0 rgb 0][1 rgb <0,0,3>]}] }}}";

/// The rows of all tables in a section of a chapter of the specification.
pub(crate) fn rows(file: &str, section: &str) -> Vec<Row> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let start = format!("## {section}. ");
    let lines = text.lines().skip_while(|line| !line.starts_with(&start)).skip(1);
    let mut direction = false;
    let mut rows = Vec::new();
    for line in lines.take_while(|line| !line.starts_with("## ")) {
        if line.contains("| observed") {
            direction = line.contains("direction");
        }
        rows.extend(row(line, direction));
    }
    rows
}

fn row(line: &str, direction: bool) -> Option<Row> {
    let line = line.strip_prefix("| `")?;
    let (sdl, rest) = line.split_once('`')?;
    let (note, values) = rest.split_once('|')?;
    let version = note.split_once("#version ").map_or("3.7", |(_, version)| version.trim());
    let numbers: Vec<f64> =
        values.trim_end_matches([' ', '|']).split_whitespace().map_while(|n| n.parse().ok()).collect();
    let observed = numbers.try_into().ok()?;
    Some(Row { sdl: sdl.to_owned(), version: version.to_owned(), observed, direction })
}

/// Renders every row and reports all that differ from what was observed.
pub(crate) fn assert_rows(rows: &[Row]) {
    let wrong: Vec<String> = rows.iter().filter_map(difference).collect();
    assert!(wrong.is_empty(), "{} of {} rows:\n{}", wrong.len(), rows.len(), wrong.join("\n"));
}

fn difference(row: &Row) -> Option<String> {
    let ours = match pixel(&scene(&row.sdl, &row.version)) {
        Ok(color) => color,
        Err(report) => return Some(format!("{}\n    {report}", row.sdl)),
    };
    let (ours, tolerance) = if row.direction {
        (ours.map(|c| 2.0 * c - 1.0), DIRECTION)
    } else {
        (ours.map(|c| c.clamp(0.0, 1.0)), STEP)
    };
    let off = ours.iter().zip(row.observed).any(|(ours, observed)| (ours - observed).abs() > tolerance);
    off.then(|| format!("{}\n    observed {:?}\n    rendered {ours:?}", row.sdl, row.observed))
}

/// The whole scene of a row.
pub(crate) fn scene(sdl: &str, version: &str) -> String {
    let mut text = sdl.to_owned();
    let wall = "plane{-z,-5 ";
    for (short, long) in
        [("TILTIN(", "plane{<-1,0,1>,3.5355339 "), ("TILT(", "plane{<1,0,-1>,-3.5355339 "), ("WALL(", wall)]
    {
        text = expand(&text, short, |inside| format!("{long}{inside}}}"));
    }
    text = expand(&text, "AT(", |place| {
        format!("camera{{orthographic location <{place},0> direction z right x*1e-6 up y*1e-6}}")
    });
    for (short, long) in [
        ("DIRSKY", DIRSKY),
        ("FLOOR", "plane{-z,-5 pigment{rgb 1} finish{ambient 0 diffuse 1}}"),
        ("BG", "background{rgb <.2,.6,.9>}"),
        ("SKY", "sky_sphere{pigment{rgb <.2,.6,.9>}}"),
    ] {
        text = text.replace(short, long);
    }
    let camera = if text.contains("camera") { "" } else { "camera{}\n" };
    format!("#version {version};\nglobal_settings{{assumed_gamma 1}}\n{camera}{text}\n")
}

/// Replaces every `name(inside)` with what `long` makes of the inside; brackets nest.
fn expand(text: &str, name: &str, long: impl Fn(&str) -> String) -> String {
    let mut result = String::new();
    let mut rest = text;
    while let Some((before, after)) = rest.split_once(name) {
        let mut depth = 1;
        let end = after.find(|c| {
            depth += match c {
                '(' => 1,
                ')' => -1,
                _ => 0,
            };
            depth == 0
        });
        let end = end.unwrap_or(after.len());
        result += before;
        result += &long(&after[..end]);
        rest = after.get(end + 1..).unwrap_or("");
    }
    result + rest
}

/// The colour of the only pixel, or what was said against the scene.
fn pixel(text: &str) -> Result<[f64; 3], String> {
    let [r, g, b, _] = picture(text, &RenderOptions::new(1, 1))?.image.pixels[0];
    Ok([r, g, b].map(f64::from))
}

/// A scene rendered, or what was said against it.
pub(crate) fn picture(text: &str, options: &RenderOptions) -> Result<Rendered, String> {
    let mut sources = Sources::new(Library::default());
    let main = sources.add(Source::new("probe.pov", "", text.into()));
    let mut sink = Collect::default();
    let scene = interpret(main, &mut sources, &LanguageOptions::default(), &mut sink).ok_or_else(|| {
        sink.diagnostics.iter().map(|diagnostic| plain(diagnostic, &sources)).collect::<String>()
    })?;
    let compiled = compile::compile(scene, options);
    if !compiled.unsupported.is_empty() {
        return Err(compiled.unsupported.iter().map(ToString::to_string).collect::<Vec<_>>().join("; "));
    }
    Ok(render(&compiled.world, options, &()))
}

/// The rgb of a scene's only pixel, with the options' alpha.
pub(crate) fn assert_pixel(
    sdl: &str,
    version: &str,
    options: &RenderOptions,
    observed: &[f32],
    tolerance: f32,
) {
    let rendered = picture(&scene(sdl, version), options).unwrap_or_else(|report| panic!("{sdl}\n{report}"));
    let ours = rendered.image.pixels[0];
    let close = observed
        .iter()
        .zip(ours)
        .all(|(observed, ours)| (observed - ours.clamp(0.0, 1.0)).abs() <= tolerance);
    assert!(close, "{sdl} (version {version}): rendered {ours:?}, observed {observed:?}");
}
