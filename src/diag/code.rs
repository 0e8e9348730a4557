//! What diagnostics are about, by names that stay, to switch them on and off.

use super::Severity;
use std::fmt;

/// What a diagnostic is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[expect(missing_docs, reason = "each is explained in `Code::about`")]
pub enum Code {
    Error,
    PossibleError,
    Warning,
    Unused,
    Shadowed,
    ReservedLooking,
    MissingVersion,
    MissingSemicolon,
    Deprecated,
    OverwrittenDefault,
    CameraInside,
    LightInside,
    MissingMaxGradient,
}

/// Every code with its name and what it is about, in the order of the enum.
const CODES: &[(Code, &str, &str)] = &[
    (Code::Error, "error", "The scene cannot be rendered."),
    (Code::PossibleError, "possible_error", "Probably a mistake, but the scene is still read."),
    (Code::Warning, "warning", "The scene is understood, but perhaps not as it was meant."),
    (Code::Unused, "lint::unused", "A name, a macro or a parameter that nothing uses."),
    (Code::Shadowed, "lint::shadowed", "A local name or a parameter that hides one of the scene's."),
    (Code::ReservedLooking, "lint::reserved_looking", "A name that is easily taken for a reserved word."),
    (Code::MissingVersion, "lint::missing_version", "The scene does not begin with its `#version`."),
    (Code::MissingSemicolon, "lint::missing_semicolon", "A directive without the `;` at its end."),
    (Code::Deprecated, "lint::deprecated", "An old spelling, or a name its author wants to be rid of."),
    (
        Code::OverwrittenDefault,
        "lint::overwritten_default",
        "A `#default` that another replaces before it had an effect.",
    ),
    (Code::CameraInside, "lint::camera_inside", "The camera is inside of an opaque object without a light."),
    (Code::LightInside, "lint::light_inside", "A light is shut into an opaque object."),
    (
        Code::MissingMaxGradient,
        "lint::missing_max_gradient",
        "An isosurface without a `max_gradient` of its own.",
    ),
];

impl Code {
    /// Every code.
    pub fn all() -> impl Iterator<Item = Code> {
        CODES.iter().map(|&(code, ..)| code)
    }

    /// Its name, such as `povista::lint::unused` without `povista::`.
    pub fn name(self) -> &'static str {
        CODES[self as usize].1
    }

    /// One sentence about what it stands for.
    pub fn about(self) -> &'static str {
        CODES[self as usize].2
    }

    /// Whether it can be switched on and off, and isn't just how bad something is.
    pub fn is_lint(self) -> bool {
        self.name().starts_with("lint::")
    }

    /// The code with a name; `povista::` and `lint::` may be left out, and `-` stands for `_`.
    pub fn find(name: &str) -> Option<Code> {
        let name = name.trim_start_matches("povista::").replace('-', "_");
        CODES
            .iter()
            .find(|(_, known, _)| *known == name || known.strip_prefix("lint::") == Some(&name))
            .map(|row| row.0)
    }

    /// What is known of a diagnostic of which nothing else is.
    pub(super) fn of(severity: Severity) -> Code {
        match severity {
            Severity::Error => Code::Error,
            Severity::Possible => Code::PossibleError,
            Severity::Warning => Code::Warning,
        }
    }
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "povista::{}", self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_documentation_knows_every_lint() {
        let page = include_str!("../../docs/command-line.md");
        for code in Code::all().filter(|code| code.is_lint()) {
            let name = code.name().trim_start_matches("lint::");
            assert!(page.contains(&format!("| `{name}` |")), "{name}");
        }
    }

    #[test]
    fn codes_are_found_by_their_names_long_and_short() {
        for (index, code) in Code::all().enumerate() {
            assert_eq!((code as usize, Code::find(&code.to_string())), (index, Some(code)));
        }
        assert_eq!(Code::find("missing-version"), Some(Code::MissingVersion));
        assert_eq!(Code::find("lint::unused"), Some(Code::Unused));
        assert_eq!(Code::find("nonsense"), None);
    }
}
