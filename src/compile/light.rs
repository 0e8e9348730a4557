//! Compiles light sources.

use crate::math::Transform;
use crate::scene;
use crate::scene::light::LightKind;
use crate::world::Light;
use crate::world::light::{AreaLight, Cylinder, Fade, Kind, Plan, Spotlight};

/// A light of a world.
///
/// `transform` leads from the light's statement to the world; radii and fade distances don't follow
/// it. `projected_through` is the number of the object compiled from [`scene::Light::projected_through`].
pub fn light(light: &scene::Light, transform: &Transform, projected_through: Option<u32>) -> Light {
    let axis = (light.point_at - light.location).normalize_or_zero();
    Light {
        kind: match light.kind {
            LightKind::Point | LightKind::Shadowless => Kind::Point,
            LightKind::Spot { radius, falloff, tightness } => {
                Kind::Spotlight(Spotlight::new(radius, falloff, tightness))
            }
            LightKind::Cylinder { radius, falloff, tightness } => {
                Kind::Cylinder(Cylinder { radius, falloff, tightness })
            }
        },
        location: transform.point(light.location),
        point_at: transform.point(light.point_at),
        axis: transform.vector(axis).normalize_or_zero(),
        color: light.color,
        parallel: light.parallel,
        fade: fade(light),
        area: light.area.as_ref().map(|area| area_light(area, transform)),
        projected_through,
        shadowless: light.kind == LightKind::Shadowless,
        media_interaction: light.media_interaction,
        media_attenuation: light.media_attenuation,
    }
}

/// Distance and power do nothing alone (docs/spec/shading.md 16).
fn fade(light: &scene::Light) -> Option<Fade> {
    let fades = light.fade_power > 0.0 && light.fade_distance.abs() > 1e-10;
    fades.then_some(Fade { distance: light.fade_distance, power: light.fade_power })
}

fn area_light(area: &scene::light::AreaLight, transform: &Transform) -> AreaLight {
    let circular = area.circular || area.orient;
    AreaLight {
        axes: area.axes.map(|axis| transform.vector(axis)),
        size: area.size,
        adaptive: area.adaptive,
        jitter: area.jitter,
        circular,
        orient: area.orient,
        area_illumination: area.area_illumination,
        plan: Plan::new(area.size, area.adaptive, circular),
    }
}
