//! `warp { … }` (docs/spec/language.md 6.11, docs/spec/patterns-textures.md 5.2).

use super::pattern::turbulence_option;
use crate::interp::{Result, Vm, Word};
use crate::math::DVec3;
use crate::scene::pattern::{BlackHole, Turbulence, Warp};

/// Reads the block; its keyword comes next.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<Warp> {
    let block = vm.enter()?;
    let warp = match vm.peek_word()? {
        Some(Word::Turbulence) => turbulence(vm)?,
        Some(Word::Repeat) => repeat(vm)?,
        Some(Word::BlackHole) => black_hole(vm)?,
        Some(Word::Spherical) => {
            let Wrap { orientation, dist_exp, .. } = wrap(vm, false)?;
            Warp::Spherical { orientation, dist_exp }
        }
        Some(Word::Cylindrical) => {
            let Wrap { orientation, dist_exp, .. } = wrap(vm, false)?;
            Warp::Cylindrical { orientation, dist_exp }
        }
        Some(Word::Toroidal) => {
            let Wrap { orientation, dist_exp, major_radius } = wrap(vm, true)?;
            Warp::Toroidal { orientation, dist_exp, major_radius }
        }
        Some(Word::Planar) => planar(vm)?,
        Some(Word::Cubic) => {
            vm.next()?;
            Warp::Cubic
        }
        _ => {
            let fault = vm.expected("a warp");
            return Err(fault.help("warps are `turbulence`, `repeat`, `black_hole`, `spherical`, `cylindrical`, `toroidal`, `planar`, `cubic`"));
        }
    };
    vm.close(block)?;
    Ok(warp)
}

fn turbulence(vm: &mut Vm<'_>) -> Result<Warp> {
    let mut turbulence = Turbulence { amount: vm.after_word(Vm::read_vector)?, ..Turbulence::default() };
    while let Some(word @ (Word::Octaves | Word::Omega | Word::Lambda)) = vm.peek_word()? {
        vm.next()?;
        turbulence_option(vm, &mut turbulence, word)?;
    }
    Ok(Warp::Turbulence(turbulence))
}

fn repeat(vm: &mut Vm<'_>) -> Result<Warp> {
    vm.next()?;
    let (width, place) = vm.located(Vm::read_vector)?;
    if width.to_array().into_iter().filter(|&w| w != 0.0).count() != 1 {
        return Err(vm
            .error(place, "a warp repeats along exactly one axis")
            .help("write one warp for each axis: `warp { repeat 2*x } warp { repeat 3*z }`"));
    }
    let (mut offset, mut flip) = (DVec3::ZERO, DVec3::ZERO);
    while let Some(word) = vm.peek_word()? {
        match word {
            Word::Offset => offset = vm.after_word(Vm::read_vector)?,
            Word::Flip => flip = vm.after_word(Vm::read_vector)?,
            _ => break,
        }
    }
    Ok(Warp::Repeat { width, offset, flip })
}

fn black_hole(vm: &mut Vm<'_>) -> Result<Warp> {
    let center = vm.after_word(Vm::read_vector)?;
    vm.comma()?;
    let radius = vm.read_float()?;
    let mut hole = BlackHole {
        center,
        radius,
        strength: 1.0,
        falloff: 2.0,
        inverse: false,
        kind: 0,
        repeat: None,
        turbulence: DVec3::ZERO,
    };
    while let Some(word) = vm.peek_word()? {
        match word {
            Word::Strength => hole.strength = vm.after_word(Vm::read_float)?,
            Word::Falloff => hole.falloff = vm.after_word(Vm::read_float)?,
            Word::Inverse => {
                vm.next()?;
                hole.inverse = true;
            }
            Word::Type => hole.kind = vm.after_word(Vm::read_count)?,
            Word::Repeat => hole.repeat = Some(vm.after_word(Vm::read_vector)?),
            Word::Turbulence => hole.turbulence = vm.after_word(Vm::read_vector)?,
            _ => break,
        }
    }
    mend_repeat(vm, &mut hole);
    Ok(Warp::BlackHole(Box::new(hole)))
}

/// The hole has to fit into each of the blocks it repeats in (docs/spec/patterns-textures.md 5.2).
fn mend_repeat(vm: &mut Vm<'_>, hole: &mut BlackHole) {
    let Some(repeat) = &mut hole.repeat else { return };
    let mut mended = false;
    for axis in 0..3 {
        if repeat[axis] > 0.0 {
            hole.center[axis] = hole.center[axis].max(hole.radius);
            let least = hole.center[axis] + hole.radius + hole.turbulence[axis];
            mended |= repeat[axis] < least;
            repeat[axis] = repeat[axis].max(least);
        }
    }
    if mended {
        vm.warn(vm.last, "this black hole repeats in blocks too small for it", "the blocks are made larger");
    }
}

/// What the warps that wrap a pattern around something share.
struct Wrap {
    orientation: DVec3,
    dist_exp: f64,
    major_radius: f64,
}

fn wrap(vm: &mut Vm<'_>, toroidal: bool) -> Result<Wrap> {
    vm.next()?;
    let mut wrap = Wrap { orientation: DVec3::Z, dist_exp: 0.0, major_radius: 1.0 };
    while let Some(word) = vm.peek_word()? {
        match word {
            Word::Orientation => wrap.orientation = vm.after_word(direction)?,
            Word::DistExp => wrap.dist_exp = vm.after_word(Vm::read_float)?,
            Word::MajorRadius if toroidal => wrap.major_radius = vm.after_word(Vm::read_float)?,
            _ => break,
        }
    }
    Ok(wrap)
}

fn planar(vm: &mut Vm<'_>) -> Result<Warp> {
    vm.next()?;
    let (mut orientation, mut distance) = (DVec3::Z, 0.0);
    if vm.at_number()? {
        orientation = direction(vm)?;
        vm.comma()?;
        distance = vm.read_float()?;
    }
    Ok(Warp::Planar { orientation, distance })
}

fn direction(vm: &mut Vm<'_>) -> Result<DVec3> {
    let direction = vm.read_vector()?;
    Ok(direction.normalize_or_zero())
}
