//! How seriously findings are taken.

use crate::diag::{Code, Diagnostic, Severity};

/// How seriously a finding is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// It is not told.
    Allow,
    /// It is a warning.
    Warn,
    /// It is an error.
    Deny,
}

/// The levels of codes: what was said last counts.
#[derive(Clone, Debug, Default)]
pub struct Levels {
    chosen: Vec<(Option<Code>, Level)>,
}

impl Levels {
    /// Chooses the level of a code, or with `None` that of whatever is no error by itself.
    pub fn set(&mut self, code: Option<Code>, level: Level) {
        self.chosen.push((code, level));
    }

    /// The level of a diagnostic, if one was chosen. What is an error by itself stays one.
    fn of(&self, diagnostic: &Diagnostic) -> Option<Level> {
        let fits = |code: &Option<Code>| code.is_none_or(|code| code == diagnostic.code);
        let chosen = self.chosen.iter().rev().find(|(code, _)| fits(code)).map(|&(_, level)| level);
        chosen.filter(|_| diagnostic.severity != Severity::Error)
    }

    /// The diagnostic as it is to be told, or nothing.
    pub fn apply(&self, mut diagnostic: Diagnostic) -> Option<Diagnostic> {
        match self.of(&diagnostic) {
            Some(Level::Allow) => return None,
            Some(Level::Deny) => diagnostic.severity = Severity::Error,
            Some(Level::Warn) | None => {}
        }
        Some(diagnostic)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_level_counts_and_errors_stay_errors() {
        let mut levels = Levels::default();
        levels.set(None, Level::Deny);
        levels.set(Some(Code::Unused), Level::Allow);
        let warning = Diagnostic::new(Severity::Warning, None, "a");
        let denied = levels.apply(warning.clone()).unwrap();
        assert_eq!((denied.severity, denied.code), (Severity::Error, Code::Warning));
        assert_eq!(levels.apply(warning.clone().code(Code::Unused)), None);
        levels.set(Some(Code::Unused), Level::Warn);
        assert_eq!(levels.apply(warning.code(Code::Unused)).unwrap().severity, Severity::Warning);
        levels.set(None, Level::Allow);
        assert!(levels.apply(Diagnostic::new(Severity::Error, None, "a")).is_some());
    }
}
