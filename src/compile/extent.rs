//! The boxes that `min_extent` and `max_extent` report: POV-Ray's own, in single precision, not
//! always tight (docs/spec/primitives.md 8).

use super::flatten::Flattener;
use crate::math::{Bounds, DVec3, Transform};
use crate::scene::object::ObjectFlags;
use crate::scene::shape::{Csg, CsgOperation};
use crate::scene::{Object, Shape};
use crate::world::extent::half_space;
use crate::world::shape::Shape as _;

/// What POV-Ray takes for infinitely far.
const FAR: f64 = 1e10;

/// Compounds with a longer side count as infinite.
const LONGEST: f64 = 1e6;

/// Components of a plane's normal below this count as zero.
const FLAT: f64 = 1e-10;

const EVERYWHERE: Bounds = Bounds { min: DVec3::splat(-FAR), max: DVec3::splat(FAR) };

impl Flattener<'_> {
    /// The box of an object in its outer space. Parts that can't be compiled have none.
    pub(super) fn reported_extent(&mut self, object: &Object) -> Bounds {
        stored(self.extent(object))
    }

    /// Whether the box has no end: POV-Ray looks by boxes for what contains a point, so that of what is turned inside
    /// out only such contain what is around them (docs/spec/shading.md 11).
    pub(super) fn is_everywhere(&mut self, object: &Object) -> bool {
        self.extent(object).size().max_element() >= FAR
    }

    /// The box of an object in its outer space, in double precision.
    pub(super) fn extent(&mut self, object: &Object) -> Bounds {
        let mut bounds = match &object.shape {
            Shape::Csg(csg) => placed(self.extent_of_compound(csg), object.transform.as_deref()),
            Shape::Light(light) => light
                .looks_like
                .as_ref()
                .map_or(Bounds::EMPTY, |shape| placed(self.extent(shape), object.transform.as_deref())),
            Shape::LightGroup(group) => self.union(group.objects.iter().map(|object| &**object)),
            primitive => match self.primitive(primitive, object, None, false) {
                Ok(compiled) => {
                    let own = compiled.primitive.extent();
                    placed(placed(own, compiled.transform.as_ref()), object.transform.as_deref())
                }
                Err(_) => Bounds::EMPTY,
            },
        };
        for limit in
            object.extra.iter().flat_map(|extra| extra.clipped_by.iter().chain(extra.bounded_by.iter()))
        {
            let limit = self.extent(limit);
            if volume(limit) < volume(bounds) {
                bounds = limit;
            }
        }
        bounds
    }

    fn extent_of_compound(&mut self, csg: &Csg) -> Bounds {
        let children = csg.children.iter().map(|child| &**child);
        match csg.operation {
            CsgOperation::Union | CsgOperation::Merge => self.union(children),
            CsgOperation::Difference => self.common(children.take(1)),
            CsgOperation::Intersection => self.common(children),
        }
    }

    fn union<'a>(&mut self, children: impl Iterator<Item = &'a Object>) -> Bounds {
        children.fold(Bounds::EMPTY, |all, child| all.union(self.extent(child)))
    }

    /// What the children that bound an intersection have in common.
    fn common<'a>(&mut self, children: impl Iterator<Item = &'a Object>) -> Bounds {
        let limiting = children.filter(|child| !matches!(child.shape, Shape::HeightField(_)));
        let common = limiting.fold(EVERYWHERE, |common, child| {
            let inverted = child.flags.contains(ObjectFlags::INVERSE);
            match child.shape {
                Shape::Plane { normal, distance } => {
                    let sign = if inverted { -1.0 } else { 1.0 };
                    let place = child.transform.as_deref();
                    common.intersection(half_space(sign * normal, sign * distance, place, FLAT))
                }
                _ if inverted => common,
                _ => common.intersection(self.extent(child)),
            }
        });
        let infinite = common.is_empty() || common.size().max_element() > LONGEST;
        if infinite { EVERYWHERE } else { common }
    }
}

fn placed(bounds: Bounds, transform: Option<&Transform>) -> Bounds {
    let unbounded = !bounds.is_empty() && bounds.size().max_element() >= FAR;
    match transform {
        _ if unbounded => bounds.intersection(EVERYWHERE),
        Some(transform) => bounds.transformed(transform),
        None => bounds,
    }
}

/// A box's volume as POV-Ray compares it.
pub(super) fn volume(bounds: Bounds) -> f64 {
    if bounds.is_empty() { f64::INFINITY } else { bounds.intersection(EVERYWHERE).size().element_product() }
}

/// The box after being stored as single precision corner and lengths.
fn stored(bounds: Bounds) -> Bounds {
    if bounds.is_empty() {
        return bounds;
    }
    let bounds = bounds.intersection(EVERYWHERE);
    let single = |v: DVec3| v.as_vec3();
    let (corner, lengths) = (single(bounds.min), single(bounds.max - bounds.min));
    Bounds { min: corner.as_dvec3(), max: (corner + lengths).as_dvec3() }
}
