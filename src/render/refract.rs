//! What a ray is inside of, and how surfaces bend it (docs/spec/shading.md 10 and 11).

use std::sync::Arc;

use smallvec::SmallVec;

use crate::math::{DVec3, Lanes};
use crate::world::Interior;
use crate::world::interior::AIR;

/// Ratios nearer to 1 than this don't bend.
const STRAIGHT: f64 = 1e-10;

/// Inside of so many bodies rays mostly are.
const FEW: usize = 4;

/// The interiors a ray has entered and not left, by number, in the order of entry.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Inside(SmallVec<[u32; FEW]>);

impl Clone for Inside {
    /// Every ray has its own: most are inside of few, which go through registers, one by one. All that was written one
    /// by one and is read at once would be waited for.
    #[inline]
    fn clone(&self) -> Self {
        let numbers = &self.0[..];
        if numbers.len() > FEW {
            return Self(SmallVec::from_slice(numbers));
        }
        let number = |place: usize| numbers.get(place).copied().unwrap_or(0);
        Self(SmallVec::from_buf_and_len([number(0), number(1), number(2), number(3)], numbers.len()))
    }
}

/// What happens to a ray that goes through a surface.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Passage {
    /// Refractive index of what is left over that of what is entered.
    pub(super) ratio: f64,
    /// The same quotient of the dispersions.
    pub(super) dispersion: f64,
    /// Where the ray is then.
    pub(super) inside: Inside,
}

impl Passage {
    /// Whether the ray goes on as it came.
    #[inline]
    pub(super) fn is_straight(&self) -> bool {
        (self.ratio - 1.0).abs() < STRAIGHT && (self.dispersion - 1.0).abs() < STRAIGHT
    }
}

impl Inside {
    /// A ray that starts inside of these.
    pub(super) fn of(interiors: impl IntoIterator<Item = u32>) -> Self {
        Self(interiors.into_iter().collect())
    }

    /// Whether the ray is inside of `interior`.
    #[inline]
    pub(super) fn contains(&self, interior: u32) -> bool {
        self.0.contains(&interior)
    }

    /// Whether the ray is inside of `interior` and nothing else.
    pub(super) fn is_only(&self, interior: u32) -> bool {
        self.0[..] == [interior]
    }

    /// Whether there is nothing around but air.
    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The interiors by number, in the order of entry.
    pub(super) fn numbers(&self) -> impl Iterator<Item = u32> {
        self.0.iter().copied()
    }

    /// What was entered last.
    pub(super) fn last(&self) -> Option<u32> {
        self.0.last().copied()
    }

    /// Whether nothing is around the ray that keeps fog away.
    pub(super) fn is_hollow(&self, interiors: &[Arc<Interior>]) -> bool {
        self.0.iter().all(|&i| interiors[i as usize].hollow)
    }

    /// Leaves `interior` if it had been entered, enters it otherwise.
    #[inline]
    pub(super) fn toggle(&mut self, interior: u32) {
        match self.0.iter().position(|&i| i == interior) {
            Some(index) if index + 1 == self.0.len() => {
                self.0.pop();
            }
            Some(index) => {
                self.0.remove(index);
            }
            None => self.0.push(interior),
        }
    }

    /// Goes through a surface of `interior`.
    #[inline]
    pub(super) fn pass(&self, interior: u32, interiors: &[Arc<Interior>]) -> Passage {
        let mut inside = self.clone();
        inside.toggle(interior);
        let media = |number: Option<&u32>| match number {
            Some(&number) => (interiors[number as usize].ior, interiors[number as usize].dispersion),
            None => (AIR, 1.0),
        };
        let (left, entered) = if self.contains(interior) {
            if self.0.last() != Some(&interior) {
                // An overlap is left: what was entered last goes on around the ray.
                return Passage { ratio: 1.0, dispersion: 1.0, inside };
            }
            (media(Some(&interior)), media(inside.0.last()))
        } else {
            (media(self.0.last()), media(Some(&interior)))
        };
        Passage { ratio: left.0 / entered.0, dispersion: left.1 / entered.1, inside }
    }

    /// The refractive index beyond a surface of `interior` over that on this side, by the rule of
    /// Fresnel reflection: leaving a nested body counts as no change.
    #[inline]
    pub(super) fn fresnel_index(&self, interior: u32, interiors: &[Arc<Interior>]) -> f64 {
        let ior = interiors[interior as usize].ior;
        match (self.0.last(), self.contains(interior)) {
            (None, _) => ior / AIR,
            (Some(_), true) if self.0.len() == 1 => AIR / ior,
            (Some(&last), true) => interiors[last as usize].ior / ior,
            (Some(&last), false) => ior / interiors[last as usize].ior,
        }
    }
}

