//! The options of a run as they were given, by POV-Ray's names.
//!
//! INI files, switches and povista's own flags all write here, later ones over earlier ones;
//! `cli::job` then reads defaults and limits into it.

mod name;
pub mod value;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::path::PathBuf;

pub use name::{Kind, Name};

use crate::cli::Problem;
use crate::math::Gamma;
use crate::options::Declared;

/// Options that were given.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Settings {
    values: BTreeMap<Name, Value>,
    /// Options with a value that was found.
    found: BTreeSet<Name>,
    /// Whether what is given now was found: stands in a file that nobody named, and that may have come with a scene.
    pub finding: bool,
    /// Paths to search, in the order given, each once.
    pub library_paths: Vec<PathBuf>,
    /// Constants for the scene, in the order given.
    pub declares: Vec<(String, Declared)>,
}

/// A value of an option.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// On or off.
    Bool(bool),
    /// A whole number.
    Int(i32),
    /// A number.
    Float(f32),
    /// A path, a letter or any other text.
    Text(String),
    /// A transfer curve.
    Gamma(Gamma),
}

/// Ways to dither by POV-Ray's names.
pub const DITHER_METHODS: [&str; 6] = ["B2", "B3", "B4", "D1", "D2", "FS"];

/// Letters of file formats.
pub const FORMATS: [char; 8] = ['B', 'C', 'E', 'H', 'J', 'N', 'P', 'T'];

impl Settings {
    /// Gives an option a value, over any earlier one.
    pub fn set(&mut self, name: Name, value: Value) {
        self.values.insert(name, value);
        match self.finding {
            true => self.found.insert(name),
            false => self.found.remove(&name),
        };
    }

    /// Whether an option has its value from a file that nobody named.
    pub fn is_found(&self, name: Name) -> bool {
        self.found.contains(&name)
    }

    /// Reads a value as the option's kind asks and keeps it.
    ///
    /// # Errors
    /// The text isn't such a value. `IncludeIni` is left to the reader of INI files.
    pub fn read(&mut self, name: Name, text: &str) -> Result<(), Problem> {
        let wrong =
            |expected: &str| Problem::new(format!("`{}` needs {expected}, not `{text}`", name.as_str()));
        let value = match name.kind() {
            Kind::Bool => Value::Bool(value::truth(text)),
            Kind::Int => Value::Int(value::int(text).ok_or_else(|| wrong("a whole number"))?),
            Kind::Float => Value::Float(value::float(text).ok_or_else(|| wrong("a number"))?),
            Kind::Path | Kind::Text | Kind::Command | Kind::Obsolete => Value::Text(text.to_owned()),
            Kind::Format => Value::Text(format_letter(text).ok_or_else(|| format_problem(text))?.to_string()),
            Kind::Dither => {
                Value::Text(dither_method(text).ok_or_else(|| wrong("B2, B3, B4, D1, D2 or FS"))?)
            }
            Kind::Gamma => Value::Gamma(gamma(text).ok_or_else(|| wrong("`sRGB` or a number from 0.001"))?),
            Kind::Declare => return self.declare(text),
            Kind::LibraryPath | Kind::Ini => {
                self.add_library_path(text);
                return Ok(());
            }
        };
        self.set(name, value);
        Ok(())
    }

    /// Adds a path to those searched, unless it is among them.
    pub fn add_library_path(&mut self, path: &str) {
        let path = PathBuf::from(path);
        if !self.library_paths.contains(&path) {
            self.library_paths.push(path);
        }
    }

