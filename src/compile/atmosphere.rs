//! Compiles what surrounds the objects.

use std::sync::Arc;

use super::Unsupported;
use super::texture::TextureCompiler;
use crate::math::noise::Octaves;
use crate::math::{DVec3, Transform};
use crate::scene::pattern::{Field, Pattern};
use crate::scene::pigment::PigmentKind;
use crate::scene::{self, Scene};
use crate::world::atmosphere::fog::{Ground, Turbulence};
use crate::world::atmosphere::{Atmosphere, Fog, Rainbow, SkySphere};

/// Distances nearer to zero than this make no fog.
const NONE: f64 = 1e-10;

/// The sky, fogs, rainbows and media of a scene. What can't be compiled goes to `lacking`.
pub fn atmosphere(
    scene: &Scene,
    textures: &mut TextureCompiler,
    lacking: &mut Vec<Unsupported>,
) -> Atmosphere {
    let sky_sphere = scene
        .sky_sphere
        .as_ref()
        .and_then(|sky| sky_sphere(sky, textures).map_err(|unsupported| lacking.push(unsupported)).ok());
    let noise_generator = scene.settings.noise_generator;
    let fogs = scene.fogs.iter().filter(|fog| fog.distance.abs() > NONE);
    let rainbows = scene.rainbows.iter().filter_map(|bow| {
        rainbow(bow, textures).map_err(|unsupported| lacking.push(unsupported)).ok().flatten()
    });
    let rainbows = rainbows.collect();
    let media = scene.atmosphere.iter().filter_map(|media| {
        textures.media(media, &Transform::IDENTITY).map_err(|unsupported| lacking.push(unsupported)).ok()
    });
    Atmosphere {
        media: media.collect(),
        background: scene.background,
        sky_sphere,
        rainbows,
        fogs: fogs.map(|written| fog(written, noise_generator)).collect(),
    }
}

fn sky_sphere(sky: &scene::SkySphere, textures: &mut TextureCompiler) -> Result<SkySphere, Unsupported> {
    let pigments = sky.pigments.iter().map(|pigment| textures.pigment(pigment));
    Ok(SkySphere { pigments: pigments.collect::<Result<_, _>>()?, emission: sky.emission })
}

fn fog(fog: &scene::Fog, noise_generator: u8) -> Fog {
    let ground = Ground { up: fog.up, offset: fog.offset, altitude: fog.altitude };
    Fog {
        distance: fog.distance,
        color: fog.color,
        ground: (fog.kind == 2).then_some(ground),
        turbulence: fog.turbulence.as_ref().map(|turbulence| Turbulence {
            amount: turbulence.amount,
            octaves: Octaves {
                count: turbulence.octaves,
                omega: f64::from(turbulence.omega),
                lambda: f64::from(turbulence.lambda),
            },
            depth: f64::from(fog.turb_depth),
            noise_generator,
        }),
    }
}

/// A rainbow; `None` where it has no colours, width or distance.
fn rainbow(bow: &scene::Rainbow, textures: &mut TextureCompiler) -> Result<Option<Rainbow>, Unsupported> {
    let Some(colors) = bow.colors.as_ref().filter(|_| bow.width != 0.0 && bow.distance != 0.0) else {
        return Ok(None);
    };
    let across = PigmentKind::Colors {
        field: Arc::new(Field::new(bow.span, Pattern::Gradient(DVec3::X))),
        map: Some(Arc::clone(colors)),
    };
    let direction = bow.direction.normalize_or_zero();
    let right = bow.up.cross(direction).normalize_or_zero();
    Ok(Some(Rainbow {
        direction,
        right,
        up: direction.cross(right).normalize_or_zero(),
        start: (bow.angle - bow.width / 2.0).to_radians(),
        width: bow.width.to_radians(),
        jitter: bow.jitter,
        distance: bow.distance,
        arc: half_arc(bow.arc_angle),
        falloff: half_arc(bow.falloff_angle),
        colors: textures.pigment(&Arc::new(scene::Pigment { kind: across, quick_color: None }))?,
    }))
}

/// Half an angle in radians. A whole circle is what was not written: POV-Ray then keeps 180 radians,
/// so that a falloff without an arc hardly fades (docs/spec/atmosphere-gi.md 1.7).
fn half_arc(degrees: f64) -> f64 {
    if degrees >= 360.0 { 180.0 } else { (degrees / 2.0).to_radians() }
}
