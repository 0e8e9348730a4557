//! `pigment { … }` and `density { … }` (docs/spec/language.md 6.9, docs/spec/patterns-textures.md 7.1).

use std::sync::Arc;

use super::pattern::{self, Owner};
use super::{color, image, map};
use crate::interp::value::Value;
use crate::interp::{Result, Vm, Word};
use crate::math::{DVec3, Rgbft};
use crate::scene::pigment::{BlendMap, PigmentKind};
use crate::scene::{Field, Pattern, Pigment};
use crate::source::Span;

/// Reads `pigment { … }`, whose keyword comes next, as a changed copy of `base`.
pub(in crate::interp) fn block(vm: &mut Vm<'_>, base: &Arc<Pigment>) -> Result<Arc<Pigment>> {
    if let Some(rgb) = vm.replay_color() {
        let kind = PigmentKind::Color(Rgbft::opaque(DVec3::from_array(rgb).as_vec3a()));
        return Ok(Arc::new(Pigment { kind, quick_color: base.quick_color.clone() }));
    }
    let block = vm.enter()?;
    let pigment = body(vm, base, Owner::Pigment)?;
    vm.close(block)?;
    Ok(pigment)
}

/// Reads `density { … }`, whose keyword comes next.
pub(in crate::interp) fn density(vm: &mut Vm<'_>) -> Result<Arc<Pigment>> {
    let block = vm.enter()?;
    let density = body(vm, &Arc::clone(&vm.state.unset), Owner::Density)?;
    vm.close(block)?;
    Ok(density)
}

/// Reads the inside of a pigment or density, as it also stands in a map.
pub(super) fn body(vm: &mut Vm<'_>, base: &Arc<Pigment>, owner: Owner) -> Result<Arc<Pigment>> {
    vm.nested_value(vm.last, |vm| inside(vm, base, owner))
}

fn inside(vm: &mut Vm<'_>, base: &Arc<Pigment>, owner: Owner) -> Result<Arc<Pigment>> {
    let named = vm.accept_value(|value| match (value, owner) {
        (Value::Pigment(pigment), Owner::Pigment) => Some(Arc::clone(pigment)),
        (Value::Density(density), Owner::Density) => Some(Arc::clone(density)),
        _ => None,
    })?;
    let mut given = named.is_some() || !Arc::ptr_eq(base, &vm.state.unset);
    let mut pigment = named.unwrap_or_else(|| Arc::clone(base));
    match vm.peek_word()? {
        Some(Word::UvMapping) => {
            vm.next()?;
            let inner = body(vm, base, owner)?;
            if matches!(inner.kind, PigmentKind::UvMapped(_)) {
                return Ok(inner);
            }
            let quick_color = inner.quick_color.clone();
            return Ok(Arc::new(Pigment { kind: PigmentKind::UvMapped(inner), quick_color }));
        }
        _ if start(vm, &mut pigment, owner)? => given = true,
        Some(_) => {}
        None => refuse_numbers(vm, owner)?,
    }
    if !given && matches!(pigment.kind, PigmentKind::Color(_)) && owner == Owner::Pigment {
        let place = vm.here()?;
        let help = "begin it with a color such as `rgb 1`, or a pattern such as `bozo`; it stays as it was";
        vm.warn(place, "this pigment has no color and no pattern", help);
    }
    modifiers(vm, &mut pigment, owner, given)?;
    check(vm, &pigment)?;
    Ok(pigment)
}

/// Reads a colour, a picture or a pattern, if one comes next.
pub(super) fn start(vm: &mut Vm<'_>, pigment: &mut Arc<Pigment>, owner: Owner) -> Result<bool> {
    if vm.at_color()? {
        let kind = PigmentKind::Color(color::rgbft(vm)?);
        *pigment = Arc::new(Pigment { kind, quick_color: pigment.quick_color.clone() });
        return Ok(true);
    }
    match vm.peek_word()? {
        Some(Word::ImageMap) => {
            let inner = vm.enter()?;
            let map = Arc::new(image::map(vm, image::Usage::Pigment)?);
            vm.close(inner)?;
            let field = replaced(pigment, Field::new(inner.span, Pattern::Image(Arc::clone(&map))));
            Arc::make_mut(pigment).kind = PigmentKind::Image { field: Arc::new(field), map };
            Ok(true)
        }
        Some(_) => match pattern::read(vm, owner)? {
            Some(field) => {
                *pigment = with_pattern(vm, pigment, field, owner)?;
                Ok(true)
            }
            None => Ok(false),
        },
        None => Ok(false),
    }
}

/// A pigment cannot be plain numbers.
fn refuse_numbers(vm: &mut Vm<'_>, owner: Owner) -> Result<()> {
    use crate::interp::stream::TokenKind;
    if matches!(vm.peek()?.kind, TokenKind::Number(_) | TokenKind::Vector(..)) && owner == Owner::Pigment {
        let fault = vm.expected("a color or a pattern");
        return Err(fault.help("write `rgb` or `color` before the numbers"));
    }
    Ok(())
}

