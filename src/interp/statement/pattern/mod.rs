//! Patterns: the word, its parameters, its list, and what may follow (docs/spec/language.md 6.9).

mod density_file;
mod fractal;
mod modifier;
mod object;
mod pavement;
mod slope;

pub(super) use modifier::{is_modifier, modifier, option as turbulence_option};

use std::sync::Arc;

use super::{image, pigment};
use crate::interp::{Result, Vm, Word};
use crate::math::{DVec3, Rgbft};
use crate::scene::pigment::BlendMap;
use crate::scene::{Field, Pattern};
use crate::syntax::Punct;

/// The kind of block a pattern stands in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Owner {
    /// `pigment`.
    Pigment,
    /// `density`.
    Density,
    /// `normal`.
    Normal,
    /// `texture`.
    Texture,
    /// `function { pattern { … } }`.
    Function,
}

/// Whether a word names a pattern.
pub(super) fn is_pattern(word: Word) -> bool {
    use Word::*;
    simple(word).is_some()
        || matches!(
            word,
            DensityFile
                | Function
                | Gradient
                | ImagePattern
                | Julia
                | Magnet
                | Mandel
                | Object
                | PigmentPattern
                | Slope
                | Spiral1
                | Spiral2
                | Tiling
        )
}

/// The patterns that are no more than a word.
fn simple(word: Word) -> Option<Pattern> {
    Some(match word {
        Word::Agate => Pattern::Agate { turbulence: 1.0 },
        Word::Aoi => Pattern::Aoi,
        Word::Average => Pattern::Average,
        Word::Boxed => Pattern::Boxed,
        Word::Bozo => Pattern::Bozo,
        Word::Brick => Pattern::Brick { size: DVec3::new(8.0, 3.0, 4.5), mortar: 0.5 },
        Word::Bumps => Pattern::Bumps,
        Word::Cells => Pattern::Cells,
        Word::Checker => Pattern::Checker,
        Word::Crackle => {
            Pattern::Crackle { form: DVec3::new(-1.0, 1.0, 0.0), metric: 2.0, offset: 0.0, solid: false }
        }
        Word::Cubic => Pattern::Cubic,
        Word::Cylindrical => Pattern::Cylindrical,
        Word::Dents => Pattern::Dents,
        Word::Facets => Pattern::Facets { size: 0.1, coords: 0.0, metric: 2.0 },
        Word::Granite => Pattern::Granite,
        Word::Hexagon => Pattern::Hexagon,
        Word::Leopard => Pattern::Leopard,
        Word::Marble => Pattern::Marble,
        Word::Onion => Pattern::Onion,
        Word::Pavement => pavement::plain(),
        Word::Planar => Pattern::Planar,
        Word::Quilted => Pattern::Quilted { control0: 1.0, control1: 1.0 },
        Word::Radial => Pattern::Radial,
        Word::Ripples => Pattern::Ripples,
        Word::Spherical => Pattern::Spherical,
        Word::Spotted => Pattern::Spotted,
        Word::Square => Pattern::Square,
        Word::Triangular => Pattern::Triangular,
        Word::Waves => Pattern::Waves,
        Word::Wood => Pattern::Wood,
        Word::Wrinkles => Pattern::Wrinkles,
        _ => return None,
    })
}

/// Patterns a `function { pattern { … } }` does not take (docs/spec/language.md 4.3).
fn without_function(word: Word) -> bool {
    use Word::*;
    matches!(word, Square | Triangular | Average | Facets | Slope | Aoi | Pavement | Tiling)
}

