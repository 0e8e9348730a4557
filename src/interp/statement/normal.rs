//! `normal { … }` (docs/spec/language.md 6.9, docs/spec/patterns-textures.md 4).

use std::sync::Arc;

use super::pattern::{self, Owner};
use super::{image, map};
use crate::interp::value::Value;
use crate::interp::{Result, Vm, Word};
use crate::scene::pigment::BlendMap;
use crate::scene::texture::NormalKind;
use crate::scene::{Field, Normal, Pattern};
use crate::source::Span;

/// What a normal begins with, apart from its pattern.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bumps {
    amount: f32,
    accuracy: f32,
    no_bump_scale: bool,
}

impl Default for Bumps {
    fn default() -> Self {
        Self { amount: 0.5, accuracy: 0.02, no_bump_scale: false }
    }
}

/// Reads `normal { … }`, whose keyword comes next, as a changed copy of `base`.
pub(super) fn block(vm: &mut Vm<'_>, base: Option<&Arc<Normal>>) -> Result<Arc<Normal>> {
    let block = vm.enter()?;
    let normal = body(vm, base)?;
    vm.close(block)?;
    Ok(normal)
}

/// The same for `#declare`: a normal without a pattern is flat.
pub(super) fn value(vm: &mut Vm<'_>, base: Option<&Arc<Normal>>) -> Result<Arc<Normal>> {
    let block = vm.enter()?;
    let mut bumps = vm.state.bumps;
    let normal = read(vm, base, &mut bumps)?;
    vm.close(block)?;
    Ok(normal.unwrap_or_else(flat))
}

/// The same for `#default`: `None` where there is no pattern; the rest waits for one.
pub(super) fn default(vm: &mut Vm<'_>, base: Option<&Arc<Normal>>) -> Result<Option<Arc<Normal>>> {
    let block = vm.enter()?;
    let mut bumps = vm.state.bumps;
    let normal = read(vm, base, &mut bumps)?;
    vm.state.bumps = bumps;
    vm.close(block)?;
    Ok(normal)
}

/// Reads the inside of a normal, as it also stands in a map.
pub(super) fn body(vm: &mut Vm<'_>, base: Option<&Arc<Normal>>) -> Result<Arc<Normal>> {
    vm.nested_value(vm.last, |vm| inside(vm, base))
}

fn inside(vm: &mut Vm<'_>, base: Option<&Arc<Normal>>) -> Result<Arc<Normal>> {
    let mut bumps = vm.state.bumps;
    match read(vm, base, &mut bumps)? {
        Some(normal) => Ok(normal),
        None => {
            let fault = vm.expected("a pattern");
            Err(fault.help("a normal begins with its pattern, such as `bumps 0.5`"))
        }
    }
}

fn read(vm: &mut Vm<'_>, base: Option<&Arc<Normal>>, bumps: &mut Bumps) -> Result<Option<Arc<Normal>>> {
    let named = vm.accept_value(|value| match value {
        Value::Normal(normal) => Some(Arc::clone(normal)),
        _ => None,
    })?;
    let mut normal = named.or_else(|| base.cloned());
    match vm.peek_word()? {
        Some(Word::UvMapping) => {
            vm.next()?;
            let inner = body(vm, base)?;
            if matches!(inner.kind, NormalKind::UvMapped(_)) {
                return Ok(Some(inner));
            }
            let Normal { amount, accuracy, no_bump_scale, .. } = *inner;
            return Ok(Some(Arc::new(Normal {
                kind: NormalKind::UvMapped(inner),
                amount,
                accuracy,
                no_bump_scale,
            })));
        }
        Some(_) => {
            start(vm, &mut normal)?;
        }
        // After the name of a normal a number is its amount too.
        None => {
            if let Some(normal) = normal.as_mut()
                && let Some(amount) = amount(vm)?
            {
                Arc::make_mut(normal).amount = amount;
            }
        }
    }
    modifiers(vm, &mut normal, bumps)?;
    if let Some(normal) = &normal {
        check(vm, normal)?;
    }
    Ok(normal)
}

/// Reads a picture or a pattern and how deep its bumps are, if one comes next.
pub(super) fn start(vm: &mut Vm<'_>, normal: &mut Option<Arc<Normal>>) -> Result<bool> {
    if vm.peek_word()? == Some(Word::BumpMap) {
        let inner = vm.enter()?;
        let mut amount = None;
        let map = Arc::new(image::bumps(vm, &mut amount)?);
        vm.close(inner)?;
        let field = Field::new(inner.span, Pattern::Image(Arc::clone(&map)));
        let field = Arc::new(replaced(normal.as_deref(), field));
        *normal = Some(changed(vm, normal.as_deref(), NormalKind::Bumps { field, map }, amount));
        return Ok(true);
    }
    match pattern::read(vm, Owner::Normal)? {
        Some(field) => {
            *normal = Some(with_pattern(vm, normal.as_deref(), field)?);
            Ok(true)
        }
        None => Ok(false),
    }
}

fn replaced(base: Option<&Normal>, field: Field) -> Field {
    match base.and_then(Normal::field) {
        Some(old) => pattern::replaced(old, field),
        None => field,
    }
}

