//! What may be written at a place.

use super::analysis::Analysis;
use crate::index::{Declaration, Kind};
use crate::interp::Word;
use crate::syntax::{DIRECTIVES, Symbol};
use lsp_types::{CompletionItem, CompletionItemKind};
use rustc_hash::FxHashSet;

/// After a `#` the directives; anywhere else the reserved words and the names that are known there.
pub(super) fn items(analysis: &Analysis, offset: usize) -> Option<Vec<CompletionItem>> {
    let text = analysis.source().text();
    let before = text[..offset].trim_end_matches(|c: char| c.is_ascii_alphanumeric() || c == '_');
    if before.ends_with('#') {
        return Some(
            DIRECTIVES.iter().map(|(word, _)| item(word, CompletionItemKind::KEYWORD, None)).collect(),
        );
    }
    let mut items: Vec<CompletionItem> =
        Word::spellings().map(|word| item(word, CompletionItemKind::KEYWORD, None)).collect();
    let at = u32::try_from(offset).unwrap_or(u32::MAX);
    let mut said: FxHashSet<Symbol> = FxHashSet::default();
    // The document's own names first: they hide those of the files it includes.
    let others = (0..analysis.indexes.len()).filter(|&file| file != analysis.main.0 as usize);
    for file in std::iter::once(analysis.main.0 as usize).chain(others) {
        let index = &analysis.indexes[file];
        let is_main = file == analysis.main.0 as usize;
        for declaration in &index.declarations {
            let inner =
                declaration.within.is_some() && !matches!(declaration.kind, Kind::Declare | Kind::Macro);
            let around = declaration.within.map(|owner| index.declarations[owner].whole);
            let seen = !inner || is_main && around.is_some_and(|whole| whole.start <= at && at <= whole.end);
            if seen && said.insert(declaration.name) {
                items.push(name(analysis, declaration));
            }
        }
    }
    Some(items)
}

fn name(analysis: &Analysis, declaration: &Declaration) -> CompletionItem {
    let name = analysis.symbols.name(declaration.name);
    let (kind, detail) = match declaration.kind {
        Kind::Macro => {
            let parameters = analysis.sources.text(declaration.value);
            (CompletionItemKind::FUNCTION, Some(format!("{name}{parameters}")))
        }
        _ => (CompletionItemKind::VARIABLE, analysis.notes.at(declaration.span)),
    };
    item(name, kind, detail)
}

fn item(label: &str, kind: CompletionItemKind, detail: Option<String>) -> CompletionItem {
    CompletionItem { label: label.to_owned(), kind: Some(kind), detail, ..CompletionItem::default() }
}
