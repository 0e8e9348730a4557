//! What an editor asks about a document.

use super::analysis::Analysis;
use super::{Server, complete, place};
use crate::fmt;
use crate::index::{Declaration, Kind};
use crate::interp::Word;
use crate::source::{FileId, Source, Span};
use crate::syntax::{Directive, NodeKind, Punct, Symbol};
use lsp_server::Request;
use lsp_types::request::{
    Completion, DocumentSymbolRequest, Formatting, GotoDefinition, HoverRequest, Request as _,
};
use lsp_types::{
    CompletionParams, DocumentFormattingParams, DocumentSymbol, DocumentSymbolParams, GotoDefinitionParams,
    Hover, HoverContents, HoverParams, Location, MarkupContent, MarkupKind, Position, Range, SymbolKind,
    TextDocumentPositionParams, TextEdit,
};
use rustc_hash::FxHashSet;
use serde::Serialize;
use serde_json::Value;

/// Characters of a declaration that are shown.
const MOST_SHOWN: usize = 400;
/// Lines of it.
const MOST_LINES: usize = 6;

impl Server<'_> {
    /// The answer to a request; `None` to what povista doesn't know.
    ///
    /// # Errors
    /// What is asked makes no sense.
    pub(super) fn ask(&mut self, request: &Request) -> serde_json::Result<Option<Value>> {
        let params = request.params.clone();
        Ok(Some(match request.method.as_str() {
            HoverRequest::METHOD => {
                let params: HoverParams = serde_json::from_value(params)?;
                self.at(&params.text_document_position_params, hover)?
            }
            GotoDefinition::METHOD => {
                let params: GotoDefinitionParams = serde_json::from_value(params)?;
                self.at(&params.text_document_position_params, definition)?
            }
            Completion::METHOD => {
                let params: CompletionParams = serde_json::from_value(params)?;
                self.at(&params.text_document_position, complete::items)?
            }
            DocumentSymbolRequest::METHOD => {
                let params: DocumentSymbolParams = serde_json::from_value(params)?;
                let uri = params.text_document.uri.as_str();
                self.refresh(uri);
                serde_json::to_value(self.analysis(uri).map(outline))?
            }
            Formatting::METHOD => {
                let params: DocumentFormattingParams = serde_json::from_value(params)?;
                let document = self.documents.get(params.text_document.uri.as_str());
                serde_json::to_value(document.and_then(|document| layout(&document.text)))?
            }
            _ => return Ok(None),
        }))
    }

    fn analysis(&self, uri: &str) -> Option<&Analysis> {
        self.documents.get(uri)?.analysis.as_ref()
    }

    /// The answer about a place in a document.
    fn at<T: Serialize>(
        &mut self,
        place: &TextDocumentPositionParams,
        answer: impl FnOnce(&Analysis, usize) -> Option<T>,
    ) -> serde_json::Result<Value> {
        let uri = place.text_document.uri.as_str();
        self.refresh(uri);
        let answer = self.analysis(uri).and_then(|analysis| {
            let offset = place::offset(analysis.source().text(), place.position);
            answer(analysis, offset)
        });
        serde_json::to_value(answer)
    }
}

/// What a name is: its declaration, where that is, and what it held.
fn hover(analysis: &Analysis, offset: usize) -> Option<Hover> {
    let (kind, span) = analysis.token(offset)?;
    let NodeKind::Word(name) = kind else { return None };
    let text = match Word::of(name) {
        Some(word) => format!("`{}` is a reserved word", word.text()),
        None => describe(analysis, name, span)?,
    };
    let contents = HoverContents::Markup(MarkupContent { kind: MarkupKind::Markdown, value: text });
    Some(Hover { contents, range: Some(place::range(analysis.source(), span)) })
}

fn describe(analysis: &Analysis, name: Symbol, span: Span) -> Option<String> {
    let declaration = analysis.declaration(name, span.start);
    let mut parts = Vec::new();
    if let Some(declaration) = declaration {
        parts.push(format!("```pov\n{}\n```", shown(analysis, declaration)));
    }
    let text = analysis.symbols.name(name);
    let held = analysis.notes.at(span).map(|value| format!("holds `{value}` here"));
    let declared = || {
        let value = analysis.notes.at(declaration?.span)?;
        Some(format!("held `{value}` where it was declared last"))
    };
    parts.extend(held.or_else(declared).map(|held| format!("`{text}` {held}")));
    if let Some(declaration) = declaration {
        let source = analysis.sources.get(declaration.span.file);
        let line = source.position(declaration.span.start).0;
        let what = match declaration.kind {
            Kind::Parameter => "parameter of a macro",
            Kind::Counter => "counter of a loop",
            Kind::Macro => "macro",
            Kind::Declare | Kind::Local => "declared",
        };
        parts.push(format!("{what}, {}:{line}", source.name));
    }
    (!parts.is_empty()).then(|| parts.join("\n\n"))
}

