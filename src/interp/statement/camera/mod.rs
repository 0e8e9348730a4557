//! `camera { … }` (docs/spec/camera-image.md 3).

mod assemble;
mod mesh_camera;

pub(in crate::interp) use assemble::Draft;

use std::sync::Arc;

use super::pattern::Owner;
use super::{normal, pigment, transform};
use crate::interp::limits::MOST_BLUR_SAMPLES;
use crate::interp::value::Value;
use crate::interp::{Block, Result, Vm, Word};
use crate::scene::Camera;
use crate::scene::camera::Projection;
use crate::source::Span;

/// Reads `camera { … }`, whose keyword comes next. Items act in a fixed order since version 3.5,
/// before that in the order they are written.
pub(in crate::interp) fn block(vm: &mut Vm<'_>) -> Result<Camera> {
    let block = vm.enter()?;
    let named = vm.accept_value(|value| match value {
        Value::Camera(camera) => Some(Camera::clone(camera)),
        _ => None,
    })?;
    if let Some(mut camera) = named {
        camera.span = block.span;
        if vm.version >= 350 {
            while let Some(by) = transform::item(vm)? {
                assemble::apply(&mut camera, &by);
            }
            vm.close(block)?;
            return Ok(camera);
        }
        let mut draft = Draft::of(&camera);
        read(vm, &mut draft, block)?;
        return draft.finish(vm, block.span);
    }
    let mut draft = vm.state.camera.clone();
    read(vm, &mut draft, block)?;
    if vm.version < 350 {
        // A later camera goes on from this one.
        vm.state.camera = draft.clone();
    }
    draft.finish(vm, block.span)
}

/// Reads `camera { … }` in `#default`: what later cameras start from.
pub(super) fn default(vm: &mut Vm<'_>) -> Result<()> {
    let block = vm.enter()?;
    let mut draft = vm.state.camera.clone();
    read(vm, &mut draft, block)?;
    vm.state.camera = draft;
    Ok(())
}

fn read(vm: &mut Vm<'_>, draft: &mut Draft, block: Block) -> Result<()> {
    let old = vm.version < 350;
    while let Some(word) = vm.peek_word()? {
        if kind(vm, draft, word)? {
            if old {
                draft.act_on_type();
            }
            continue;
        }
        break;
    }
    loop {
        if let Some(by) = transform::item(vm)? {
            draft.transform = draft.transform.then(&by);
            if old {
                draft.act_on_transform();
            }
            continue;
        }
        let Some(word) = vm.peek_word()? else { break };
        if !item(vm, draft, word, old)? {
            if old && kind(vm, draft, word)? {
                draft.act_on_type();
                continue;
            }
            if is_kind(word) {
                let token = vm.peek()?;
                return Err(vm.misplaced(block, token).help("the type of a camera comes first in its block"));
            }
            break;
        }
    }
    vm.close(block)?;
    Ok(())
}

fn is_kind(word: Word) -> bool {
    use Word::*;
    matches!(
        word,
        Perspective
            | Orthographic
            | Fisheye
            | UltraWideAngle
            | Omnimax
            | Panoramic
            | Spherical
            | Cylinder
            | MeshCamera
    )
}

/// Reads the type of the camera.
fn kind(vm: &mut Vm<'_>, draft: &mut Draft, word: Word) -> Result<bool> {
    let projection = match word {
        Word::Perspective => Projection::Perspective,
        Word::Orthographic => Projection::Orthographic,
        Word::Fisheye => Projection::Fisheye,
        Word::UltraWideAngle => Projection::UltraWideAngle,
        Word::Omnimax => Projection::Omnimax,
        Word::Panoramic => Projection::Panoramic,
        Word::Spherical => Projection::Spherical { horizontal: 360.0, vertical: 180.0 },
        Word::Cylinder => {
            vm.next()?;
            let (kind, place) = vm.located(Vm::read_int)?;
            if !(1..=4).contains(&kind) {
                return Err(vm
                    .error(place, format!("there is no cylinder camera of type {kind}"))
                    .help("types are 1 to 4"));
            }
            draft.projection = Projection::Cylinder(kind as u32);
            return Ok(true);
        }
        Word::MeshCamera => {
            draft.projection = Projection::Mesh(Arc::new(mesh_camera::read(vm)?));
            return Ok(true);
        }
        _ => return Ok(false),
    };
    vm.next()?;
    draft.projection = projection;
    Ok(true)
}

