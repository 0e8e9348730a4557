//! Patterns, pigments, normals, warps and images against what POV-Ray itself printed: every row of the
//! probe tables of docs/spec/patterns-textures.md is read as a scene, compiled and evaluated.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use povista::math::{DVec2, DVec3};
use povista::world::texture::Sample;

use super::{folder, pattern, pigment, texture};

/// One table: the text of its first header cell, the other header cells, and its rows.
struct Table {
    title: String,
    columns: Vec<String>,
    rows: Vec<Vec<String>>,
}

fn tables() -> Vec<Table> {
    let spec = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/spec/patterns-textures.md");
    let text = fs::read_to_string(spec).unwrap();
    let cells = |line: &str| -> Vec<String> {
        line.trim_matches('|').split(" | ").map(|cell| cell.trim().to_owned()).collect()
    };
    let mut tables: Vec<Table> = Vec::new();
    let mut inside = false;
    for line in text.lines() {
        match (line.starts_with('|'), inside) {
            (true, false) => {
                let mut header = cells(line);
                tables.push(Table { title: header.remove(0), columns: header, rows: Vec::new() });
            }
            (true, true) if !line.starts_with("|---") => tables.last_mut().unwrap().rows.push(cells(line)),
            _ => {}
        }
        inside = line.starts_with('|');
    }
    tables
}

/// The numbers in `<1,2,3>`; what is no number is 0.
fn point(cell: &str) -> [f64; 3] {
    let mut numbers = cell.trim_matches(['<', '>']).split(',').map(|n| n.trim().parse().unwrap_or(0.0));
    std::array::from_fn(|_| numbers.next().unwrap_or(0.0))
}

fn body(cell: &str) -> &str {
    cell.trim_matches('`')
}

/// Collects what differs, so that one run shows all of it.
#[derive(Default)]
struct Report {
    checked: usize,
    wrong: String,
}

impl Report {
    fn compare(&mut self, what: &str, at: &str, found: f64, expected: &str) {
        self.checked += 1;
        let decimals = expected.split_once('.').map_or(0, |(_, digits)| digits.len());
        let expected: f64 = expected.parse().unwrap();
        // Half a unit of the last printed digit, and what printing digits of a double costs.
        let tolerance = 0.51 * 0.1_f64.powi(decimals as i32) + expected.abs() * 4.0 * f64::EPSILON;
        if found.is_nan() || (found - expected).abs() > tolerance {
            writeln!(self.wrong, "`{what}` at {at} is {found}, not {expected}").unwrap();
        }
    }

    fn fail(&mut self, what: &str, error: &str) {
        writeln!(self.wrong, "`{what}`: {error}").unwrap();
    }

    /// `least` guards against a table that is no longer found.
    fn end(self, least: usize) {
        assert!(self.wrong.is_empty(), "{}", self.wrong);
        assert!(self.checked >= least, "only {} numbers were checked", self.checked);
    }
}

#[test]
fn patterns_have_povrays_values() {
    let folder = folder();
    let mut report = Report::default();
    for table in tables().iter().filter(|table| table.title.starts_with("pattern body")) {
        for row in &table.rows {
            match pattern(body(&row[0]), folder.path()) {
                Ok(function) => {
                    for (at, expected) in table.columns.iter().zip(&row[1..]) {
                        report.compare(&row[0], at, function.call(&point(at)), expected);
                    }
                }
                Err(error) => report.fail(&row[0], &error),
            }
        }
    }
    report.end(250);
}

#[test]
fn pigments_have_povrays_colours() {
    let folder = folder();
    let mut report = Report::default();
    for table in tables().iter().filter(|table| table.title.starts_with("pigment body")) {
        for row in &table.rows {
            match pigment(body(&row[0]), folder.path()) {
                Ok(function) => {
                    let mut color = [0.0; 5];
                    function.call_vector(&point(&row[1]), &mut color);
                    for (found, expected) in color.iter().zip(&row[2..]) {
                        report.compare(&row[0], &row[1], *found, expected);
                    }
                }
                Err(error) => report.fail(&row[0], &error),
            }
        }
    }
    report.end(180);
}

