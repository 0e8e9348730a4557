//! Reflection: how much, and where to (docs/spec/shading.md 14).

use super::finish::metallic;
use crate::math::{DVec3, Lanes, Rgb, unit};
use crate::world::texture::Reflection;

/// Share of light reflected, and the share that counts against `adc_bailout`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Reflectivity {
    /// Per channel.
    pub(super) color: Rgb,
    /// The greatest share the finish could have asked for.
    pub(super) weight: f32,
}

/// How much of the light from the mirrored direction is seen.
///
/// `cosine` is that between the normal and the way back to the eye; `index` the refractive index of
/// the other side over this side's; `color` the pigment's.
#[inline]
pub(super) fn reflectivity(reflection: &Reflection, cosine: f64, index: f64, color: Rgb) -> Reflectivity {
    of_share(reflection, cosine, share(reflection, cosine, index), color)
}

/// How far reflectivity is from its least to its greatest.
#[inline]
pub(super) fn share(reflection: &Reflection, cosine: f64, index: f64) -> f32 {
    if reflection.fresnel {
        return fresnel(index, cosine) as f32;
    }
    let share = (1.0 - cosine).max(0.0);
    (if reflection.falloff == 1.0 { share } else { share.powf(f64::from(reflection.falloff)) }) as f32
}

/// The reflectivity so far from its least to its greatest.
#[inline]
pub(super) fn of_share(reflection: &Reflection, cosine: f64, share: f32, color: Rgb) -> Reflectivity {
    let Reflection { min, max, .. } = *reflection;
    let plain = max * share + min * (1.0 - share);
    let weight =
        if reflection.fresnel { plain.max_element() } else { min.max_element().max(max.max_element()) };
    let tint = match reflection.metallic {
        0.0 => Rgb::ONE,
        amount => metallic(amount, color, cosine),
    };
    Reflectivity { color: plain * tint, weight }
}

/// Fresnel's share of unpolarised light; 1 beyond the critical angle.
#[inline]
fn fresnel(index: f64, cosine: f64) -> f64 {
    let square = index * index + cosine * cosine - 1.0;
    if square <= 0.0 {
        return 1.0;
    }
    let g = square.sqrt();
    let (sum, difference) = (g + cosine, g - cosine);
    let ratio = difference / sum;
    let parallel = (cosine * sum - 1.0) / (cosine * difference + 1.0);
    (0.5 * ratio * ratio * (1.0 + parallel * parallel)).clamp(0.0, 1.0)
}

/// [`fresnel`] of four cosines.
#[inline(always)]
pub(super) fn fresnel_of_four(index: f64, cosine: Lanes) -> Lanes {
    let square = cosine * cosine + index * index - 1.0;
    let g = square.sqrt();
    let (sum, difference) = (g + cosine, g - cosine);
    let ratio = difference / sum;
    let parallel = (cosine * sum - 1.0) / (cosine * difference + 1.0);
    let share = ratio * 0.5 * ratio * (parallel * parallel + 1.0);
    share.zip(square, |share, square| if square <= 0.0 { 1.0 } else { share.clamp(0.0, 1.0) })
}

/// [`mirrored`] of four directions at surfaces without bumps that face them.
#[inline(always)]
pub(super) fn mirrored_of_four(direction: &[Lanes; 3], normal: &[Lanes; 3]) -> [Lanes; 3] {
    let twice = Lanes::dot(direction, normal) * 2.0;
    let mut reflected = *direction;
    for axis in 0..3 {
        reflected[axis] = reflected[axis] - twice * normal[axis];
    }
    let inverse = Lanes::splat(1.0) / Lanes::dot(&reflected, &reflected).sqrt();
    for along in &mut reflected {
        *along = *along * inverse;
    }
    reflected
}

