//! The language, word by word: what povista makes of each word that POV-Ray reserves.
//!
//! The text is made of the interpreter's own table of words, of the remarks here, and of what `compile` says to small
//! scenes, so that it tells what this povista does. `docs/language.md` holds it; a test compares.

mod remark;

use crate::compile;
use crate::diag::Collect;
use crate::interp::{self, Word};
use crate::options::{LanguageOptions, RenderOptions};
use crate::source::{Library, Source, Sources};
use crate::syntax::DIRECTIVES;
use remark::{DIFFERENT, FEATURES, Feature, IDLE};
use std::fmt::Write as _;

/// What povista makes of a word.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Status {
    /// The same as POV-Ray.
    Supported,
    /// Something else than POV-Ray, on purpose.
    Different(&'static str),
    /// It is read, but a scene that needs it isn't rendered: the feature that is missing.
    NotYet(&'static str),
    /// It is reserved, and means nothing, here or there.
    Idle,
}

/// Every reserved word in alphabetical order.
pub fn words() -> Vec<(&'static str, Status)> {
    let missing: Vec<&Feature> = FEATURES.iter().filter(|feature| is_missing(feature)).collect();
    let status = |word: &'static str| {
        if let Some(feature) = missing.iter().find(|feature| feature.words.contains(&word)) {
            return Status::NotYet(feature.name);
        }
        if IDLE.contains(&word) {
            return Status::Idle;
        }
        DIFFERENT
            .iter()
            .find(|(other, _)| *other == word)
            .map_or(Status::Supported, |&(_, remark)| Status::Different(remark))
    };
    let mut words: Vec<(&str, Status)> = Word::spellings().map(|word| (word, status(word))).collect();
    words.sort_by_key(|(word, _)| *word);
    words
}

/// Whether a scene that uses a feature is refused for it.
fn is_missing(feature: &Feature) -> bool {
    let mut sources = Sources::new(Library::default());
    let main = sources.add(Source::new(feature.name, "", feature.scene.into()));
    let scene = interp::interpret(main, &mut sources, &LanguageOptions::default(), &mut Collect::default());
    // A scene that is not even read is missing more than the feature; the tests see to it that there is none.
    scene.is_none_or(|scene| !compile::compile(scene, &RenderOptions::new(8, 8)).unsupported.is_empty())
}

/// The page as Markdown.
pub fn page() -> String {
    let words = words();
    let count = |fits: fn(&Status) -> bool| words.iter().filter(|(_, status)| fits(status)).count();
    let mut page = format!(
        "# The language, word by word\n\n\
         Every word that POV-Ray 3.7 reserves, and what povista makes of it. Made by `povista` itself; do not edit:\n\
         `UPDATE_DOCS=1 cargo test --test reference` writes it anew.\n\n\
         | | words |\n| --- | --- |\n\
         | the same as in POV-Ray | {} |\n| different, for the reason given | {} |\n\
         | not yet: a scene that needs it is refused, by name and place | {} |\n| reserved, but means nothing | {} |\n\n",
        count(|status| *status == Status::Supported),
        count(|status| matches!(status, Status::Different(_))),
        count(|status| matches!(status, Status::NotYet(_))),
        count(|status| *status == Status::Idle),
    );
    let directives: Vec<String> = DIRECTIVES.iter().map(|(word, _)| format!("`#{word}`")).collect();
    let _ = writeln!(page, "After a `#` these are directives: {}.\n", directives.join(", "));
    page.push_str("| word | povista | |\n| --- | --- | --- |\n");
    for (word, status) in &words {
        let (status, remark) = match status {
            Status::Supported => ("supported", String::new()),
            Status::Different(remark) => ("different", (*remark).to_owned()),
            Status::NotYet(feature) => ("not yet", (*feature).to_owned()),
            Status::Idle => ("reserved", "means nothing in POV-Ray 3.7 either".to_owned()),
        };
        let _ = writeln!(page, "| `{word}` | {status} | {remark} |");
    }
    page
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::Severity;

    #[test]
    fn every_remark_is_about_a_reserved_word() {
        let known: Vec<&str> = Word::spellings().collect();
        let remarked = DIFFERENT.iter().map(|(word, _)| word);
        for word in remarked.chain(IDLE).chain(FEATURES.iter().flat_map(|feature| feature.words)) {
            assert!(known.contains(word), "`{word}` is not reserved");
        }
    }

    #[test]
    fn the_scenes_of_features_are_read_and_use_their_words() {
        for feature in FEATURES {
            let mut sources = Sources::new(Library::default());
            let main = sources.add(Source::new(feature.name, "", feature.scene.into()));
            let mut sink = Collect::default();
            let scene = interp::interpret(main, &mut sources, &LanguageOptions::default(), &mut sink);
            let errors: Vec<_> = sink.diagnostics.iter().filter(|d| d.severity == Severity::Error).collect();
            assert!(scene.is_some(), "{}: {errors:?}", feature.name);
            for word in feature.words {
                let found = feature
                    .scene
                    .split(|c: char| !c.is_ascii_alphanumeric() && c != '_')
                    .any(|other| other == *word);
                assert!(found, "`{word}` is not in the scene of {}", feature.name);
            }
        }
    }
}
