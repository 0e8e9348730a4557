//! Local names and parameters that hide a name of the scene.

use super::Scene;
use crate::diag::{Code, Diagnostic, Severity};
use crate::index::{Declaration, Kind};
use crate::syntax::Symbol;
use rustc_hash::{FxHashMap, FxHashSet};

/// Shorter names are counters and the like: that they are used again is nothing to wonder about.
const SHORT: usize = 3;

/// What hides a name that the user's own files give the whole scene, before the macro or after it.
pub(super) fn names(scene: &Scene, found: &mut Vec<Diagnostic>) {
    let mut globals: FxHashMap<Symbol, &Declaration> = FxHashMap::default();
    for declaration in scene.own().flat_map(|file| &file.index.declarations) {
        let is_global = match declaration.kind {
            Kind::Declare => declaration.within.is_none(),
            Kind::Macro => true,
            Kind::Local | Kind::Parameter | Kind::Counter => false,
        };
        if is_global {
            globals.entry(declaration.name).or_insert(declaration);
        }
    }
    let mut said = FxHashSet::default();
    for declaration in scene.own().flat_map(|file| &file.index.declarations) {
        let hides = matches!(declaration.kind, Kind::Local | Kind::Parameter) && declaration.within.is_some();
        let name = scene.name(declaration.name);
        if !hides || name.len() <= SHORT {
            continue;
        }
        let Some(global) = globals.get(&declaration.name) else { continue };
        if said.insert((declaration.span.file, declaration.within, declaration.name)) {
            let message = format!("`{name}` hides a name of the whole scene");
            found.push(
                Diagnostic::new(Severity::Warning, declaration.span, message)
                    .code(Code::Shadowed)
                    .see(global.span, "which is declared here")
                    .help("take another name, so that nobody changes the wrong one"),
            );
        }
    }
}