/// The unit direction in which a surface with the bent normal `normal` mirrors `direction`.
///
/// `raw` is the unbent normal, facing the ray: no reflection goes into the surface.
#[inline]
pub(super) fn mirrored(direction: DVec3, normal: DVec3, raw: DVec3) -> DVec3 {
    let reflected = direction.reflect(normal);
    let reflected = if reflected.dot(raw) >= 0.0 {
        reflected
    } else if reflected.dot(normal) < 0.0 {
        direction.reflect(raw)
    } else {
        reflected.reflect(raw)
    };
    unit(reflected)
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::math::dice::numbers;
    use crate::world::{Ray, Rays};

    /// Unit directions of four rays, each with a unit normal that faces it as origin.
    pub(in crate::render) fn four_facing(number: &mut impl FnMut() -> f64) -> [Ray; Lanes::COUNT] {
        [(); Lanes::COUNT].map(|()| {
            let mut vector = || DVec3::new(number(), number(), number()).normalize();
            let (direction, normal) = (vector(), vector());
            Ray::new(if normal.dot(direction) > 0.0 { -normal } else { normal }, direction)
        })
    }

    /// Rows of docs/spec/shading.md 14: a 45 degree mirror under a sky `rgb <.2,.6,.9>`.
    #[test]
    fn reflectivity_depends_on_the_angle_as_the_probes_show() {
        let cosine = 0.5f64.sqrt();
        let plain = |min: f32, max: f32| Reflection {
            min: Rgb::splat(min),
            max: Rgb::splat(max),
            fresnel: false,
            falloff: 1.0,
            exponent: 1.0,
            metallic: 0.0,
        };
        let (between, half) = (plain(0.1, 0.9), plain(0.5, 0.5));
        let glass = Reflection { fresnel: true, ..plain(0.0, 1.0) };
        let tinted = Rgb::new(0.8, 0.4, 0.2);
        let rows = [
            (between.clone(), [0.06687, 0.20060, 0.30088]),
            (Reflection { falloff: 3.0, ..between }, [0.02402, 0.07205, 0.10809]),
            (glass, [0.01004, 0.03014, 0.04521]),
            (Reflection { metallic: 1.0, ..half.clone() }, [0.08052, 0.12473, 0.09946]),
            (Reflection { metallic: 0.5, ..half }, [0.09026, 0.21236, 0.27472]),
        ];
        for (reflection, observed) in rows {
            let share = reflectivity(&reflection, cosine, 1.5, tinted).color;
            let ours = share * Rgb::new(0.2, 0.6, 0.9);
            assert!(ours.abs_diff_eq(Rgb::from_array(observed), 3e-5), "{reflection:?}: {ours}");
        }
    }

    #[test]
    fn four_rays_are_mirrored_as_each_alone() {
        let mut number = numbers(7);
        for turn in 0..1000 {
            let rays = four_facing(&mut number);
            let many = Rays::of(&rays);
            let cosine = -Lanes::dot(&many.direction, &many.origin);
            let index = if turn % 2 == 0 { 1.5 } else { 1.0 / 1.5 };
            let back = mirrored_of_four(&many.direction, &many.origin);
            let share = fresnel_of_four(index, cosine);
            for (lane, Ray { origin: normal, direction }) in rays.into_iter().enumerate() {
                assert_eq!(Lanes::point(&back, lane), mirrored(direction, normal, normal));
                assert_eq!(share.0[lane], fresnel(index, -direction.dot(normal)));
            }
        }
    }

    #[test]
    fn bent_normals_never_reflect_into_the_surface() {
        let raw = -DVec3::Z;
        for degrees in -80..=80 {
            let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
            let normal = DVec3::new(sin, 0.0, -cos);
            for direction in [DVec3::Z, DVec3::new(0.6, 0.0, 0.8), DVec3::new(-0.8, 0.0, 0.6)] {
                assert!(mirrored(direction, normal, raw).dot(raw) >= -1e-12, "{degrees}, {direction}");
            }
        }
    }
}
