//! What may follow a pattern, in any order.

use super::super::{transform, warp};
use super::{fractal, pavement};
use crate::interp::{Fault, Result, Vm, Word};
use crate::scene::pattern::{Turbulence, Wave};
use crate::scene::{Field, Pattern};
use crate::source::Span;

/// Whether a word modifies patterns.
pub(in crate::interp::statement) fn is_modifier(word: Word) -> bool {
    use Word::*;
    is_transform(word)
        || wave(word).is_some()
        || matches!(
            word,
            Turbulence
                | Octaves
                | Omega
                | Lambda
                | Frequency
                | Phase
                | PolyWave
                | NoiseGenerator
                | Warp
                | AgateTurb
                | BrickSize
                | Mortar
                | Form
                | Metric
                | Offset
                | Solid
                | Control0
                | Control1
                | Size
                | Coords
                | Exponent
                | Interior
                | Exterior
                | Interpolate
                | NumberOfSides
                | NumberOfTiles
                | Pattern
        )
}

fn is_transform(word: Word) -> bool {
    use Word::*;
    matches!(word, Translate | Rotate | Scale | Matrix | Transform)
}

fn wave(word: Word) -> Option<Wave> {
    Some(match word {
        Word::RampWave => Wave::Ramp,
        Word::TriangleWave => Wave::Triangle,
        Word::SineWave => Wave::Sine,
        Word::ScallopWave => Wave::Scallop,
        Word::CubicWave => Wave::Cubic,
        _ => return None,
    })
}

/// Reads one modifier into a pattern, if one comes next.
pub(in crate::interp::statement) fn modifier(vm: &mut Vm<'_>, field: &mut Field) -> Result<bool> {
    let Some(word) = vm.peek_word()? else { return Ok(false) };
    if let Some(by) = transform::item(vm)? {
        field.apply(&by);
        return Ok(true);
    }
    if !is_modifier(word) {
        return Ok(false);
    }
    if word == Word::Warp {
        field.warps.push(warp::read(vm)?);
        return Ok(true);
    }
    let place = vm.next()?.span;
    match word {
        Word::Turbulence => turbulence(field).amount = vm.read_vector()?,
        Word::Octaves | Word::Omega | Word::Lambda => option(vm, turbulence(field), word)?,
        Word::Frequency => field.frequency = vm.read_float()? as f32,
        Word::Phase => field.phase = vm.read_float()? as f32,
        Word::PolyWave => {
            let exponent = if vm.at_number()? { vm.read_float()? as f32 } else { 1.0 };
            field.wave = Wave::Poly(exponent);
        }
        Word::NoiseGenerator => {
            let (number, place) = vm.located(Vm::read_int)?;
            if !(0..=3).contains(&number) {
                return Err(vm
                    .error(place, format!("there is no noise generator {number}"))
                    .help("they are numbered 1 to 3; 0 is the scene's"));
            }
            field.noise_generator = (number > 0).then_some(number as u8);
        }
        _ => match wave(word) {
            Some(wave) => field.wave = wave,
            None => own(vm, field, word, place)?,
        },
    }
    Ok(true)
}

/// The turbulence of a pattern, with its defaults on first use.
fn turbulence(field: &mut Field) -> &mut Turbulence {
    field.turbulence.get_or_insert_default()
}

/// Reads the value of `octaves`, `omega` or `lambda`.
pub(in crate::interp::statement) fn option(
    vm: &mut Vm<'_>,
    turbulence: &mut Turbulence,
    word: Word,
) -> Result<()> {
    match word {
        Word::Octaves => turbulence.octaves = vm.read_int()?.clamp(1, 10) as u32,
        Word::Omega => turbulence.omega = vm.read_float()? as f32,
        _ => turbulence.lambda = vm.read_float()? as f32,
    }
    Ok(())
}

/// Reads a setting that one pattern has of its own.
fn own(vm: &mut Vm<'_>, field: &mut Field, word: Word, place: Span) -> Result<()> {
    match (field.pattern.inside_mut(), word) {
        (Pattern::Agate { turbulence }, Word::AgateTurb) => *turbulence = vm.read_float()? as f32,
        (Pattern::Brick { size, .. }, Word::BrickSize) => *size = vm.read_vector()?,
        (Pattern::Brick { mortar, .. }, Word::Mortar) => *mortar = vm.read_float()? as f32,
        (Pattern::Crackle { form, .. }, Word::Form) => *form = vm.read_vector()?,
        (Pattern::Crackle { metric, .. } | Pattern::Facets { metric, .. }, Word::Metric) => {
            *metric = vm.read_float()?
        }
        (Pattern::Crackle { offset, .. }, Word::Offset) => *offset = vm.read_float()?,
        (Pattern::Crackle { solid, .. }, Word::Solid) => *solid = true,
        (Pattern::Facets { size, .. }, Word::Size) => *size = vm.read_float()?,
        (Pattern::Facets { coords, .. }, Word::Coords) => *coords = vm.read_float()?,
        (Pattern::Quilted { control0, .. }, Word::Control0) => *control0 = vm.read_float()? as f32,
        (Pattern::Quilted { control1, .. }, Word::Control1) => *control1 = vm.read_float()? as f32,
        (Pattern::DensityFile { interpolate, .. }, Word::Interpolate) => *interpolate = vm.read_count()?,
        (
            Pattern::Pavement(pavement),
            Word::NumberOfSides
            | Word::NumberOfTiles
            | Word::Pattern
            | Word::Exterior
            | Word::Interior
            | Word::Form,
        ) => pavement::option(vm, pavement, word)?,
        (Pattern::Fractal(fractal), Word::Exponent | Word::Interior | Word::Exterior) => {
            fractal::option(vm, fractal, word)?;
        }
        _ => return Err(unfit(vm, word, place)),
    }
    Ok(())
}

fn unfit(vm: &Vm<'_>, word: Word, place: Span) -> Fault {
    let owner = match word {
        Word::AgateTurb => "`agate`",
        Word::BrickSize | Word::Mortar => "`brick`",
        Word::NumberOfSides | Word::NumberOfTiles | Word::Pattern => "`pavement`",
        Word::Form => "`crackle` and `pavement`",
        Word::Offset | Word::Solid => "`crackle`",
        Word::Metric => "`crackle` and `facets`",
        Word::Size | Word::Coords => "`facets`",
        Word::Control0 | Word::Control1 => "`quilted`",
        Word::Interpolate => "images and `density_file`",
        Word::Exponent => "`mandel` and `julia`",
        _ => "`mandel`, `julia`, `magnet` and `pavement`",
    };
    let word = word.text();
    vm.error(place, format!("`{word}` means nothing to this pattern")).help(format!("it belongs to {owner}"))
}
