//! `fog`: constant, or lying on the ground (docs/spec/atmosphere-gi.md 1.6).

use super::{FAR, Veil};
use crate::math::color::grey;
use crate::math::noise::Octaves;
use crate::math::{DVec3, Rgb, Rgbft};
use crate::world::Ray;

/// Heights nearer to each other than this count as one.
const LEVEL: f64 = 1e-10;

/// A fog.
#[derive(Clone, Debug)]
pub struct Fog {
    /// Distance at which 1/e of the light is left, not zero.
    pub distance: f64,
    /// Its colour; `filter` tints what is behind, `transmit` is the least it leaves of it.
    pub color: Rgbft,
    /// Where it is thinner, of a ground fog.
    pub ground: Option<Ground>,
    /// Uneven thickness.
    pub turbulence: Option<Turbulence>,
}

/// Where a ground fog lies.
#[derive(Clone, Debug)]
pub struct Ground {
    /// Unit vector away from the ground.
    pub up: DVec3,
    /// Height up to which the fog is dense.
    pub offset: f64,
    /// Height over which it thins out.
    pub altitude: f64,
}

/// The unevenness of a fog.
#[derive(Clone, Debug)]
pub struct Turbulence {
    /// Scale of the noise along each axis.
    pub amount: DVec3,
    /// Its octaves.
    pub octaves: Octaves,
    /// Its strength along the ray.
    pub depth: f64,
    /// 1, 2 or 3.
    pub noise_generator: u8,
}

/// What all fogs together do to light from `distance` along the ray.
pub(super) fn veil(fogs: &[Fog], ray: &Ray, distance: f64) -> Veil {
    let mut veil = Veil::NONE;
    for fog in fogs {
        let left = fog.transmittance(ray, distance.min(FAR)) as f32;
        veil.added += fog.color.rgb * (1.0 - left);
        veil.factor *= (Rgb::splat(1.0 - fog.color.filter) + fog.color.rgb * fog.color.filter) * left;
    }
    veil.transmit = grey(veil.factor);
    veil
}

impl Fog {
    /// The share of light left after `distance`.
    fn transmittance(&self, ray: &Ray, distance: f64) -> f64 {
        let density = self.ground.as_ref().map_or(1.0, |ground| ground.density(ray.origin, ray.at(distance)));
        let length = match &self.turbulence {
            Some(turbulence) => turbulence.lengthen(ray.at(distance / 2.0), distance, self.distance),
            None => distance,
        };
        // A negative distance brightens, but not without end.
        let left = (-length * density / self.distance).min(80.0).exp();
        left.max(f64::from(self.color.transmit))
    }
}

impl Ground {
    /// The mean density on the way from `start` to `end`: 1 below the offset, `1 / (1 + y²)` above.
    fn density(&self, start: DVec3, end: DVec3) -> f64 {
        let height = |point: DVec3| (point.dot(self.up) - self.offset) / self.altitude;
        let (s, e) = (height(start), height(end));
        match (s <= 0.0, e <= 0.0) {
            (true, true) => 1.0,
            (true, false) => (e.atan() - s) / (e - s),
            (false, true) => (s.atan() - e) / (s - e),
            (false, false) if (s - e).abs() > LEVEL => (s.atan() - e.atan()) / (s - e),
            (false, false) => 1.0 / (1.0 + s * s),
        }
    }
}

impl Turbulence {
    /// The length a way of fog counts for, given its middle.
    fn lengthen(&self, middle: DVec3, length: f64, distance: f64) -> f64 {
        let noise = self.octaves.scalar(self.noise_generator, middle * self.amount);
        length * (1.0 - (-length / distance).min(80.0).exp() * (noise * self.depth).min(1.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fog(color: [f32; 5], distance: f64) -> Fog {
        Fog { distance, color: Rgbft::new(color), ground: None, turbulence: None }
    }

    /// The blue wall 10 units away of docs/spec/atmosphere-gi.md 1.9.
    fn wall(fogs: &[Fog]) -> Rgb {
        let veil = veil(fogs, &Ray::new(DVec3::ZERO, DVec3::Z), 10.0);
        veil.added + veil.factor * Rgb::new(0.2, 0.4, 0.8)
    }

    #[test]
    fn fog_hides_with_distance_as_the_probes_show() {
        let rows = [
            ([1.0, 0.5, 0.0, 0.0, 0.0], [0.7057, 0.4632, 0.2943]),
            ([1.0, 0.5, 0.0, 0.0, 0.6], [0.5200, 0.4400, 0.4800]),
            ([1.0, 0.5, 0.0, 0.5, 0.0], [0.7057, 0.4264, 0.1472]),
            ([1.0, 0.5, 0.0, 0.5, 0.5], [0.6000, 0.4000, 0.2000]),
        ];
        for (color, observed) in rows {
            let ours = wall(&[fog(color, 10.0)]);
            assert!(ours.abs_diff_eq(Rgb::from_array(observed), 1e-4), "{color:?}: {ours}");
        }
    }

    #[test]
    fn fogs_do_not_hide_each_other() {
        let both = wall(&[fog([1.0, 0.5, 0.0, 0.0, 0.0], 10.0), fog([0.0, 0.0, 1.0, 0.0, 0.0], 20.0)]);
        assert!(both.abs_diff_eq(Rgb::new(0.6768, 0.4053, 0.5720), 1e-4), "{both}");
    }

    #[test]
    fn ground_fog_thins_out_above_its_offset() {
        let ground = Ground { up: DVec3::Y, offset: 1.0, altitude: 2.0 };
        let up = |y: f64| DVec3::Y * y;
        assert_eq!(ground.density(up(0.5), up(0.9)), 1.0);
        assert!((ground.density(up(3.0), up(3.0)) - 0.5).abs() < 1e-15);
        assert!((ground.density(up(1.0), up(3.0)) - 1f64.atan()).abs() < 1e-15);
        let (there, back) = (ground.density(up(-2.0), up(7.0)), ground.density(up(7.0), up(-2.0)));
        assert!((there - back).abs() < 1e-15);
    }
}