/// The start of a declaration, as it is written.
fn shown(analysis: &Analysis, declaration: &Declaration) -> String {
    let owner = || {
        let owner = declaration.within.filter(|_| declaration.kind == Kind::Parameter)?;
        analysis.indexes[declaration.span.file.0 as usize].declarations.get(owner)
    };
    // Of a macro its head says enough.
    let declaration = owner().unwrap_or(declaration);
    let end = if declaration.kind == Kind::Macro { declaration.value.end } else { declaration.whole.end };
    let span = Span { end, ..declaration.whole };
    let text: String = analysis.sources.text(span).chars().take(MOST_SHOWN).collect();
    let lines: Vec<&str> = text.lines().collect();
    let more = if lines.len() > MOST_LINES { "\n…" } else { "" };
    lines[..lines.len().min(MOST_LINES)].join("\n") + more
}

/// Where a name is declared, or where the file is that is included.
fn definition(analysis: &Analysis, offset: usize) -> Option<Location> {
    let (kind, span) = analysis.token(offset)?;
    let (file, span) = match kind {
        NodeKind::Word(name) if Word::of(name).is_none() => {
            let found = analysis.declaration(name, span.start)?;
            (found.span.file, found.span)
        }
        NodeKind::Text => {
            let name = analysis.sources.text(span).trim_matches('"');
            let place = analysis.sources.all().iter().rposition(|source| source.name == name)?;
            let file = FileId(u32::try_from(place).ok()?);
            (file, Span { file, start: 0, end: 0 })
        }
        _ => return None,
    };
    let source = analysis.sources.get(file);
    if source.path.as_os_str().is_empty() {
        return None;
    }
    Some(Location { uri: place::uri(&source.path)?, range: place::range(source, span) })
}

/// The declarations of a document, those in macros below them, and its statements.
fn outline(analysis: &Analysis) -> Vec<DocumentSymbol> {
    let source = analysis.source();
    let mut top: Vec<(u32, DocumentSymbol)> = Vec::new();
    let mut places: Vec<Option<usize>> = Vec::new();
    let mut said: FxHashSet<(Option<usize>, Symbol)> = FxHashSet::default();
    for declaration in &analysis.index().declarations {
        let name = analysis.symbols.name(declaration.name).to_string();
        let kind = match declaration.kind {
            Kind::Macro => SymbolKind::FUNCTION,
            Kind::Declare | Kind::Local => SymbolKind::VARIABLE,
            Kind::Parameter | Kind::Counter => {
                places.push(None);
                continue;
            }
        };
        // A variable that is set anew is one entry.
        if !said.insert((declaration.within, declaration.name)) {
            places.push(None);
            continue;
        }
        let symbol = symbol(source, name, kind, declaration.whole, declaration.span);
        let owner = declaration.within.and_then(|place| places.get(place).copied().flatten());
        match owner.and_then(|place| top.get_mut(place)) {
            Some((_, owner)) => {
                owner.children.get_or_insert_default().push(symbol);
                places.push(None);
            }
            None => {
                places.push(Some(top.len()));
                top.push((declaration.whole.start, symbol));
            }
        }
    }
    top.extend(statements(analysis));
    top.sort_by_key(|(start, _)| *start);
    top.into_iter().map(|(_, symbol)| symbol).collect()
}

/// Statements that stand for themselves: in no brace, and no value of a declaration.
fn statements(analysis: &Analysis) -> Vec<(u32, DocumentSymbol)> {
    let nodes = &analysis.tree.nodes;
    let declared = |start: u32| {
        analysis.index().declarations.iter().any(|d| d.whole.start <= start && start < d.whole.end)
    };
    let mut found = Vec::new();
    let (mut depth, mut open) = (0_usize, None);
    for (index, node) in nodes.iter().enumerate() {
        match node.kind {
            NodeKind::Punct(Punct::OpenBrace) => {
                let word = index.checked_sub(1).and_then(|before| match nodes[before].kind {
                    NodeKind::Word(symbol) => Word::of(symbol).map(|word| (word, before)),
                    _ => None,
                });
                if depth == 0 {
                    open = word;
                }
                depth += 1;
            }
            NodeKind::Punct(Punct::CloseBrace) => {
                depth = depth.saturating_sub(1);
                if let Some((word, start)) = open.take_if(|_| depth == 0)
                    && !declared(nodes[start].start)
                {
                    let name = analysis.tree.span(start);
                    let whole = name.to(analysis.tree.span(index));
                    let symbol =
                        symbol(analysis.source(), word.text().to_owned(), SymbolKind::OBJECT, whole, name);
                    found.push((whole.start, symbol));
                }
            }
            // A default belongs to nobody.
            NodeKind::Directive(Directive::Default, _) if depth == 0 => open = None,
            _ => {}
        }
    }
    found
}

#[expect(deprecated, reason = "the field has no default, and is left out by tags")]
fn symbol(source: &Source, name: String, kind: SymbolKind, whole: Span, name_span: Span) -> DocumentSymbol {
    DocumentSymbol {
        name,
        detail: None,
        kind,
        tags: None,
        deprecated: None,
        range: place::range(source, whole),
        selection_range: place::range(source, name_span),
        children: None,
    }
}

/// The edit that lays a document out; none if it has a mistake in a token.
fn layout(text: &str) -> Option<Vec<TextEdit>> {
    let source = Source::new("", "", text.as_bytes().to_vec());
    let new_text = fmt::format(FileId(0), &source).ok()?;
    if new_text == text {
        return Some(Vec::new());
    }
    let all = Range::new(Position::new(0, 0), place::position(text, text.len()));
    Some(vec![TextEdit { range: all, new_text }])
}