/// A copy with another pattern: warps and modulation are kept, and a map if the new pattern takes one.
fn with_pattern(vm: &mut Vm<'_>, base: &Pigment, field: Field, owner: Owner) -> Result<Arc<Pigment>> {
    let field = replaced(base, field);
    let kind = match field.pattern.list_length() {
        Some(count) => list(vm, field, count, owner)?,
        None => match &base.kind {
            PigmentKind::Colors { field: old, map } if old.pattern.list_length().is_none() => {
                PigmentKind::Colors { field: Arc::new(field), map: map.clone() }
            }
            PigmentKind::Pigments { field: old, map } if old.pattern.list_length().is_none() => {
                PigmentKind::Pigments { field: Arc::new(field), map: Arc::clone(map) }
            }
            _ => PigmentKind::Colors { field: Arc::new(field), map: None },
        },
    };
    Ok(Arc::new(Pigment { kind, quick_color: base.quick_color.clone() }))
}

/// The new pattern in the surroundings of the old one.
fn replaced(base: &Pigment, field: Field) -> Field {
    match base.field() {
        Some(old) => pattern::replaced(old, field),
        None => field,
    }
}

/// Reads the colours or pigments of a list pattern; missing ones are the defaults.
fn list(vm: &mut Vm<'_>, field: Field, count: usize, owner: Owner) -> Result<PigmentKind> {
    let word = if owner == Owner::Density { Word::Density } else { Word::Pigment };
    if vm.peek_word()? == Some(word) {
        let default = default(vm, owner);
        let mut entries = pattern::list(vm, &field.pattern, count, word, |vm| {
            let inner = vm.enter()?;
            let entry = body(vm, &default, owner)?;
            vm.close(inner)?;
            Ok(entry)
        })?;
        entries.resize(count, default);
        return Ok(PigmentKind::Pigments { field: Arc::new(field), map: Arc::new(BlendMap::list(entries)) });
    }
    let colors = pattern::colors(vm, &field.pattern, count)?;
    Ok(PigmentKind::Colors { field: Arc::new(field), map: colors.map(Arc::new) })
}

/// What entries of maps and lists start from.
fn default(vm: &Vm<'_>, owner: Owner) -> Arc<Pigment> {
    match owner {
        Owner::Density => Arc::clone(&vm.state.unset),
        _ => vm.state.pigment(),
    }
}

/// Reads what follows colour or pattern; `given` says that there was one.
fn modifiers(vm: &mut Vm<'_>, pigment: &mut Arc<Pigment>, owner: Owner, given: bool) -> Result<()> {
    while modifier(vm, pigment, owner, given)? {}
    Ok(())
}

/// Reads one of the words that follow colour or pattern, if one comes next.
pub(super) fn modifier(
    vm: &mut Vm<'_>,
    pigment: &mut Arc<Pigment>,
    owner: Owner,
    given: bool,
) -> Result<bool> {
    let Some(word) = vm.peek_word()? else { return Ok(false) };
    match word {
        Word::ColorMap | Word::ColourMap => {
            let place = vm.here()?;
            let map = map::colors(vm)?;
            if !given && pigment.field().is_none() {
                return Ok(true);
            }
            let field = mapped(vm, pigment, word, place)?;
            if matches!(*field.pattern, Pattern::Average) {
                return Err(vm
                    .error(place, "`average` mixes pigments, not colors")
                    .help("write `pigment_map` instead of `color_map`"));
            }
            Arc::make_mut(pigment).kind = PigmentKind::Colors { field, map: Some(map) };
        }
        Word::PigmentMap | Word::DensityMap if (word == Word::DensityMap) == (owner == Owner::Density) => {
            let place = vm.here()?;
            let average = pigment.field().is_some_and(|field| matches!(*field.pattern, Pattern::Average));
            let map = map::pigments(vm, owner, &default(vm, owner), average)?;
            if !given && pigment.field().is_none() {
                return Ok(true);
            }
            let field = mapped(vm, pigment, word, place)?;
            Arc::make_mut(pigment).kind = PigmentKind::Pigments { field, map };
        }
        // Bumps are no concern of a pigment, but the word is taken.
        Word::NoBumpScale => {
            vm.next()?;
        }
        Word::QuickColor | Word::QuickColour => {
            vm.next()?;
            Arc::make_mut(pigment).quick_color = Some(Arc::new(color::rgbft(vm)?));
        }
        _ if pattern::is_modifier(word) => {
            match Arc::make_mut(pigment).field_mut() {
                Some(field) => pattern::modifier(vm, Arc::make_mut(field))?,
                // A plain colour takes modifiers too, and has no use for them.
                None => pattern::modifier(vm, &mut Field::new(vm.last, Pattern::Bozo))?,
            };
        }
        _ => return Ok(false),
    }
    Ok(true)
}

/// The pattern a map is written for.
fn mapped(vm: &Vm<'_>, pigment: &Pigment, word: Word, place: Span) -> Result<Arc<Field>> {
    match &pigment.kind {
        PigmentKind::Colors { field, .. } | PigmentKind::Pigments { field, .. } => {
            if field.pattern.list_length().is_some() {
                return Err(map::for_list(vm, word, place));
            }
            Ok(Arc::clone(field))
        }
        _ => Err(vm.error(place, format!("`{}` has no pattern to go by", word.text())).help(
            "begin with a pattern such as `gradient y` or `bozo`; a plain color or an image takes no map",
        )),
    }
}

fn check(vm: &Vm<'_>, pigment: &Pigment) -> Result<()> {
    if let PigmentKind::Colors { field, map: None } = &pigment.kind
        && matches!(*field.pattern, Pattern::Average)
    {
        return Err(vm
            .error(field.span, "`average` needs a map")
            .help("add `pigment_map { [1 …] [1 …] }` with what is to be mixed"));
    }
    pigment.field().map_or(Ok(()), |field| pattern::check(vm, field))
}
