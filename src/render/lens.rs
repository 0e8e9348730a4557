//! Pixels through a lens (docs/spec/camera-image.md 8.4).

use std::sync::LazyLock;

use super::Eye;
use super::jitter::{jitter, jitter_of_four};
use super::plain::Room;
use super::sampling::Sample;
use super::trace::{Path, Tracer};
use crate::math::noise::hashes;
use crate::math::wide::widest;
use crate::math::{DVec2, DVec3, Lanes};
use crate::world::accel::Pencil;
use crate::world::camera::{FocalBlur, Perspective, Projection, film, film_of_four};
use crate::world::{Ray, RayKind, Rays};

/// Sub-pixel places along an axis.
const PLACES: usize = 16;

/// Rays of a pixel stay within this of its middle, along both axes.
const EDGE: f64 = 0.55;

/// What rays of so many pixels in a row may meet is found together.
const ROW: f64 = 4.0;

/// Variances this near to a limit, in parts of the mean square, are compared digit by digit.
const DOUBT: f64 = 1e-13;

/// Where rays go through a pixel, by the numbers of the place from the left and from the top.
static SHIFTS: LazyLock<[[DVec2; PLACES]; PLACES]> = LazyLock::new(|| {
    let place = |number: usize| (2 * number + 1) as f64 / (2 * PLACES) as f64 - 0.5;
    std::array::from_fn(|left| {
        std::array::from_fn(|top| {
            let (x, y) = (place(left), place(top));
            DVec2::new(x, y) + (jitter(x, y) - 0.5) / PLACES as f64
        })
    })
});

/// Sums of samples and of their squares.
struct Sums {
    count: usize,
    values: Lanes,
    squares: Lanes,
}

impl Sums {
    const NONE: Self = Self { count: 0, values: Lanes::ZERO, squares: Lanes::ZERO };

    #[inline]
    fn add(&mut self, sample: Sample) {
        let [red, green, blue, transmit] = sample;
        let value = Lanes([red.into(), green.into(), blue.into(), transmit.into()]);
        self.count += 1;
        self.values = self.values + value;
        self.squares = self.squares + value * value;
    }

    fn mean(&self) -> Sample {
        self.values.0.map(|sum| (sum / self.count as f64) as f32)
    }

    /// Whether the variance of the mean of a component is below a limit. Mostly that shows without a division.
    #[inline]
    fn varies_less(&self, component: usize, limit: f64) -> bool {
        let n = self.count as f64;
        let (sum, squares) = (self.values.0[component], self.squares.0[component]);
        // n³ times the variance and its limit, known better than to a hundredth of the doubt, as the variance itself is.
        let (many, most) = (squares * n - sum * sum, limit * (n * n * n));
        if (many - most).abs() > squares * n * DOUBT {
            return many < most;
        }
        let mean = sum / n;
        (squares / n - mean * mean) / n < limit
    }
}