#[test]
fn tilings_and_pavements_have_povrays_values() {
    let folder = folder();
    let mut report = Report::default();
    for table in tables() {
        let to_body: fn(&str) -> String = match table.title.as_str() {
            "`tiling` number" => |number| format!("tiling {number}"),
            title if title.starts_with("sides, tiles") => |numbers| {
                let names = ["number_of_sides", "number_of_tiles", "pattern", "form", "interior", "exterior"];
                let parts = names.iter().zip(numbers.split(", ")).map(|(name, n)| format!("{name} {n} "));
                format!("pavement {}", parts.collect::<String>())
            },
            _ => continue,
        };
        for row in &table.rows {
            let body = format!("{} color_map{{[0 rgb 0][1 rgb 1]}}", to_body(&row[0]));
            match pigment(&body, folder.path()) {
                Ok(function) => {
                    for (at, expected) in table.columns.iter().zip(&row[1..]) {
                        report.compare(&body, at, function.call(&point(at)), expected);
                    }
                }
                Err(error) => report.fail(&body, &error),
            }
        }
    }
    report.end(141);
}

#[test]
fn warps_move_points_as_povrays() {
    const COORDINATES: [&str; 3] =
        ["", "matrix <0,1,0,1,0,0,0,0,1,0,0,0>", "matrix <0,0,1,0,1,0,1,0,0,0,0,0>"];
    let folder = folder();
    let mut report = Report::default();
    for table in tables().iter().filter(|table| table.title == "modifiers") {
        for row in &table.rows {
            for (coordinate, expected) in COORDINATES.iter().zip(&row[2..]) {
                let body = format!("marble ramp_wave frequency 0 {coordinate} {}", body(&row[0]));
                match pattern(&body, folder.path()) {
                    Ok(function) => report.compare(&body, &row[1], function.call(&point(&row[1])), expected),
                    Err(error) => report.fail(&body, &error),
                }
            }
        }
    }
    report.end(135);
}

/// Where the centre of pixel `(column,row)` is in a picture of `pixels`, `size` across.
fn pixel(cell: &str, pixels: [f64; 2], size: [f64; 2]) -> (f64, f64) {
    let numbers: Vec<f64> = cell.trim_matches(['(', ')']).split(',').map(|n| n.parse().unwrap()).collect();
    let x = ((numbers[0] + 0.5) / pixels[0] - 0.5) * size[0];
    let y = (0.5 - (numbers[1] + 0.5) / pixels[1]) * size[1];
    (x, y)
}

#[test]
fn normals_are_bent_as_povrays() {
    let folder = folder();
    let mut report = Report::default();
    for table in tables().iter().filter(|table| table.title == "`normal{…}`") {
        for row in &table.rows {
            let text = format!("plane{{-z,0 texture{{pigment{{rgb 1}} normal{{{}}}}}}}", body(&row[0]));
            let (x, y) = pixel(&row[1], [12.0, 9.0], [4.0, 3.0]);
            match texture(&text, folder.path()) {
                Ok(texture) => {
                    let mut sample =
                        Sample::on_surface(DVec3::new(x, y, 0.0), -DVec3::Z, DVec3::Z, DVec2::ZERO);
                    let bent = texture.layers().unwrap()[0].bend(&mut sample);
                    for (found, expected) in bent.to_array().iter().zip(&row[3..]) {
                        report.compare(&row[0], &row[1], *found, expected);
                    }
                }
                Err(error) => report.fail(&row[0], &error),
            }
        }
    }
    report.end(100);
}

#[test]
fn patterns_of_the_surface_have_povrays_values() {
    let folder = folder();
    let mut report = Report::default();
    let tables = tables();
    for row in tables.iter().filter(|table| table.title == "pigment").flat_map(|table| &table.rows) {
        let normal = if row[1] == "–" { "" } else { body(&row[1]) };
        let text = format!(
            "sphere{{0,3 texture{{pigment{{{} color_map{{[0 rgb 0][1 rgb 1]}}}} {normal}}}}}",
            body(&row[0])
        );
        let (x, y) = pixel(&row[2], [16.0, 12.0], [7.0, 5.25]);
        let hit = DVec3::new(x, y, -(9.0 - x * x - y * y).sqrt());
        match texture(&text, folder.path()) {
            Ok(texture) => {
                let mut sample = Sample::on_surface(hit, hit / 3.0, DVec3::Z, DVec2::ZERO);
                let layer = &texture.layers().unwrap()[0];
                layer.bend(&mut sample);
                let found = layer.paint.color(&sample).unwrap().rgb.x;
                // Colours are kept in single precision.
                let expected = format!("{:.7}", row[4].parse::<f32>().unwrap());
                report.compare(&row[0], &row[2], f64::from(found), &expected);
            }
            Err(error) => report.fail(&row[0], &error),
        }
    }
    report.end(16);
}
