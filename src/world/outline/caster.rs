//! What is known of an object that throws shadows, whoever looks at it.

use super::solid::Solid;
use super::{Border, Outlines, Part, Ring, Sight, cylinder};
use crate::math::{DVec3, Transform};
use crate::world::object::{Leaf, LeafFlags, Member, RayKind};
use crate::world::parts::{Group, Object, Operation, Parts};
use crate::world::screen::{OPEN, SHUT, UNKNOWN, Verdict};
use crate::world::shape::torus::Torus;
use crate::world::shape::{Primitive, Shape};

/// Compounds of more solids are not looked at.
const MOST: usize = 8;

/// Transforms that stretch some directions so much more than others spoil too many digits.
const SKEWED: f64 = 1e3;

/// An object that throws shadows.
#[derive(Debug)]
pub struct Caster {
    form: Form,
    /// Whether no light gets through.
    opaque: bool,
}

#[derive(Debug)]
enum Form {
    /// These together.
    Solids(Vec<Solid>),
    /// The cylinder x² + y² = 1 between z = 0 and z = 1, elsewhere.
    Cylinder(Transform),
    Torus(Torus, Transform),
}

impl Caster {
    /// `None` for what has no outline that could be described.
    pub(in crate::world) fn new(object: &Object, parts: &Parts) -> Option<Self> {
        let form = match object.member {
            Member::Leaf(number) => Form::of_leaf(parts.leaf(number))?,
            Member::Group(number) => Form::of_group(parts.group(number), parts)?,
        };
        Some(Self { form, opaque: object.opaque })
    }

    /// Adds how it is seen to `seen`; what is known of all places, and `UNKNOWN` where they differ. `None` where
    /// nothing is known.
    pub(super) fn look(&self, object: u32, sight: &Sight, seen: &mut Outlines) -> Option<Verdict> {
        let inner = |place: &Transform| {
            sight.mapped(|point| place.inverse_point(point), |vector| place.inverse_vector(vector))
        };
        match &self.form {
            Form::Solids(solids) => {
                let outside = solids.iter().all(|solid| solid.is_left_by(sight.from));
                outside.then(|| self.look_at(solids, object, sight, seen))
            }
            Form::Cylinder(place) => {
                let sight = inner(place);
                let mut border = Border::new(&mut seen.lines, &sight);
                let known = cylinder::look(&sight, &mut border);
                known.then(|| self.finish(border, object, &mut seen.parts))
            }
            Form::Torus(torus, place) => {
                let ring = Ring::new(torus, inner(place), self.opaque)?;
                seen.parts.push((object, Part::Ring(ring)));
                Some(UNKNOWN)
            }
        }
    }

    /// How solids are seen that the point is outside of.
    fn look_at(&self, solids: &[Solid], object: u32, sight: &Sight, seen: &mut Outlines) -> Verdict {
        let farthest = sight.farthest();
        let mut verdict = OPEN;
        for solid in solids {
            let mut border = Border::new(&mut seen.lines, sight);
            solid.look(sight, farthest, &mut border);
            match self.finish(border, object, &mut seen.parts) {
                SHUT => return SHUT,
                found => verdict = found.max(verdict),
            }
        }
        verdict
    }

    /// Notes a part with borders, unless they are beside all places.
    fn finish(&self, mut border: Border, object: u32, parts: &mut Vec<(u32, Part)>) -> Verdict {
        if !self.opaque {
            border.is_thin();
        }
        let (verdict, part) = border.finish();
        if verdict == UNKNOWN {
            parts.push((object, part));
        }
        verdict
    }
}

impl Form {
    fn of_leaf(leaf: &Leaf) -> Option<Self> {
        let fit = !leaf.is_limited()
            && !leaf.hidden.intersects(RayKind::SHADOW)
            && leaf.flags.contains(LeafFlags::SOLID)
            && !leaf.flags.contains(LeafFlags::INVERTED)
            && leaf.transform.as_deref().is_none_or(is_even);
        let place = || leaf.transform.as_deref().copied().unwrap_or_default();
        match &leaf.primitive {
            Primitive::Box(_) if fit => Some(Self::Solids(vec![solid(leaf)?])),
            // The lengths of both axes have no part in how it is seen.
            Primitive::Cylinder(cylinder) if fit && !cylinder.open => Some(Self::Cylinder(place())),
            Primitive::Torus(torus) if fit => Some(Self::Torus(*torus, place())),
            _ => None,
        }
    }

    /// Compounds of boxes.
    fn of_group(group: &Group, parts: &Parts) -> Option<Self> {
        if !group.convex || group.limits.is_some() || group.extent.beyond {
            return None;
        }
        let (mut solids, mut holes) = (Vec::new(), Vec::new());
        for &member in &group.members {
            let Member::Leaf(number) = member else { return None };
            let leaf = parts.leaf(number);
            if leaf.hidden.intersects(RayKind::SHADOW) || !leaf.transform.as_deref().is_none_or(is_even) {
                return None;
            }
            let list = if leaf.flags.contains(LeafFlags::INVERTED) { &mut holes } else { &mut solids };
            list.push(solid(leaf)?);
        }
        if group.operation == Operation::Intersection {
            let mut whole = solids.pop()?;
            for other in &solids {
                whole = whole.common(other)??;
            }
            solids = vec![whole];
            for hole in &holes {
                let rest = solids.iter().map(|solid| solid.without(hole));
                solids = rest.collect::<Option<Vec<_>>>()?.into_iter().flatten().collect();
                if solids.len() > MOST {
                    return None;
                }
            }
        }
        Some(Self::Solids(solids))
    }
}

/// A box.
fn solid(leaf: &Leaf) -> Option<Solid> {
    let Primitive::Box(cuboid) = &leaf.primitive else { return None };
    Solid::cuboid(&cuboid.bounds(), leaf.transform.as_deref())
}

/// Whether a transform stretches all directions about as much.
fn is_even(transform: &Transform) -> bool {
    let longest = |vector: &dyn Fn(DVec3) -> DVec3| {
        DVec3::AXES.into_iter().map(|axis| vector(axis).length()).fold(0.0, f64::max)
    };
    longest(&|axis| transform.vector(axis)) * longest(&|axis| transform.inverse_vector(axis)) < SKEWED
}
