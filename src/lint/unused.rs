//! Names, macros and parameters that nothing uses.

use super::{File, Scene};
use crate::diag::{Code, Diagnostic, Severity};
use crate::index::{Declaration, Kind};
use crate::syntax::Symbol;
use rustc_hash::FxHashSet;

/// Names nobody uses. In a file that is included others may use them, so only what is local is told there.
pub(super) fn names(scene: &Scene, found: &mut Vec<Diagnostic>) {
    let everywhere: FxHashSet<Symbol> = scene.files.iter().flat_map(used).collect();
    let mut said = FxHashSet::default();
    for file in scene.own() {
        let here: FxHashSet<Symbol> = used(file).collect();
        for declaration in &file.index.declarations {
            let (used, what) = match declaration.kind {
                // A macro sees the names of whoever calls it, wherever that is.
                Kind::Local => {
                    (here.contains(&declaration.name) || everywhere.contains(&declaration.name), "")
                }
                Kind::Declare if file.tree.file == scene.main => (everywhere.contains(&declaration.name), ""),
                Kind::Macro if file.tree.file == scene.main => {
                    (everywhere.contains(&declaration.name), "the macro ")
                }
                _ => continue,
            };
            if !used && !is_deliberate(scene, declaration) && said.insert(declaration.name) {
                found.push(unused(scene, declaration, what));
            }
        }
    }
}

/// Parameters that neither their macro uses nor one that it calls: those see them too.
pub(super) fn parameters(scene: &Scene, found: &mut Vec<Diagnostic>) {
    for file in scene.own() {
        for declaration in &file.index.declarations {
            let Some(owner) = declaration.within.filter(|_| declaration.kind == Kind::Parameter) else {
                continue;
            };
            if !is_deliberate(scene, declaration) && !sees(scene, file, owner, declaration.name) {
                found.push(unused(scene, declaration, "the parameter "));
            }
        }
    }
}

/// Whether a macro uses a name, or one that it calls.
fn sees(scene: &Scene, file: &File, owner: usize, name: Symbol) -> bool {
    let mut open = vec![(file, owner)];
    let mut visited: FxHashSet<Symbol> = FxHashSet::default();
    while let Some((file, owner)) = open.pop() {
        let body = file.index.declarations[owner].whole;
        let inside = |at: u32| body.start <= at && at < body.end;
        for found in file.index.uses.iter().filter(|found| inside(found.span.start)) {
            if found.name == name {
                return true;
            }
            if visited.insert(found.name) {
                open.extend(macros(scene, found.name));
            }
        }
        // Strings may be made code of.
        if file.index.mentioned.contains(&name) {
            return true;
        }
    }
    false
}

/// The macros with a name.
fn macros(scene: &Scene, name: Symbol) -> impl Iterator<Item = (&File, usize)> {
    scene.files.iter().flat_map(move |file| {
        let declarations = file.index.declarations.iter().enumerate();
        declarations
            .filter(move |(_, d)| d.kind == Kind::Macro && d.name == name)
            .map(move |(place, _)| (file, place))
    })
}

fn used(file: &File) -> impl Iterator<Item = Symbol> {
    file.index.uses.iter().map(|found| found.name).chain(file.index.mentioned.iter().copied())
}

/// Names that start with an underscore are meant to be unused.
fn is_deliberate(scene: &Scene, declaration: &Declaration) -> bool {
    scene.name(declaration.name).starts_with('_')
}

fn unused(scene: &Scene, declaration: &Declaration, what: &str) -> Diagnostic {
    let name = scene.name(declaration.name);
    let message = format!("{what}`{name}` is never used");
    let help = format!("remove it, or call it `_{name}` if that is meant");
    Diagnostic::new(Severity::Warning, declaration.span, message).code(Code::Unused).help(help)
}
