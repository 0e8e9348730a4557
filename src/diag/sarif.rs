//! Diagnostics as SARIF 2.1.0, the log that editors and the reviews of code hosts read.

use super::{Code, Diagnostic, Severity};
use crate::source::{Sources, Span};
use serde_json::{Value, json};

/// The name of the format's schema.
const SCHEMA: &str = "https://json.schemastore.org/sarif-2.1.0.json";

/// The log of one run: all its diagnostics. Columns count characters, from one.
pub fn sarif(diagnostics: &[Diagnostic], sources: &Sources) -> String {
    let rules: Vec<Value> = Code::all()
        .map(|code| {
            json!({ "id": code.to_string(), "name": code.name().replace("lint::", ""), "shortDescription": { "text": code.about() } })
        })
        .collect();
    let results: Vec<Value> = diagnostics.iter().map(|diagnostic| result(diagnostic, sources)).collect();
    let log = json!({
        "$schema": SCHEMA,
        "version": "2.1.0",
        "runs": [{
            "tool": { "driver": {
                "name": "povista",
                "version": env!("CARGO_PKG_VERSION"),
                "informationUri": "https://www.povray.org",
                "rules": rules,
            } },
            "columnKind": "unicodeCodePoints",
            "results": results,
        }],
    });
    format!("{log:#}")
}

fn result(diagnostic: &Diagnostic, sources: &Sources) -> Value {
    let level = if diagnostic.severity == Severity::Error { "error" } else { "warning" };
    let mut message = diagnostic.message.clone();
    if let Some(help) = &diagnostic.help {
        message = format!("{message}; {help}");
    }
    let mut result = json!({
        "ruleId": diagnostic.code.to_string(),
        "ruleIndex": diagnostic.code as usize,
        "level": level,
        "message": { "text": message },
        "locations": diagnostic.span.iter().map(|&span| location(span, None, sources)).collect::<Vec<_>>(),
    });
    let labels = diagnostic.labels.iter().map(|label| (label.span, label.text.clone()));
    let steps = diagnostic.trace.iter().map(|step| (step.span, format!("in {}, from here", step.what)));
    let related: Vec<Value> =
        labels.chain(steps).map(|(span, text)| location(span, Some(text), sources)).collect();
    if !related.is_empty() {
        result["relatedLocations"] = Value::Array(related);
    }
    result
}

fn location(span: Span, text: Option<String>, sources: &Sources) -> Value {
    let source = sources.get(span.file);
    let ((line, column), (end_line, end_column)) = (source.position(span.start), source.position(span.end));
    let name = if source.path.as_os_str().is_empty() {
        source.name.clone()
    } else {
        source.path.display().to_string()
    };
    let mut location = json!({
        "physicalLocation": {
            "artifactLocation": { "uri": uri(&name) },
            "region": {
                "startLine": line, "startColumn": column, "endLine": end_line, "endColumn": end_column,
            },
        },
    });
    if let Some(text) = text {
        location["message"] = json!({ "text": text });
    }
    location
}

/// A path as an address: absolute ones begin with `file://`, relative ones stay relative.
pub fn uri(path: &str) -> String {
    let mut uri = String::from(if path.starts_with('/') { "file://" } else { "" });
    for byte in path.replace('\\', "/").bytes() {
        if byte.is_ascii_alphanumeric() || b"-._~/".contains(&byte) {
            uri.push(char::from(byte));
        } else {
            uri.push_str(&format!("%{byte:02X}"));
        }
    }
    uri
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::{FileId, Library, Source};

    #[test]
    fn a_log_says_where_and_by_which_rule() {
        let mut sources = Sources::new(Library::default());
        let file = sources.add(Source::new("a b.pov", "", "box {\n  é Foo }".into()));
        let span = Span { file, start: 11, end: 14 };
        let diagnostic = Diagnostic::new(Severity::Warning, span, "`Foo` is odd")
            .code(Code::Unused)
            .help("remove it")
            .see(Span { file: FileId(0), start: 0, end: 3 }, "here");
        let log: Value = serde_json::from_str(&sarif(&[diagnostic], &sources)).unwrap();
        let result = &log["runs"][0]["results"][0];
        assert_eq!(result["message"]["text"], "`Foo` is odd; remove it");
        let place = &result["locations"][0]["physicalLocation"];
        assert_eq!(place["artifactLocation"]["uri"], "a%20b.pov");
        assert_eq!(
            place["region"],
            json!({ "startLine": 2, "startColumn": 5, "endLine": 2, "endColumn": 8 })
        );
        let rule = result["ruleIndex"].as_u64().unwrap() as usize;
        assert_eq!(log["runs"][0]["tool"]["driver"]["rules"][rule]["id"], result["ruleId"]);
        assert_eq!(result["relatedLocations"][0]["message"]["text"], "here");
    }
}