    /// Declares a constant: `name=number` or `name="text"`. What is declared first stays.
    ///
    /// Like POV-Ray, text that is no number counts as 0.
    ///
    /// # Errors
    /// There is no name.
    pub fn declare(&mut self, text: &str) -> Result<(), Problem> {
        let (name, number) = text.split_once('=').unwrap_or((text, ""));
        let (name, number) = (name.trim(), number.trim());
        if name.is_empty() {
            return Err(Problem::new(format!("`Declare` needs NAME=VALUE, not `{text}`")));
        }
        let declared = match value::quoted(number) {
            Some((text, _)) => Declared::Text(text.to_owned()),
            None => Declared::Number(value::six_digits(value::float(number).unwrap_or(0.0))),
        };
        if self.declares.iter().all(|(known, _)| known != name) {
            self.declares.push((name.to_owned(), declared));
        }
        Ok(())
    }

    /// The truth value of an option, if given.
    pub fn bool(&self, name: Name) -> Option<bool> {
        match self.values.get(&name)? {
            Value::Bool(truth) => Some(*truth),
            _ => None,
        }
    }

    /// The whole number of an option, if given.
    pub fn int(&self, name: Name) -> Option<i32> {
        match self.values.get(&name)? {
            Value::Int(number) => Some(*number),
            _ => None,
        }
    }

    /// The number of an option, if given.
    pub fn float(&self, name: Name) -> Option<f32> {
        match self.values.get(&name)? {
            Value::Float(number) => Some(*number),
            _ => None,
        }
    }

    /// The text of an option, if given.
    pub fn text(&self, name: Name) -> Option<&str> {
        match self.values.get(&name)? {
            Value::Text(text) => Some(text),
            _ => None,
        }
    }

    /// The curve of an option, if given.
    pub fn gamma(&self, name: Name) -> Option<Gamma> {
        match self.values.get(&name)? {
            Value::Gamma(gamma) => Some(*gamma),
            _ => None,
        }
    }
}

/// The letter of a format named by its first letter.
fn format_letter(text: &str) -> Option<char> {
    let letter = text.chars().next()?.to_ascii_uppercase();
    FORMATS.contains(&letter).then_some(letter)
}

/// Says which formats there are.
fn format_problem(text: &str) -> Problem {
    Problem::new(format!("there is no file format `{text}`"))
        .help("N is PNG, P is PPM, T and C are TGA, B is BMP, J is JPEG, H is HDR, E is EXR")
}

/// A way to dither, in capitals.
fn dither_method(text: &str) -> Option<String> {
    let method = text.to_ascii_uppercase();
    DITHER_METHODS.contains(&method.as_str()).then_some(method)
}

/// A transfer curve: `sRGB` or the exponent of a power law.
fn gamma(text: &str) -> Option<Gamma> {
    if text.eq_ignore_ascii_case("srgb") {
        return Some(Gamma::Srgb);
    }
    value::float(text).filter(|exponent| *exponent >= 0.001 && exponent.is_finite()).map(Gamma::Power)
}

/// An INI file with the options that were given.
impl fmt::Display for Settings {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (name, value) in &self.values {
            let quoted = name.kind() == Kind::Path;
            match value {
                Value::Bool(truth) => writeln!(f, "{}={}", name.as_str(), if *truth { "On" } else { "Off" })?,
                Value::Int(number) => writeln!(f, "{}={number}", name.as_str())?,
                Value::Float(number) => writeln!(f, "{}={}", name.as_str(), value::six_digits(*number))?,
                Value::Text(text) if quoted => writeln!(f, "{}=\"{text}\"", name.as_str())?,
                Value::Text(text) => writeln!(f, "{}={text}", name.as_str())?,
                Value::Gamma(Gamma::Srgb) => writeln!(f, "{}=sRGB", name.as_str())?,
                Value::Gamma(Gamma::Power(exponent)) => writeln!(f, "{}={exponent}", name.as_str())?,
            }
        }
        for (name, declared) in &self.declares {
            match declared {
                Declared::Number(number) => writeln!(f, "Declare={name}={number}")?,
                Declared::Text(text) => writeln!(f, "Declare={name}=\"{text}\"")?,
            }
        }
        for path in &self.library_paths {
            writeln!(f, "Library_Path=\"{}\"", path.display())?;
        }
        Ok(())
    }
}
