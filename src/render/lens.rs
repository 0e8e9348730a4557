//! Pixels through a lens (docs/spec/camera-image.md 8.4).

use super::Eye;
use super::jitter::jitter;
use super::sampling::Sample;
use super::trace::Tracer;
use crate::math::DVec2;
use crate::math::noise::hash;
use crate::world::camera::{FocalBlur, film};

/// Sub-pixel places along an axis.
const PLACES: i32 = 16;

/// Sums of samples and of their squares.
#[derive(Default)]
struct Sums {
    count: usize,
    values: [f64; 4],
    squares: [f64; 4],
}

impl Sums {
    fn add(&mut self, sample: Sample) {
        self.count += 1;
        for (i, value) in sample.map(f64::from).into_iter().enumerate() {
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
        let mut sums = Sums::default();
        for batch in 0.. {
            let end = blur.max_samples().min(sums.count + blur.batch(batch));
            while sums.count < end {
                sums.add(self.lens_sample(tracer, blur, x, y, seed, sums.count));
            }
            if end == blur.max_samples() || blur.is_enough(sums.count, sums.variances()) {
                break;
            }
        }
        sums.mean()
    }

    fn lens_sample(
        &self,
        tracer: &mut Tracer,
        blur: &FocalBlur,
        x: f64,
        y: f64,
        seed: i32,
        index: usize,
    ) -> Sample {
        let number = seed.wrapping_add(index as i32);
        let place = |number: i32| f64::from(2 * (hash(number) % PLACES) + 1) / 32.0 - 0.5;
        let mut shift = DVec2::new(place(number), place(number.wrapping_add(1)));
        shift += (jitter(shift.x, shift.y) - 0.5) / f64::from(PLACES);
        let (x, y) = (x + shift.x, y + shift.y);
        let place = film(x, y, self.options.width, self.options.height);
        let Some(projected) = self.world.camera.projection.project(place) else {
            return [0.0; 4];
        };
        let ray = blur.ray(projected.ray.direction, index, jitter(x + 0.5, y - 0.5));
        self.seen(tracer, self.world.camera.bend(ray, projected.parameters), (x, y), f64::INFINITY)
    }
}
