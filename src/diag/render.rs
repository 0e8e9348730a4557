//! Diagnostics as text: with colours and frames for people, the same without colour and of fixed
//! width for snapshots, as JSON for editors, and as the single line POV-Ray prints.

use super::{Diagnostic, Severity};
use crate::source::{Source, Sources, Span};
use miette::{
    GraphicalReportHandler, GraphicalTheme, LabeledSpan, MietteError, MietteSpanContents, SourceCode,
    SourceSpan, SpanContents,
};
use std::fmt::{self, Display, Write as _};
use std::sync::Arc;

/// Wide enough for a source line of an ordinary scene.
const PLAIN_WIDTH: usize = 100;

/// The report for a terminal, `width` columns wide, with colours.
pub fn graphical(diagnostic: &Diagnostic, sources: &Sources, width: usize) -> String {
    report(
        diagnostic,
        sources,
        GraphicalReportHandler::new_themed(GraphicalTheme::unicode()).with_width(width),
    )
}

/// The report without colour and of fixed width: the same on every machine.
pub fn plain(diagnostic: &Diagnostic, sources: &Sources) -> String {
    let theme = GraphicalTheme::unicode_nocolor();
    report(diagnostic, sources, GraphicalReportHandler::new_themed(theme).with_width(PLAIN_WIDTH))
}

/// The line POV-Ray's users know: `File 'NAME' line N: Parse Error: ...`, on one line.
pub fn line(diagnostic: &Diagnostic, sources: &Sources) -> String {
    let mut text = String::new();
    if let Some(span) = diagnostic.span {
        let source = sources.get(span.file);
        let _ = write!(text, "File '{}' line {}: ", source.name, source.position(span.start).0);
    }
    let kind = match diagnostic.severity {
        Severity::Error => "Parse Error",
        Severity::Possible => "Possible Parse Error",
        Severity::Warning => "Parse Warning",
    };
    let _ = write!(text, "{kind}: {}", diagnostic.message);
    text.replace(['\n', '\r'], " ")
}

/// One JSON object on one line.
pub fn json(diagnostic: &Diagnostic, sources: &Sources) -> String {
    let place = |span: Span| {
        let source = sources.get(span.file);
        let ((line, column), (end_line, end_column)) =
            (source.position(span.start), source.position(span.end));
        serde_json::json!({
            "file": source.name, "line": line, "column": column,
            "end_line": end_line, "end_column": end_column,
        })
    };
    let noted = |text: &str, span: Span| serde_json::json!({ "text": text, "at": place(span) });
    serde_json::json!({
        "severity": name(diagnostic.severity),
        "code": diagnostic.code.to_string(),
        "message": diagnostic.message,
        "at": diagnostic.span.map(place),
        "label": diagnostic.label,
        "labels": diagnostic.labels.iter().map(|l| noted(&l.text, l.span)).collect::<Vec<_>>(),
        "help": diagnostic.help,
        "trace": diagnostic.trace.iter().map(|s| noted(&s.what, s.span)).collect::<Vec<_>>(),
    })
    .to_string()
}

fn name(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Possible => "possible error",
        Severity::Warning => "warning",
    }
}

fn report(diagnostic: &Diagnostic, sources: &Sources, handler: GraphicalReportHandler) -> String {
    let handler = handler.with_context_lines(1).without_cause_chain();
    let mut text = String::new();
    // Writing to a string cannot fail, and a report cut short is better than none.
    let _ = handler.render_report(&mut text, &Report::new(diagnostic, sources));
    for step in &diagnostic.trace {
        let source = sources.get(step.span.file);
        let (line, column) = source.position(step.span.start);
        let _ = writeln!(text, "   in {}, from {}:{line}:{column}", step.what, source.name);
    }
    text
}

/// A file as miette shows it: of lines that are far too long only what is near the place.
#[derive(Debug)]
struct Excerpt {
    name: String,
    text: Arc<String>,
}

/// The longest line that is shown whole.
const LONGEST_LINE: usize = 240;
/// What is shown to both sides of a place in a longer one.
const NEAR: usize = 60;