fn with_pattern(vm: &mut Vm<'_>, base: Option<&Normal>, field: Field) -> Result<Arc<Normal>> {
    let field = replaced(base, field);
    if let Some(count) = field.pattern.list_length()
        && vm.peek_word()? == Some(Word::Normal)
    {
        let default = vm.state.normal();
        let mut entries =
            pattern::list(vm, &field.pattern, count, Word::Normal, |vm| block(vm, default.as_ref()))?;
        entries.resize_with(count, || default.clone().unwrap_or_else(flat));
        let kind = NormalKind::Normals { field: Arc::new(field), map: Arc::new(BlendMap::list(entries)) };
        let amount = amount(vm)?;
        return Ok(changed(vm, base, kind, amount));
    }
    pattern::end_list(vm, &field.pattern)?;
    let kind = match base.map(|base| &base.kind) {
        Some(NormalKind::Pattern { slopes, .. }) => {
            NormalKind::Pattern { field: Arc::new(field), slopes: slopes.clone() }
        }
        Some(NormalKind::Normals { map, field: old }) if old.pattern.list_length().is_none() => {
            NormalKind::Normals { field: Arc::new(field), map: Arc::clone(map) }
        }
        _ => NormalKind::Pattern { field: Arc::new(field), slopes: None },
    };
    let amount = amount(vm)?;
    Ok(changed(vm, base, kind, amount))
}

/// Reads the amount that may follow a pattern and its list.
fn amount(vm: &mut Vm<'_>) -> Result<Option<f32>> {
    vm.comma()?;
    Ok(if vm.at_number()? { Some(vm.read_float()? as f32) } else { None })
}

/// A copy with another pattern.
fn changed(vm: &Vm<'_>, base: Option<&Normal>, kind: NormalKind, amount: Option<f32>) -> Arc<Normal> {
    let Bumps { amount: default, accuracy, no_bump_scale } = match base {
        Some(&Normal { amount, accuracy, no_bump_scale, .. }) => Bumps { amount, accuracy, no_bump_scale },
        None => vm.state.bumps,
    };
    Arc::new(Normal { kind, amount: amount.unwrap_or(default), accuracy, no_bump_scale })
}

/// A normal that bends nothing, where a map has an entry without a pattern.
pub(super) fn flat() -> Arc<Normal> {
    let field = Arc::new(Field::new(Span::default(), Pattern::Bumps));
    let kind = NormalKind::Pattern { field, slopes: None };
    Arc::new(Normal { kind, amount: 0.0, accuracy: 0.02, no_bump_scale: false })
}

fn modifiers(vm: &mut Vm<'_>, normal: &mut Option<Arc<Normal>>, bumps: &mut Bumps) -> Result<()> {
    while one_modifier(vm, normal, bumps)? {}
    Ok(())
}

fn one_modifier(vm: &mut Vm<'_>, normal: &mut Option<Arc<Normal>>, bumps: &mut Bumps) -> Result<bool> {
    let Some(word) = vm.peek_word()? else { return Ok(false) };
    match word {
        Word::SlopeMap => {
            let place = vm.here()?;
            let slopes = Some(map::slopes(vm)?);
            let field = mapped(vm, normal.as_deref(), word, place)?;
            set_kind(normal, NormalKind::Pattern { field, slopes });
        }
        Word::NormalMap => {
            let place = vm.here()?;
            let field = normal.as_deref().and_then(Normal::field);
            let average = field.is_some_and(|field| matches!(*field.pattern, Pattern::Average));
            let map = map::normals(vm, average)?;
            let field = mapped(vm, normal.as_deref(), word, place)?;
            set_kind(normal, NormalKind::Normals { field, map });
        }
        Word::BumpSize | Word::Accuracy => {
            let value = vm.after_word(Vm::read_float)? as f32;
            let (amount, accuracy) = match normal.as_mut().map(Arc::make_mut) {
                Some(normal) => (&mut normal.amount, &mut normal.accuracy),
                None => (&mut bumps.amount, &mut bumps.accuracy),
            };
            *(if word == Word::BumpSize { amount } else { accuracy }) = value;
        }
        Word::NoBumpScale => {
            vm.next()?;
            match normal {
                Some(normal) => Arc::make_mut(normal).no_bump_scale = true,
                None => bumps.no_bump_scale = true,
            }
        }
        _ if pattern::is_modifier(word) => {
            let field = normal.as_mut().and_then(|normal| Arc::make_mut(normal).field_mut());
            match field {
                Some(field) => pattern::modifier(vm, Arc::make_mut(field))?,
                None => pattern::modifier(vm, &mut Field::new(vm.last, Pattern::Bumps))?,
            };
        }
        _ => return Ok(false),
    }
    Ok(true)
}

/// Reads one of the words that follow a pattern, if one comes next.
pub(super) fn modifier(vm: &mut Vm<'_>, normal: &mut Option<Arc<Normal>>) -> Result<bool> {
    let mut bumps = vm.state.bumps;
    one_modifier(vm, normal, &mut bumps)
}

fn set_kind(normal: &mut Option<Arc<Normal>>, kind: NormalKind) {
    if let Some(normal) = normal {
        Arc::make_mut(normal).kind = kind;
    }
}

fn mapped(vm: &Vm<'_>, normal: Option<&Normal>, word: Word, place: Span) -> Result<Arc<Field>> {
    match normal.map(|normal| &normal.kind) {
        Some(NormalKind::Pattern { field, .. } | NormalKind::Normals { field, .. }) => {
            if field.pattern.list_length().is_some() {
                return Err(map::for_list(vm, word, place));
            }
            Ok(Arc::clone(field))
        }
        _ => Err(vm
            .error(place, format!("`{}` has no pattern to go by", word.text()))
            .help("begin with a pattern such as `gradient y` or `bozo`; an image takes no map")),
    }
}

fn check(vm: &Vm<'_>, normal: &Normal) -> Result<()> {
    if let NormalKind::Pattern { field, .. } = &normal.kind
        && matches!(*field.pattern, Pattern::Average)
    {
        return Err(vm
            .error(field.span, "`average` needs a map")
            .help("add `normal_map { [1 …] [1 …] }` with what is to be mixed"));
    }
    normal.field().map_or(Ok(()), |field| pattern::check(vm, field))
}
