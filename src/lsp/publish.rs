//! What is wrong, as the protocol tells it: for each file a list, which replaces the one before.

use super::analysis::Analysis;
use super::place;
use crate::diag::{self, Code, Severity};
use crate::source::Span;
use lsp_types::{
    Diagnostic, DiagnosticRelatedInformation, DiagnosticSeverity, DiagnosticTag, Location, NumberOrString,
    PublishDiagnosticsParams, Range, Uri,
};
use std::collections::{BTreeMap, BTreeSet};

/// What was told, by the document it was found in and the file it is told of.
#[derive(Debug, Default)]
pub(super) struct Published {
    told: BTreeMap<String, BTreeMap<String, Vec<Diagnostic>>>,
}

impl Published {
    /// Takes what was found in a document instead of what was found there before. Gives the files of which something
    /// else is to be told now; the document is always among them.
    pub(super) fn replace(&mut self, uri: &str, told: BTreeMap<String, Vec<Diagnostic>>) -> Vec<String> {
        let before = self.told.insert(uri.to_owned(), told).unwrap_or_default();
        let now = &self.told[uri];
        let files: BTreeSet<&String> = before.keys().chain(now.keys()).collect();
        files
            .into_iter()
            .filter(|file| *file == uri || before.get(*file) != now.get(*file))
            .cloned()
            .collect()
    }

    /// Forgets a document that was closed. Gives the files something was told of.
    pub(super) fn forget(&mut self, uri: &str) -> Vec<String> {
        self.told.remove(uri).into_iter().flat_map(BTreeMap::into_keys).collect()
    }

    /// All there is to tell of a file.
    pub(super) fn params(&self, uri: &str, version: Option<i32>) -> Option<PublishDiagnosticsParams> {
        let mut diagnostics: Vec<Diagnostic> =
            self.told.values().filter_map(|files| files.get(uri)).flatten().cloned().collect();
        // Two scenes may find the same in a file that both include.
        diagnostics.dedup();
        Some(PublishDiagnosticsParams { uri: uri.parse().ok()?, diagnostics, version })
    }
}

/// What is to be told of each file, the document itself always among them.
pub(super) fn diagnostics(uri: &str, analysis: &Analysis) -> BTreeMap<String, Vec<Diagnostic>> {
    let mut told = BTreeMap::from([(uri.to_owned(), Vec::new())]);
    let Ok(main) = uri.parse::<Uri>() else { return told };
    for diagnostic in &analysis.diagnostics {
        let file =
            diagnostic.span.and_then(|span| address(&main, analysis, span)).unwrap_or_else(|| main.clone());
        told.entry(file.as_str().to_owned()).or_default().push(translate(&main, analysis, diagnostic));
    }
    told
}

/// The address of the file of a span. What comes with povista itself has none.
fn address(main: &Uri, analysis: &Analysis, span: Span) -> Option<Uri> {
    if span.file == analysis.main {
        return Some(main.clone());
    }
    let source = analysis.sources.get(span.file);
    if source.path.as_os_str().is_empty() { None } else { place::uri(&source.path) }
}

fn translate(main: &Uri, analysis: &Analysis, diagnostic: &diag::Diagnostic) -> Diagnostic {
    let range = |span: Span| place::range(analysis.sources.get(span.file), span);
    let is_unused = diagnostic.code == Code::Unused;
    let severity = match diagnostic.severity {
        Severity::Error => DiagnosticSeverity::ERROR,
        _ if is_unused => DiagnosticSeverity::HINT,
        Severity::Possible | Severity::Warning => DiagnosticSeverity::WARNING,
    };
    let mut message = diagnostic.message.clone();
    for more in [Some(&diagnostic.label).filter(|label| !label.is_empty()), diagnostic.help.as_ref()]
        .into_iter()
        .flatten()
    {
        message = format!("{message}\n{more}");
    }
    let labels = diagnostic.labels.iter().map(|label| (label.span, label.text.clone()));
    let steps = diagnostic.trace.iter().map(|step| (step.span, format!("in {}, from here", step.what)));
    let related: Vec<DiagnosticRelatedInformation> = labels
        .chain(steps)
        .filter_map(|(span, message)| {
            let location = Location { uri: address(main, analysis, span)?, range: range(span) };
            Some(DiagnosticRelatedInformation { location, message })
        })
        .collect();
    // What comes with povista itself cannot be shown: it is told of the place it was included or called from.
    let place = diagnostic.span.filter(|span| address(main, analysis, *span).is_some());
    let place = place
        .or_else(|| diagnostic.trace.iter().map(|step| step.span).find(|span| span.file == analysis.main));
    Diagnostic {
        range: place.map_or_else(Range::default, range),
        severity: Some(severity),
        code: Some(NumberOrString::String(diagnostic.code.to_string())),
        source: Some("povista".to_owned()),
        message,
        related_information: (!related.is_empty()).then_some(related),
        tags: is_unused.then(|| vec![DiagnosticTag::UNNECESSARY]),
        ..Diagnostic::default()
    }
}