impl SourceCode for Excerpt {
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        lines_before: usize,
        lines_after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let whole = self.text.read_span(span, lines_before, lines_after)?;
        let longest = whole.data().split(|&b| b == b'\n').map(<[u8]>::len).max();
        let (data, place, line, column) = if longest.unwrap_or(0) <= LONGEST_LINE {
            (whole.data(), *whole.span(), whole.line(), whole.column())
        } else {
            let (start, end) = (span.offset(), span.offset() + span.len());
            let line_start = self.text[..start].rfind('\n').map_or(0, |at| at + 1);
            let line_end = self.text[end..].find('\n').map_or(self.text.len(), |at| end + at);
            let from = self.text.floor_char_boundary(start.saturating_sub(NEAR)).max(line_start);
            let to = self.text.ceil_char_boundary(end + NEAR).min(line_end);
            let line = self.text[..from].matches('\n').count();
            (self.text[from..to].as_bytes(), (from, to - from).into(), line, from - line_start)
        };
        let name = self.name.clone();
        let count = data.split(|&b| b == b'\n').count();
        Ok(Box::new(MietteSpanContents::new_named(name, data, place, line, column, count)))
    }
}

/// What miette needs to know of a diagnostic.
#[derive(Debug)]
struct Report {
    /// `None` for a place of its own that only adds to another report.
    severity: Option<Severity>,
    message: String,
    help: Option<String>,
    code: Option<Excerpt>,
    labels: Vec<LabeledSpan>,
    related: Vec<Report>,
}

impl Report {
    fn new(diagnostic: &Diagnostic, sources: &Sources) -> Report {
        let main = diagnostic.span.map(|span| span.file);
        let code = |source: &Source| Excerpt { name: source.name.clone(), text: Arc::clone(source.text()) };
        let mut labels: Vec<LabeledSpan> = Vec::new();
        if let Some(span) = diagnostic.span {
            let text = if diagnostic.label.is_empty() { "here" } else { &diagnostic.label };
            labels.push(labeled(span, text, true));
        }
        // miette shows one file per report: places in other files become reports of their own.
        let mut related = Vec::new();
        for label in &diagnostic.labels {
            if Some(label.span.file) == main {
                labels.push(labeled(label.span, &label.text, false));
            } else {
                related.push(Report {
                    severity: None,
                    message: label.text.clone(),
                    help: None,
                    code: Some(code(sources.get(label.span.file))),
                    labels: vec![labeled(label.span, "here", true)],
                    related: Vec::new(),
                });
            }
        }
        Report {
            severity: Some(diagnostic.severity),
            message: diagnostic.message.clone(),
            help: diagnostic.help.clone(),
            code: main.map(|id| code(sources.get(id))),
            labels,
            related,
        }
    }
}

fn labeled(span: Span, text: &str, primary: bool) -> LabeledSpan {
    let range = span.start as usize..span.end as usize;
    if primary {
        LabeledSpan::new_primary_with_span(Some(text.to_owned()), range)
    } else {
        LabeledSpan::new_with_span(Some(text.to_owned()), range)
    }
}

impl Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Report {}

impl miette::Diagnostic for Report {
    fn severity(&self) -> Option<miette::Severity> {
        Some(match self.severity {
            Some(Severity::Error) => miette::Severity::Error,
            Some(Severity::Possible | Severity::Warning) => miette::Severity::Warning,
            None => miette::Severity::Advice,
        })
    }

    fn help<'a>(&'a self) -> Option<Box<dyn Display + 'a>> {
        self.help.as_ref().map(|help| Box::new(help) as Box<dyn Display>)
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.code.as_ref().map(|code| code as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        Some(Box::new(self.labels.iter().cloned()))
    }

    fn related<'a>(&'a self) -> Option<Box<dyn Iterator<Item = &'a dyn miette::Diagnostic> + 'a>> {
        if self.related.is_empty() {
            return None;
        }
        Some(Box::new(self.related.iter().map(|report| report as &dyn miette::Diagnostic)))
    }
}
