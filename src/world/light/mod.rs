//! Lights: what reaches a point if nothing is in the way (docs/spec/shading.md 16).

pub mod area_light;
pub mod cylinder;
pub mod reach;
pub mod set;
pub mod spotlight;

pub use area_light::{AreaLight, Plan};
pub use cylinder::Cylinder;
pub use set::LightSet;
pub use spotlight::Spotlight;

use crate::math::{DVec3, Rgb};

/// A `light_source` in world space.
#[derive(Clone, Debug)]
pub struct Light {
    /// How it is cut off.
    pub kind: Kind,
    /// Where it is; the middle of an area light.
    pub location: DVec3,
    /// Where spotlights, cylinders and parallel lights point to.
    pub point_at: DVec3,
    /// Unit vector from the location to `point_at`.
    pub axis: DVec3,
    /// Its colour; negative components darken.
    pub color: Rgb,
    /// `parallel`: rays run along the axis everywhere.
    pub parallel: bool,
    /// How it fades with distance.
    pub fade: Option<Fade>,
    /// A grid of lights instead of one.
    pub area: Option<AreaLight>,
    /// `projected_through`: the number of the object that light must come through.
    pub projected_through: Option<u32>,
    /// Without shadows and highlights.
    pub shadowless: bool,
    /// Whether media is lit by it.
    pub media_interaction: bool,
    /// Whether fog and atmospheric media dim it.
    pub media_attenuation: bool,
}

/// How a light is cut off.
#[derive(Clone, Debug)]
#[expect(missing_docs, reason = "named and described by the files")]
pub enum Kind {
    Point,
    Spotlight(Spotlight),
    Cylinder(Cylinder),
}

/// `fade_distance` and `fade_power`, both given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fade {
    /// Where the light has its nominal strength; nearer it is up to twice as bright.
    pub distance: f64,
    /// How fast it fades.
    pub power: f64,
}

/// Light on its way to a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Incident {
    /// Unit vector from the point towards the light.
    pub direction: DVec3,
    /// How far the light is; negative behind a parallel light.
    pub distance: f64,
    /// The share of the light's colour left by its shape and by the distance.
    pub attenuation: f32,
    /// What arrives if nothing is in the way.
    pub color: Rgb,
}

/// Colours whose components are all smaller than this are dark (docs/spec/shading.md 2).
const DARK: f32 = 1e-10;

impl Incident {
    /// No light.
    pub const NOTHING: Self =
        Self { direction: DVec3::ZERO, distance: 0.0, attenuation: 0.0, color: Rgb::ZERO };

    /// Whether nothing arrives.
    #[inline]
    pub fn is_dark(&self) -> bool {
        is_dark(self.color)
    }
}

/// Whether a colour counts as no light at all; negative light is light.
#[inline]
pub fn is_dark(color: Rgb) -> bool {
    color.abs().max_element() < DARK
}

impl Light {
    /// The light at `point` from the light's location; [nothing](Incident::NOTHING) where a cone clearly misses it.
    #[inline(always)]
    pub fn reaching(&self, point: DVec3) -> Incident {
        if let Some(spot) = self.cone() {
            let way = point - self.location;
            if spot.misses(way.dot(self.axis), way.length_squared()) {
                return Incident::NOTHING;
            }
        }
        self.reaching_from(point, self.location, self.axis)
    }

    /// The cone outside of which there is no light, where all of it comes from one place.
    #[inline(always)]
    fn cone(&self) -> Option<&Spotlight> {
        match &self.kind {
            Kind::Spotlight(spot) if self.area.is_none() && !self.parallel => Some(spot),
            _ => None,
        }
    }

    /// The light at `point` from a place on the area light's grid.
    pub fn reaching_from_grid(&self, point: DVec3, offset: DVec3) -> Incident {
        let (location, axis) = self.on_grid(offset);
        self.reaching_from(point, location, axis)
    }

    /// The unit direction from `point` to a place on the area light's grid, and how far that is.
    #[inline]
    pub fn way_to_grid(&self, point: DVec3, offset: DVec3) -> (DVec3, f64) {
        let (location, axis) = self.on_grid(offset);
        self.along(location - point, axis)
    }

    /// A place on the area light's grid, and where its light goes.
    #[inline]
    fn on_grid(&self, offset: DVec3) -> (DVec3, DVec3) {
        let location = self.location + offset;
        let axis = if self.parallel { (self.point_at - location).normalize_or_zero() } else { self.axis };
        (location, axis)
    }

    /// Whether light runs the same way everywhere rather than from a place.
    #[inline]
    pub fn runs_parallel(&self) -> bool {
        self.parallel || matches!(self.kind, Kind::Cylinder(_))
    }

    /// The unit direction against the light, and the distance, for a `way` to where it comes from.
    #[inline(always)]
    fn along(&self, way: DVec3, axis: DVec3) -> (DVec3, f64) {
        if self.runs_parallel() {
            return (-axis, -way.dot(axis));
        }
        let distance = way.length();
        (if distance > 0.0 { way / distance } else { DVec3::ZERO }, distance)
    }

    #[inline(always)]
    fn reaching_from(&self, point: DVec3, location: DVec3, axis: DVec3) -> Incident {
        let way = location - point;
        let (direction, distance) = self.along(way, axis);
        let everywhere = matches!(self.kind, Kind::Point) && self.fade.is_none();
        let attenuation = if everywhere { 1.0 } else { self.attenuation(way, direction, distance, axis) };
        let color = if everywhere { self.color } else { self.color * attenuation };
        Incident { direction, distance, attenuation, color }
    }

    /// The share of the light that its shape and the distance leave.
    fn attenuation(&self, way: DVec3, direction: DVec3, distance: f64, axis: DVec3) -> f32 {
        let angular = match &self.kind {
            Kind::Point => 1.0,
            // A parallel one has no cone, but a front (docs/spec/shading.md 16).
            Kind::Spotlight(_) if distance < 0.0 => 0.0,
            Kind::Spotlight(spot) => spot.attenuation(-direction.dot(axis)),
            Kind::Cylinder(cylinder) => cylinder.attenuation(-way, axis),
        };
        let fading = self.fade.map_or(1.0, |fade| fade.attenuation(distance));
        (angular * fading) as f32
    }
}

impl Fade {
    /// `2 / (1 + (d / distance)^power)`.
    fn attenuation(self, distance: f64) -> f64 {
        let ratio = distance.abs() / self.distance;
        2.0 / (1.0 + power(ratio, self.power))
    }
}

/// `base` to the power of `exponent`: by multiplication where that is a small whole number, as it
/// mostly is.
pub fn power(base: f64, exponent: f64) -> f64 {
    let whole = exponent as i32;
    if f64::from(whole) == exponent && (0..=100).contains(&whole) {
        base.powi(whole)
    } else {
        base.powf(exponent)
    }
}

/// A soft step: 0 below `low`, 1 from `high` on, `3p² - 2p³` between.
fn soften(low: f64, high: f64, x: f64) -> f64 {
    if x < low {
        0.0
    } else if x >= high {
        1.0
    } else {
        let p = (x - low) / (high - low);
        p * p * (3.0 - 2.0 * p)
    }
}

#[cfg(test)]
mod tests;
