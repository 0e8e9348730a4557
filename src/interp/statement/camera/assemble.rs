//! How the words of a camera become its vectors (docs/spec/camera-image.md 3.2 and 3.3).

use std::sync::Arc;

use crate::interp::{Result, Vm};
use crate::math::{DVec3, Transform};
use crate::scene::camera::{FocalBlur, Projection};
use crate::scene::{Camera, Normal, Pigment};
use crate::source::Span;

/// Products of vectors that don't depend on the size of the scene count as zero below this.
const EPSILON: f64 = 1e-10;

/// A camera as it is written, before its vectors are assembled.
#[derive(Clone, Debug)]
pub(in crate::interp) struct Draft {
    pub(super) projection: Projection,
    pub(super) location: DVec3,
    pub(super) direction: DVec3,
    pub(super) up: DVec3,
    pub(super) right: DVec3,
    pub(super) sky: DVec3,
    /// The point looked at, and where it is written.
    pub(super) look_at: Option<(DVec3, Span)>,
    /// `up` or `right` was written.
    pub(super) sized: bool,
    pub(super) angle: Option<f64>,
    pub(super) focal_point: Option<DVec3>,
    pub(super) transform: Transform,
    pub(super) aperture: f64,
    pub(super) blur_samples: [u32; 2],
    pub(super) confidence: f64,
    pub(super) variance: f64,
    pub(super) bokeh: Option<Arc<Pigment>>,
    pub(super) normal: Option<Arc<Normal>>,
    /// Where `focal_point` or an assembled camera has fixed it.
    focal_distance: Option<f64>,
    /// The length of `direction` as `angle` or `look_at` last measured it.
    length: f64,
}

impl Default for Draft {
    fn default() -> Self {
        Self {
            projection: Projection::Perspective,
            location: DVec3::ZERO,
            direction: DVec3::Z,
            up: DVec3::Y,
            right: DVec3::X * 1.33,
            sky: DVec3::Y,
            look_at: None,
            sized: false,
            angle: None,
            focal_point: None,
            transform: Transform::IDENTITY,
            aperture: 0.0,
            blur_samples: [0, 0],
            confidence: 0.9,
            variance: 1e-4,
            bokeh: None,
            normal: None,
            focal_distance: None,
            length: 1.0,
        }
    }
}

impl Draft {
    /// What an assembled camera is changed from in scenes before version 3.5.
    pub(super) fn of(camera: &Camera) -> Self {
        let mut draft = Self {
            projection: camera.projection.clone(),
            location: camera.location,
            direction: camera.direction,
            up: camera.up,
            right: camera.right,
            angle: camera.angle,
            normal: camera.normal.clone(),
            focal_distance: Some(camera.focal_distance),
            ..Self::default()
        };
        if let Some(blur) = &camera.blur {
            draft.aperture = blur.aperture;
            draft.blur_samples = [blur.min_samples, blur.max_samples];
            (draft.confidence, draft.variance) = (blur.confidence, blur.variance);
            draft.bokeh.clone_from(&blur.bokeh);
        }
        draft
    }

    /// Assembles the camera: whatever has not acted yet acts now, in the fixed order.
    pub(in crate::interp::statement) fn finish(mut self, vm: &mut Vm<'_>, span: Span) -> Result<Camera> {
        if vm.version >= 350 {
            self.act_on_angle();
            let looked_at = self.look_at.map_or(DVec3::Z, |(point, _)| point);
            if self.look_at.is_some() {
                self.act_on_look_at(vm)?;
            }
            if matches!(self.projection, Projection::Orthographic) && (!self.sized || self.angle.is_some()) {
                self.resize(looked_at);
            }
            self.act_on_focal_point();
        }
        let [direction, up, right] = [self.direction, self.up, self.right];
        if [direction.dot(up), up.dot(right), right.dot(direction)].into_iter().any(|dot| dot.abs() > EPSILON)
        {
            let help = "the picture is sheared; leave `up` and `direction` out if that is not intended";
            vm.warn(span, "the vectors of this camera are not perpendicular", help);
        }
        let focal_distance = match self.focal_distance.unwrap_or(self.length) {
            0.0 => 1.0,
            distance => distance,
        };
        let blurs = self.aperture != 0.0 && self.blur_samples[1] > 0;
        let mut camera = Camera {
            span,
            projection: self.projection,
            location: self.location,
            direction,
            up,
            right,
            angle: self.angle,
            blur: blurs.then_some(FocalBlur {
                aperture: self.aperture,
                min_samples: self.blur_samples[0],
                max_samples: self.blur_samples[1],
                confidence: self.confidence,
                variance: self.variance,
                bokeh: self.bokeh,
            }),
            focal_distance,
            normal: self.normal,
        };
        apply(&mut camera, &self.transform);
        Ok(camera)
    }

