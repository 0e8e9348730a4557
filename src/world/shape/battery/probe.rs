//! What the language's `trace()` and `inside()` say about a shape, and tables of what POV-Ray's say.

use crate::math::{Bounds, DVec3};
use crate::world::shape::{Crossing, Shape};
use crate::world::{Range, Ray};

/// How far a number may be from POV-Ray's: its solvers stop at about 1e-12, worse near tangents.
const CLOSE: f64 = 1e-9;

/// A `trace()`.
pub(crate) struct Probe {
    ray: Ray,
}

/// What a [`Probe`] found.
pub(crate) struct Found {
    pub(crate) point: DVec3,
    pub(crate) normal: DVec3,
    pub(crate) crossing: Crossing,
}

impl Probe {
    pub(crate) fn new(from: DVec3, direction: DVec3) -> Self {
        Self { ray: Ray::new(from, direction.normalize()) }
    }

    pub(crate) fn hit(&self, shape: &dyn Shape) -> Option<Found> {
        let crossing = shape.nearest(&self.ray, Range::AHEAD)?;
        let point = shape.reproject(self.ray.at(crossing.t), &crossing);
        Some(Found { point, normal: shape.normal(point, &crossing).normalize(), crossing })
    }
}

/// Checks rows like those of the specification: `from <v> dir <v> | P <v> N <v>` or `| miss`,
/// `inside <v> | 0`, `extent | <v> .. <v>`.
#[track_caller]
pub(crate) fn table(shape: &dyn Shape, rows: &str) {
    for row in rows.lines().map(str::trim) {
        let (question, answer) = row.split_once(" | ").expect("a row has a bar");
        let (asked, expected) = (vectors(question), vectors(answer));
        if question.starts_with("inside") {
            assert_eq!(shape.inside(asked[0]), answer == "1", "{row}");
        } else if question == "extent" {
            let Bounds { min, max } = shape.extent();
            // POV-Ray's boxes are single precision.
            let same = min.abs_diff_eq(expected[0], 1e-6) && max.abs_diff_eq(expected[1], 1e-6);
            assert!(same, "{row}: {min} .. {max}");
        } else {
            let found = Probe::new(asked[0], asked[1]).hit(shape);
            let text = found.as_ref().map(|hit| format!("P {} N {}", hit.point, hit.normal));
            let same = match found {
                None => answer == "miss",
                Some(hit) => {
                    expected.len() == 2
                        && hit.point.abs_diff_eq(expected[0], CLOSE * expected[0].length().max(1.0))
                        && hit.normal.abs_diff_eq(expected[1], CLOSE)
                }
            };
            assert!(same, "{row}: {text:?}");
        }
    }
}

/// Checks texture coordinates against a 16-bit image POV-Ray rendered of them.
#[track_caller]
pub(crate) fn uv(shape: &dyn Shape, from: [f64; 3], direction: [f64; 3], expected: [f64; 2]) {
    let hit = Probe::new(from.into(), direction.into()).hit(shape).expect("the ray hits");
    let uv = shape.uv(hit.point, &hit.crossing).expect("the shape has texture coordinates");
    assert!(uv.abs_diff_eq(expected.into(), 2e-5), "{uv} is not {expected:?}");
}

fn vectors(text: &str) -> Vec<DVec3> {
    let vector = |inner: &str| {
        let numbers: Vec<f64> = inner.split(',').map(|n| n.trim().parse().expect("a number")).collect();
        DVec3::from_slice(&numbers)
    };
    text.split('<').skip(1).map(|rest| vector(rest.split('>').next().unwrap_or_default())).collect()
}