fn item(vm: &mut Vm<'_>, draft: &mut Draft, word: Word, old: bool) -> Result<bool> {
    match word {
        Word::Location => draft.location = vm.after_word(Vm::read_vector)?,
        Word::Direction => draft.direction = vm.after_word(Vm::read_vector)?,
        Word::Sky => draft.sky = vm.after_word(Vm::read_vector)?,
        Word::Up => {
            draft.up = vm.after_word(Vm::read_vector)?;
            draft.sized = true;
        }
        Word::Right => {
            draft.right = vm.after_word(Vm::read_vector)?;
            draft.sized = true;
        }
        Word::LookAt => {
            vm.next()?;
            let (point, place) = vm.located(Vm::read_vector)?;
            draft.look_at = Some((point, place));
            if old {
                draft.act_on_look_at(vm)?;
            }
        }
        Word::Angle => {
            angle(vm, draft)?;
            if old {
                draft.act_on_angle();
            }
        }
        Word::FocalPoint => {
            draft.focal_point = Some(vm.after_word(Vm::read_vector)?);
            if old {
                draft.act_on_focal_point();
            }
        }
        Word::Aperture => draft.aperture = vm.after_word(Vm::read_float)?,
        Word::BlurSamples => blur_samples(vm, draft, old)?,
        Word::Confidence => {
            vm.next()?;
            let (value, place) = vm.located(Vm::read_float)?;
            if value > 0.0 && value < 1.0 {
                draft.confidence = value;
            } else {
                vm.warn(place, "`confidence` lies between 0 and 1", "0.9 is taken");
            }
        }
        Word::Variance => {
            vm.next()?;
            let (value, place) = vm.located(Vm::read_float)?;
            if (0.0..=1.0).contains(&value) {
                draft.variance = value;
            } else {
                vm.warn(place, "`variance` lies between 0 and 1", "1/10000 is taken");
            }
        }
        Word::Bokeh => {
            let block = vm.enter()?;
            while vm.peek_word()? == Some(Word::Pigment) {
                let inner = vm.enter()?;
                let empty = vm.state.empty();
                draft.bokeh = Some(pigment::body(vm, &empty, Owner::Pigment)?);
                vm.close(inner)?;
            }
            vm.close(block)?;
        }
        Word::Normal => draft.normal = Some(normal::block(vm, draft.normal.as_ref())?),
        _ => return Ok(false),
    }
    Ok(true)
}

/// Reads `angle`: optional for an orthographic camera, two for a spherical one.
fn angle(vm: &mut Vm<'_>, draft: &mut Draft) -> Result<()> {
    let keyword = vm.next()?.span;
    let read = |vm: &mut Vm<'_>| -> Result<f64> {
        let (angle, place) = vm.located(Vm::read_float)?;
        check_angle(vm, angle, place)?;
        Ok(angle)
    };
    match &mut draft.projection {
        Projection::Spherical { horizontal, vertical } => {
            *horizontal = read(vm)?;
            *vertical = *horizontal / 2.0;
            vm.comma()?;
            if vm.at_number()? {
                *vertical = read(vm)?;
            }
            return Ok(());
        }
        Projection::Mesh(_) => return Err(vm.error(keyword, "a mesh_camera has no angle")),
        Projection::Orthographic if !vm.at_number()? => {
            draft.angle = Some(0.0);
            return Ok(());
        }
        _ => {}
    }
    let angle = read(vm)?;
    if angle >= 180.0 && matches!(draft.projection, Projection::Perspective | Projection::Orthographic) {
        return Err(vm
            .error(keyword.to(vm.last), format!("a camera of this type cannot see {angle} degrees"))
            .help("stay below 180, or use a `fisheye`, `panoramic` or `spherical` camera"));
    }
    draft.angle = Some(angle);
    Ok(())
}

fn check_angle(vm: &Vm<'_>, angle: f64, place: Span) -> Result<()> {
    if angle >= 0.0 {
        return Ok(());
    }
    Err(vm.error(place, "the angle of a camera cannot be negative"))
}

fn blur_samples(vm: &mut Vm<'_>, draft: &mut Draft, old: bool) -> Result<()> {
    vm.next()?;
    let count = |vm: &mut Vm<'_>| vm.read_at_most("blur_samples", MOST_BLUR_SAMPLES);
    let (first, place) = vm.located(count)?;
    vm.comma()?;
    let second = if !old && vm.at_number()? { Some(count(vm)?) } else { None };
    let place = place.to(vm.last);
    let (least, most) = match second {
        Some(most) => (first, most),
        None => (0, first),
    };
    if first <= 0 || most <= 0 {
        return Err(vm.error(place, "`blur_samples` is above 0"));
    }
    if least > most {
        return Err(vm
            .error(place, "the least blur samples are more than the most")
            .help("write the smaller number first"));
    }
    draft.blur_samples = [least as u32, most as u32];
    Ok(())
}