/// Reads a pattern and its parameters, if one comes next. The brace of `object { … }` stays open: the
/// list is inside, see [`list`], [`colors`] and [`end_list`].
pub(super) fn read(vm: &mut Vm<'_>, owner: Owner) -> Result<Option<Field>> {
    let Some(word) = vm.peek_word()? else { return Ok(None) };
    if !is_pattern(word) {
        return Ok(None);
    }
    let place = vm.here()?;
    if (owner == Owner::Function && without_function(word))
        || (word == Word::Facets && owner != Owner::Normal)
    {
        let (word, block) =
            (word.text(), if owner == Owner::Function { "a function" } else { "anything but a normal" });
        return Err(vm.error(place, format!("the pattern `{word}` cannot be used in {block}")));
    }
    let pattern = match word {
        Word::DensityFile => density_file::read(vm)?,
        Word::Function => Pattern::Function(vm.read_plain_function()?),
        Word::Gradient => Pattern::Gradient(vm.after_word(Vm::read_vector)?.normalize_or_zero()),
        Word::ImagePattern => {
            let block = vm.enter()?;
            let map = image::map(vm, image::Usage::Pattern)?;
            vm.close(block)?;
            Pattern::Image(Arc::new(map))
        }
        Word::Julia | Word::Magnet | Word::Mandel => fractal::read(vm)?,
        Word::Object => object::read(vm)?,
        Word::PigmentPattern => {
            let block = vm.enter()?;
            let empty = vm.state.empty();
            let inner = pigment::body(vm, &empty, Owner::Pigment)?;
            vm.close(block)?;
            Pattern::Pigment(inner)
        }
        Word::Slope => slope::read(vm)?,
        Word::Spiral1 => Pattern::Spiral1(vm.after_word(Vm::read_int)?),
        Word::Spiral2 => Pattern::Spiral2(vm.after_word(Vm::read_int)?),
        Word::Tiling => tiling(vm)?,
        _ => {
            vm.next()?;
            match simple(word) {
                Some(pattern) => pattern,
                None => return Ok(None),
            }
        }
    };
    Ok(Some(Field::new(place, pattern)))
}

fn tiling(vm: &mut Vm<'_>) -> Result<Pattern> {
    vm.next()?;
    let (number, place) = vm.located(Vm::read_int)?;
    if !(1..=27).contains(&number) {
        return Err(vm
            .error(place, format!("there is no tiling {number}"))
            .help("tilings are numbered 1 to 27"));
    }
    Ok(Pattern::Tiling(number as u32))
}

/// What can be judged only when the whole block has been read.
pub(super) fn check(vm: &Vm<'_>, field: &Field) -> Result<()> {
    match &*field.pattern {
        Pattern::Pavement(pavement) => pavement::check(vm, pavement, field.span),
        _ => Ok(()),
    }
}

/// A new pattern in the place of an old one, whose warps, turbulence and modulation it keeps
/// (docs/spec/patterns-textures.md 7.1).
pub(super) fn replaced(old: &Field, mut new: Field) -> Field {
    new.warps.clone_from(&old.warps);
    new.phase = old.phase;
    new.turbulence = old.turbulence.or(new.turbulence);
    new.noise_generator = old.noise_generator;
    // Frequency and wave of the old pattern are kept unless they are just what it began with.
    if new.frequency != 0.0 && old.frequency != old.pattern.default_frequency() {
        new.frequency = old.frequency;
    }
    if old.wave != old.pattern.default_wave() {
        new.wave = old.wave;
    }
    new
}

/// Reads up to `count` blocks of a list pattern.
pub(super) fn list<T>(
    vm: &mut Vm<'_>,
    pattern: &Pattern,
    count: usize,
    word: Word,
    mut read: impl FnMut(&mut Vm<'_>) -> Result<T>,
) -> Result<Vec<T>> {
    let mut entries = Vec::with_capacity(count);
    while entries.len() < count && vm.peek_word()? == Some(word) {
        entries.push(read(vm)?);
        vm.comma()?;
    }
    end_list(vm, pattern)?;
    Ok(entries)
}

/// Reads up to `count` colours of a list pattern; `None` if there is none. Missing ones are the defaults.
pub(super) fn colors(vm: &mut Vm<'_>, pattern: &Pattern, count: usize) -> Result<Option<BlendMap<Rgbft>>> {
    let mut colors = pattern.default_colors();
    let mut given = 0;
    while given < count && vm.at_color()? {
        colors.entries.inside_mut()[given].1 = super::color::rgbft(vm)?;
        given += 1;
        vm.comma()?;
    }
    end_list(vm, pattern)?;
    Ok((given > 0).then_some(colors))
}

/// Closes the brace that [`read`] left open for the list of an object pattern.
pub(super) fn end_list(vm: &mut Vm<'_>, pattern: &Pattern) -> Result<()> {
    if let Pattern::Object(_) = pattern {
        vm.expect(Punct::CloseBrace)?;
    }
    Ok(())
}