    /// `angle` sets the length of `direction` where the picture is flat.
    pub(super) fn act_on_angle(&mut self) {
        let flat = matches!(self.projection, Projection::Perspective | Projection::Orthographic);
        if let Some(angle) = self.angle.filter(|&angle| flat && angle > 0.0) {
            let length = self.right.length() / (2.0 * (angle.to_radians() / 2.0).tan());
            self.direction = self.direction.normalize_or_zero() * length;
            self.length = length;
        }
    }

    /// `look_at` turns the camera, keeping the lengths of its vectors and its handedness.
    pub(super) fn act_on_look_at(&mut self, vm: &mut Vm<'_>) -> Result<()> {
        let Some((point, place)) = self.look_at else { return Ok(()) };
        let (length, height, width) = (self.direction.length(), self.up.length(), self.right.length());
        let handedness = self.up.cross(self.direction).dot(self.right);
        let ahead = point - self.location;
        // POV-Ray refuses points nearer than 1e-5, whatever the size of the scene.
        let coordinates = point.abs().max(self.location.abs()).max_element();
        if ahead.length() <= 4.0 * f64::EPSILON * coordinates {
            return Err(vm
                .error(place, "the camera looks at the point where it is")
                .help("move `location` or `look_at`"));
        }
        let ahead = ahead.normalize();
        let mut right = self.sky.cross(ahead);
        if right.abs().max_element() < EPSILON {
            vm.warn(place, "the camera looks straight along `sky`", "give another `sky`, such as `sky z`");
            right = self.right;
        }
        let right = right.normalize_or_zero();
        self.direction = ahead * length;
        self.up = ahead.cross(right) * height;
        self.right = right * if handedness > 0.0 { width } else { -width };
        self.length = length;
        Ok(())
    }

    /// The view of an orthographic camera is as wide as a perspective one's at the point looked at.
    fn resize(&mut self, looked_at: DVec3) {
        let (distance, length) = (looked_at.distance(self.location), self.direction.length());
        if distance > 0.0 && length > 0.0 {
            self.right *= distance / length;
            self.up *= distance / length;
        }
    }

    /// `focal_point` fixes the distance that is in focus.
    pub(super) fn act_on_focal_point(&mut self) {
        if let Some(point) = self.focal_point.take() {
            self.focal_distance = Some(point.distance(self.location));
        }
    }

    /// Before version 3.5 a type acts when it is read.
    pub(super) fn act_on_type(&mut self) {
        if matches!(self.projection, Projection::Orthographic) {
            self.resize(self.look_at.map_or(DVec3::Z, |(point, _)| point));
        }
    }

    /// Before version 3.5 a transform acts when it is read.
    pub(super) fn act_on_transform(&mut self) {
        let by = std::mem::take(&mut self.transform);
        self.location = by.point(self.location);
        for vector in [&mut self.direction, &mut self.up, &mut self.right] {
            *vector = by.vector(*vector);
        }
    }
}

/// Moves an assembled camera. The distance in focus is not scaled.
pub(super) fn apply(camera: &mut Camera, by: &Transform) {
    camera.location = by.point(camera.location);
    for vector in [&mut camera.direction, &mut camera.up, &mut camera.right] {
        *vector = by.vector(*vector);
    }
}
