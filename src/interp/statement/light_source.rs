//! `light_source { <location> [,] color … }` (docs/spec/language.md 6.4, docs/spec/shading.md 16 to 18).

use std::sync::Arc;

use super::{color, map, modifier, object, photons, transform};
use crate::interp::limits::MOST_LIGHTS;
use crate::interp::{Block, Result, Vm, Word};
use crate::math::{DVec3, Rgb, Transform};
use crate::scene::depth::Nested;
use crate::scene::light::{AreaLight, Light, LightKind};
use crate::scene::object::ObjectFlags;
use crate::scene::{Object, Shape};
use crate::source::Span;

/// Lengths of axes that differ by less, relative to them, are the same but for rounding.
const ALIKE: f64 = 1e-10;

/// Reads the rest of the statement after its brace.
pub(super) fn read(vm: &mut Vm<'_>, block: Block) -> Result<Object> {
    let location = vm.read_vector()?;
    vm.comma()?;
    let color = if vm.at_color()? || vm.at_number()? { color::rgb(vm)? } else { Rgb::ZERO };
    let mut light = Light {
        kind: LightKind::Point,
        location,
        color,
        point_at: DVec3::Z,
        parallel: false,
        fade_distance: 0.0,
        fade_power: 0.0,
        area: None,
        looks_like: None,
        projected_through: None,
        media_interaction: true,
        media_attenuation: false,
        photons: None,
    };
    while let Some(word) = vm.peek_word()? {
        if !item(vm, &mut light, word)? {
            break;
        }
    }
    vm.close(block)?;
    if let Some(area) = &mut light.area
        && area.orient
        && !area.circular
    {
        vm.warn(
            block.span,
            "only a circular area light can `orient`, so this one is circular now",
            "write `circular` too",
        );
        area.circular = true;
    }
    if let Some(area) = &mut light.area
        && area.orient
    {
        let [first, second] = area.axes.map(DVec3::length);
        if (first - second).abs() > ALIKE * first.max(second) {
            vm.warn(
                block.span,
                "the axes of an area light that can `orient` have the same length: that of the first one",
                "write a second axis as long as the first",
            );
            area.axes[1] *= if second > 0.0 { first / second } else { 0.0 };
        }
    }
    Ok(Object::new(block.span, Shape::Light(Arc::new(light))))
}

fn item(vm: &mut Vm<'_>, light: &mut Light, word: Word) -> Result<bool> {
    if let Some(by) = transform::item(vm)? {
        apply(light, &by);
        return Ok(true);
    }
    match word {
        Word::Spotlight => {
            vm.next()?;
            light.kind = LightKind::Spot { radius: 30.0, falloff: 45.0, tightness: 0.0 };
        }
        Word::Cylinder => {
            vm.next()?;
            light.kind = LightKind::Cylinder { radius: 0.75, falloff: 1.0, tightness: 0.0 };
            light.parallel = true;
        }
        Word::Parallel => {
            vm.next()?;
            light.parallel = true;
        }
        Word::PointAt => {
            let place = vm.next()?.span;
            if matches!(light.kind, LightKind::Point | LightKind::Shadowless) && !light.parallel {
                return Err(vm
                    .error(place, "a light that shines everywhere points at nothing")
                    .help("write `spotlight`, `cylinder` or `parallel` before `point_at`"));
            }
            light.point_at = vm.read_vector()?;
        }
        Word::Radius | Word::Falloff | Word::Tightness => cone(vm, light, word)?,
        Word::FadeDistance => light.fade_distance = vm.after_word(Vm::read_float)?,
        Word::FadePower => light.fade_power = vm.after_word(Vm::read_float)?,
        Word::Shadowless => {
            vm.next()?;
            light.kind = LightKind::Shadowless;
        }
        Word::MediaInteraction => light.media_interaction = vm.after_word(Vm::read_flag)?,
        Word::MediaAttenuation => light.media_attenuation = vm.after_word(Vm::read_flag)?,
        Word::Photons => light.photons = Some(photons::of_light(vm)?),
        Word::LooksLike => looks_like(vm, light)?,
        Word::ProjectedThrough => projected_through(vm, light)?,
        Word::ColorMap | Word::ColourMap => {
            let spectrum = map::colors(vm)?;
            light.color = spectrum.entries.iter().map(|&(share, color)| color.rgb * share).sum();
        }
        Word::AreaLight => {
            vm.next()?;
            light.area = Some(area_light(vm)?);
        }
        Word::Adaptive | Word::Jitter | Word::Circular | Word::Orient | Word::AreaIllumination => {
            area_option(vm, light, word)?;
        }
        _ => return Ok(false),
    }
    Ok(true)
}