impl Eye<'_> {
    /// The colour and transmit at image coordinates, through the lens.
    #[inline(always)]
    pub(super) fn through_lens(&self, tracer: &mut Tracer, blur: &FocalBlur, x: f64, y: f64) -> Sample {
        let seed = ((313.0 * x + 11.0) as i32).wrapping_add((311.0 * y + 17.0) as i32);
        let shifts = &*SHIFTS;
        let hashes = hashes();
        let place = |number: i32| usize::from(hashes[(number & 4095) as usize]) % PLACES;
        let shifted = |index: usize| {
            let number = seed.wrapping_add(index as i32);
            let shift = shifts[place(number)][place(number.wrapping_add(1))];
            (x + shift.x, y + shift.y)
        };
        let mut within = std::mem::take(&mut tracer.within);
        let perspective = match &self.world.camera.projection {
            Projection::Perspective(perspective) if self.world.camera.normal.is_none() => Some(perspective),
            _ => None,
        };
        let straight = perspective.filter(|perspective| {
            let whole = x.fract() == 0.0 && y.fract() == 0.0;
            let (start, more) = if whole { ((x / ROW).floor() * ROW, ROW - 1.0) } else { (x, 0.0) };
            match tracer.row {
                Some((place, known)) if place == [start, y] => known,
                _ => {
                    let pencil = self.pencil(blur, perspective, [start, start + more], y);
                    let geometry = &self.world.geometry;
                    let known = pencil.is_some_and(|pencil| geometry.within(&pencil, &mut within));
                    tracer.row = Some(([start, y], known));
                    tracer.reflections.restart(pencil.filter(|_| known));
                    known
                }
            }
        });
        // Where there is nothing but a sky of one colour, one ray tells what all see.
        let world = self.world;
        let empty = straight.is_some() && within.items().is_empty() && world.geometry.is_bounded();
        let alike = empty && world.atmosphere.is_clear() && world.atmosphere.is_even();
        let sky = alike.then(|| self.lens_sample(tracer, blur, x, y, 0));
        let mut sums = Sums::NONE;
        let mut hits = [None; Lanes::COUNT];
        let nowhere = Ray::new(DVec3::ZERO, DVec3::ZERO);
        let inside = self.inside.clone().unwrap_or_default();
        let kind = RayKind::IMAGE;
        let mut room = Room::NEW;
        let mut path = Path { ray: nowhere, level: 0, weight: 1.0, kind, wavelength: None, inside };
        for batch in 0.. {
            let end = blur.max_samples().min(sums.count + blur.batch(batch));
            while sums.count < end {
                if let Some(sky) = sky {
                    sums.add(sky);
                    continue;
                }
                let Some(perspective) = straight else {
                    let (x, y) = shifted(sums.count);
                    sums.add(self.lens_sample(tracer, blur, x, y, sums.count));
                    continue;
                };
                let (first, count) = (sums.count, Lanes::COUNT.min(end - sums.count));
                let mut places = [(x, y); Lanes::COUNT];
                for (index, place) in (first..).zip(&mut places[..count]) {
                    *place = shifted(index);
                }
                let rays = self.four_rays(blur, perspective, &places, first);
                self.world.geometry.hits(&within, &rays, (1 << count) - 1, kind, 0.0, &mut hits);
                self.four_seen(
                    tracer,
                    (&mut path, &mut room),
                    &rays,
                    &places,
                    &hits[..count],
                    #[inline(always)]
                    |sample| sums.add(sample),
                );
            }
            if end == blur.max_samples()
                || blur.is_enough(sums.count, |component, limit| sums.varies_less(component, limit))
            {
                break;
            }
        }
        tracer.within = within;
        sums.mean()
    }

    /// All rays through the lens and pixels from one to another in a row; `None` where they may start where they
    /// are in focus.
    fn pencil(
        &self,
        blur: &FocalBlur,
        perspective: &Perspective,
        [first, last]: [f64; 2],
        y: f64,
    ) -> Option<Pencil> {
        let corner =
            |x: f64, y: f64| perspective.direction(film(x, y, self.options.width, self.options.height));
        let (left, right, above, below) = (first - EDGE, last + EDGE, y - EDGE, y + EDGE);
        blur.pencil(&[corner(left, above), corner(left, below), corner(right, above), corner(right, below)])
    }

    /// The rays of four samples from number `first` on, through image coordinates.
    #[inline]
    fn four_rays(
        &self,
        blur: &FocalBlur,
        perspective: &Perspective,
        places: &[(f64, f64); Lanes::COUNT],
        first: usize,
    ) -> Rays {
        let (mut x, mut y) = (Lanes::ZERO, Lanes::ZERO);
        for (lane, &place) in places.iter().enumerate() {
            (x.0[lane], y.0[lane]) = place;
        }
        widest(
            #[inline(always)]
            || {
                let shifts = jitter_of_four(x + 0.5, y + -0.5);
                let [x, y] = film_of_four(x, y, self.options.width, self.options.height);
                blur.rays(&perspective.directions(x, y), first, &shifts)
            },
        )
    }

    /// What ray `index` sees that goes through the lens and image coordinates.
    #[inline]
    fn lens_sample(&self, tracer: &mut Tracer, blur: &FocalBlur, x: f64, y: f64, index: usize) -> Sample {
        let place = film(x, y, self.options.width, self.options.height);
        let camera = &self.world.camera;
        let (direction, parameters) = match &camera.projection {
            Projection::Perspective(perspective) => (perspective.direction(place), place),
            other => match other.project(place) {
                Some(projected) => (projected.ray.direction, projected.parameters),
                None => return [0.0; 4],
            },
        };
        let mut ray = blur.ray(direction, index, jitter(x + 0.5, y - 0.5));
        camera.bend(&mut ray, parameters);
        self.seen(tracer, ray, (x, y), f64::INFINITY)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::dice::numbers;

    #[test]
    fn variances_are_compared_as_their_digits_say() {
        let mut number = numbers(5);
        for count in 1..200 {
            let mut sums = Sums::NONE;
            for _ in 0..count {
                sums.add([number() as f32, 0.5, number() as f32 * 1e-6 + 7.0, 0.0]);
            }
            for component in 0..4 {
                let (n, mean) = (count as f64, sums.values.0[component] / count as f64);
                let variance = (sums.squares.0[component] / n - mean * mean) / n;
                for limit in [0.0, variance, variance.next_up(), variance.next_down(), 0.5 * variance, 1e-9] {
                    assert_eq!(
                        sums.varies_less(component, limit),
                        variance < limit,
                        "{count} {component} {limit}"
                    );
                }
            }
        }
    }
}