/// The direction behind a surface; `None` where light is totally reflected.
///
/// `normal` is unit, on either side; `ratio` as in [`Passage::ratio`].
#[inline]
pub(super) fn refracted(direction: DVec3, normal: DVec3, ratio: f64) -> Option<DVec3> {
    let facing = if normal.dot(direction) > 0.0 { -normal } else { normal };
    let cosine = -facing.dot(direction);
    let square = 1.0 + ratio * ratio * (cosine * cosine - 1.0);
    (square >= 0.0).then(|| ratio * direction + (ratio * cosine - square.sqrt()) * facing)
}

/// The same for four rays on the sides that their normals face, and the bits of those that aren't totally reflected; the
/// directions of the others are no numbers.
#[inline(always)]
pub(super) fn refracted_of_four(
    direction: &[Lanes; 3],
    normal: &[Lanes; 3],
    ratio: f64,
) -> ([Lanes; 3], u32) {
    let cosine = -Lanes::dot(normal, direction);
    let square = (cosine * cosine - 1.0) * (ratio * ratio) + 1.0;
    let along = cosine * ratio - square.sqrt();
    let mut bent = *direction;
    for axis in 0..3 {
        bent[axis] = bent[axis] * ratio + along * normal[axis];
    }
    (bent, square.bits(|square| square >= 0.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::dice::numbers;
    use crate::render::mirror::tests::four_facing;
    use crate::world::{Ray, Rays};

    fn glass(ior: f64) -> Interior {
        Interior { ior, ..Interior::default() }
    }

    /// Rows of docs/spec/shading.md 10: a 45 degree surface met along z.
    #[test]
    fn rays_bend_towards_the_normal_of_denser_media() {
        let out = DVec3::new(1.0, 0.0, -1.0).normalize();
        let entering = refracted(DVec3::Z, out, 1.0 / 1.5).unwrap();
        assert!(entering.abs_diff_eq(DVec3::new(-0.2903, 0.0, 0.9569), 1e-4));
        let leaving = refracted(DVec3::Z, DVec3::new(-1.0, 0.0, 1.0).normalize(), 1.2).unwrap();
        assert!(leaving.abs_diff_eq(DVec3::new(0.2258, 0.0, 0.9742), 1e-4));
        assert_eq!(refracted(DVec3::Z, out, 1.5), None);
    }

    #[test]
    fn four_rays_are_bent_as_each_alone() {
        let mut number = numbers(3);
        for turn in 0..1000 {
            let rays = four_facing(&mut number);
            let many = Rays::of(&rays);
            let ratio = if turn % 2 == 0 { 1.5 } else { 1.0 / 1.5 };
            let (bent, bends) = refracted_of_four(&many.direction, &many.origin, ratio);
            for (lane, Ray { origin: normal, direction }) in rays.into_iter().enumerate() {
                let together = (bends >> lane & 1 == 1).then(|| Lanes::point(&bent, lane));
                assert_eq!(together, refracted(direction, normal, ratio));
            }
        }
    }

    #[test]
    fn nested_bodies_refract_against_what_surrounds_them() {
        let interiors = [glass(1.5), glass(1.2)].map(Arc::new);
        let outer = Inside::default().pass(0, &interiors);
        assert_eq!(outer.ratio, 1.0 / 1.5);
        let inner = outer.inside.pass(1, &interiors);
        assert_eq!(inner.ratio, 1.5 / 1.2);
        let back = inner.inside.pass(1, &interiors);
        assert_eq!((back.ratio, &back.inside), (1.2 / 1.5, &outer.inside));
    }

    #[test]
    fn leaving_an_overlap_goes_straight() {
        let interiors = [glass(1.5), glass(1.2)].map(Arc::new);
        let passage = Inside::of([0, 1]).pass(0, &interiors);
        assert!(passage.is_straight());
        assert_eq!(passage.inside, Inside::of([1]));
    }

    #[test]
    fn fresnel_reflection_ignores_the_way_out_of_a_nested_body() {
        let interiors = [glass(1.5), glass(1.2)].map(Arc::new);
        assert_eq!(Inside::default().fresnel_index(0, &interiors), 1.5);
        assert_eq!(Inside::of([0]).fresnel_index(0, &interiors), 1.0 / 1.5);
        assert_eq!(Inside::of([0]).fresnel_index(1, &interiors), 1.2 / 1.5);
        assert_eq!(Inside::of([0, 1]).fresnel_index(1, &interiors), 1.0);
    }
}
