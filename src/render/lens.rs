//! Pixels through a lens (docs/spec/camera-image.md 8.4).

use std::sync::LazyLock;

use super::Eye;
use super::jitter::jitter;
use super::sampling::Sample;
use super::trace::Tracer;
use crate::math::DVec2;
use crate::math::noise::hashes;
use crate::world::camera::{FocalBlur, Projection, film};

/// Sub-pixel places along an axis.
const PLACES: usize = 16;

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
#[derive(Default)]
struct Sums {
    count: usize,
    values: [f64; 4],
    squares: [f64; 4],
}

impl Sums {
    #[inline]
    fn add(&mut self, sample: Sample) {
        self.count += 1;
        for (i, value) in sample.into_iter().enumerate() {
            let value = f64::from(value);
            self.values[i] += value;
            self.squares[i] += value * value;
        }
    }

    fn mean(&self) -> Sample {
        self.values.map(|sum| (sum / self.count as f64) as f32)
    }

    /// The variances of the means.
    fn variances(&self) -> [f64; 4] {
        let n = self.count as f64;
        std::array::from_fn(|i| (self.squares[i] / n - (self.values[i] / n).powi(2)) / n)
    }
}

impl Eye<'_> {
    /// The colour and transmit at image coordinates, through the lens.
    pub(super) fn through_lens(&self, tracer: &mut Tracer, blur: &FocalBlur, x: f64, y: f64) -> Sample {
        let seed = ((313.0 * x + 11.0) as i32).wrapping_add((311.0 * y + 17.0) as i32);
        let shifts = &*SHIFTS;
        let hashes = hashes();
        let place = |number: i32| usize::from(hashes[(number & 4095) as usize]) % PLACES;
        let mut sums = Sums::default();
        for batch in 0.. {
            let end = blur.max_samples().min(sums.count + blur.batch(batch));
            while sums.count < end {
                let number = seed.wrapping_add(sums.count as i32);
                let shift = shifts[place(number)][place(number.wrapping_add(1))];
                sums.add(self.lens_sample(tracer, blur, x + shift.x, y + shift.y, sums.count));
            }
            if end == blur.max_samples() || blur.is_enough(sums.count, || sums.variances()) {
                break;
            }
        }
        sums.mean()
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
