//! `mandel`, `julia` and `magnet` (docs/spec/patterns-textures.md 2.5).

use crate::interp::limits::MOST_ITERATIONS;
use crate::interp::{Result, Vm, Word};
use crate::scene::Pattern;
use crate::scene::pattern::{Fractal, FractalKind};

/// Reads one of the three and its iterations.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<Pattern> {
    let mut kind = FractalKind::Mandel;
    if vm.accept(Word::Magnet)? {
        let (number, place) = vm.located(Vm::read_int)?;
        kind = match number {
            1 => FractalKind::Magnet1,
            2 => FractalKind::Magnet2,
            _ => {
                return Err(vm
                    .error(place, format!("there is no `magnet {number}`"))
                    .help("write `magnet 1` or `magnet 2`"));
            }
        };
    }
    let (julia, word) = if vm.accept(Word::Julia)? {
        let constant = vm.read_uv()?;
        vm.comma()?;
        (Some(constant), Word::Julia)
    } else if vm.accept(Word::Mandel)? {
        (None, Word::Mandel)
    } else {
        return Err(vm.expected("`mandel` or `julia`"));
    };
    let iterations = vm.read_at_most(word.text(), MOST_ITERATIONS)?.max(0) as u32;
    Ok(Pattern::Fractal(Box::new(Fractal {
        kind,
        julia,
        iterations,
        exponent: 2,
        interior: (0, 1.0),
        exterior: (1, 1.0),
    })))
}

/// Reads the value of `exponent`, `interior` or `exterior`, whose word has been taken.
pub(super) fn option(vm: &mut Vm<'_>, fractal: &mut Fractal, word: Word) -> Result<()> {
    if word == Word::Exponent && fractal.kind != FractalKind::Mandel {
        return Err(vm.error(vm.last, "`magnet` has no exponent").help("only `mandel` and `julia` have one"));
    }
    let (number, place) = vm.located(Vm::read_int)?;
    if word == Word::Exponent {
        fractal.exponent = if (2..=33).contains(&number) {
            number as u32
        } else {
            vm.warn(place, format!("the exponent is 2 to 33, not {number}"), "2 is taken");
            2
        };
        return Ok(());
    }
    let (most, target) = match word {
        Word::Interior => (6, &mut fractal.interior),
        _ => (8, &mut fractal.exterior),
    };
    if !(0..=most).contains(&number) {
        return Err(vm.error(place, format!("the types of `{}` are 0 to {most}, not {number}", word.text())));
    }
    vm.comma()?;
    *target = (number as u32, vm.read_float()?);
    Ok(())
}
