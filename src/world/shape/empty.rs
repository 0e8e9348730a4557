//! What has no surface: a sphere of radius 0, a triangle without area (docs/spec/primitives.md 1.9).

use super::{Crossing, Shape};
use crate::math::{Bounds, DVec3};
use crate::world::{Range, Ray};

/// Never hit and never inside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Empty;

impl Shape for Empty {
    fn bounds(&self) -> Bounds {
        Bounds::EMPTY
    }

    fn crossings(&self, _ray: &Ray, _range: Range, _out: &mut Vec<Crossing>) {}

    fn nearest(&self, _ray: &Ray, _range: Range) -> Option<Crossing> {
        None
    }

    fn inside(&self, _point: DVec3) -> bool {
        false
    }

    fn normal(&self, _point: DVec3, _crossing: &Crossing) -> DVec3 {
        DVec3::Z
    }
}