/// Reads `radius`, `falloff` or `tightness`.
fn cone(vm: &mut Vm<'_>, light: &mut Light, word: Word) -> Result<()> {
    let place = vm.next()?.span;
    let (LightKind::Spot { radius, falloff, tightness } | LightKind::Cylinder { radius, falloff, tightness }) =
        &mut light.kind
    else {
        return Err(vm
            .error(place, format!("`{}` belongs to a spotlight or cylinder", word.text()))
            .help("write `spotlight` or `cylinder` before it"));
    };
    let value = vm.read_float()?;
    match word {
        Word::Radius => *radius = value,
        Word::Falloff => *falloff = value,
        _ => *tightness = value,
    }
    Ok(())
}

fn area_light(vm: &mut Vm<'_>) -> Result<AreaLight> {
    let first = vm.read_vector()?;
    vm.comma()?;
    let second = vm.read_vector()?;
    vm.comma()?;
    let mut size = [0; 2];
    let start = vm.here()?;
    for count in &mut size {
        let (value, place) = vm.located(Vm::read_int)?;
        *count = match u32::try_from(value.abs()) {
            Ok(value) if value > 0 => value,
            _ => return Err(vm.error(place, "an area light has at least one light along each edge")),
        };
        vm.comma()?;
    }
    let points = size.into_iter().map(u64::from).product::<u64>();
    if points > MOST_LIGHTS {
        let message = format!("an area light has at most {MOST_LIGHTS} points, not {points}");
        return Err(vm
            .error(start.to(vm.last), message)
            .help("`adaptive 1` and `jitter` make few of them look soft"));
    }
    Ok(AreaLight {
        axes: [first, second],
        size,
        adaptive: 100,
        jitter: false,
        circular: false,
        orient: false,
        area_illumination: false,
    })
}

fn area_option(vm: &mut Vm<'_>, light: &mut Light, word: Word) -> Result<()> {
    let place = vm.next()?.span;
    let number = match word {
        Word::Adaptive => vm.read_count()?,
        Word::AreaIllumination => u32::from(vm.read_flag()?),
        _ => 1,
    };
    let early = format!("`{}` comes before `area_light`", word.text());
    let help = "write `area_light` and its size first";
    if light.area.is_none() && word == Word::Circular && vm.accept(Word::AreaLight)? {
        vm.warn(place, early.as_str(), help);
        light.area = Some(area_light(vm)?);
    }
    let Some(area) = &mut light.area else {
        match word {
            Word::Circular => return Err(vm.error(place, early).help(help)),
            Word::Adaptive | Word::Jitter => {}
            _ => vm.warn(place, early, "it has no effect here"),
        }
        return Ok(());
    };
    match word {
        Word::Adaptive => area.adaptive = number,
        Word::Jitter => area.jitter = true,
        Word::Orient => area.orient = true,
        Word::AreaIllumination => area.area_illumination = number > 0,
        _ => {
            if area.size.contains(&1) {
                return Err(vm
                    .error(place, "a circular area light is at least 2 lights wide")
                    .help("raise both numbers after `area_light`"));
            }
            area.circular = true;
        }
    }
    Ok(())
}

/// Reads `looks_like { object … }`: the object goes where the light is, and casts no shadow.
fn looks_like(vm: &mut Vm<'_>, light: &mut Light) -> Result<()> {
    let mut object = attached(vm, light.looks_like.is_some())?;
    object.apply(&Transform::translate(light.location));
    object.flags |= ObjectFlags::NO_SHADOW;
    light.looks_like = Some(Nested::new(Arc::new(object)));
    Ok(())
}

fn projected_through(vm: &mut Vm<'_>, light: &mut Light) -> Result<()> {
    let object = attached(vm, light.projected_through.is_some())?;
    light.projected_through = Some(Nested::new(Arc::new(object)));
    Ok(())
}

fn attached(vm: &mut Vm<'_>, taken: bool) -> Result<Object> {
    let block = vm.enter()?;
    if taken {
        return Err(once(vm, block.keyword, block.span));
    }
    let Some(object) = object::any(vm)? else { return Err(vm.expected("an object")) };
    let mut object = Arc::unwrap_or_clone(object);
    while modifier::read(vm, &mut object)? {}
    vm.close(block)?;
    Ok(object)
}

fn once(vm: &Vm<'_>, word: Word, place: Span) -> crate::interp::Fault {
    let word = word.text();
    vm.error(place, format!("this light has a `{word}` already")).help("join the objects in a `union`")
}

/// Moves a light and what is attached to it.
fn apply(light: &mut Light, by: &Transform) {
    light.location = by.point(light.location);
    light.point_at = by.point(light.point_at);
    if let Some(area) = &mut light.area {
        area.axes = area.axes.map(|axis| by.vector(axis));
    }
    for object in light.looks_like.iter_mut().chain(&mut light.projected_through) {
        Arc::make_mut(object.inside_mut()).apply(by);
    }
}
