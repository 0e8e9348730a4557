//! What is inside along lines, for surfaces of functions that ask it.

use crate::math::{Band, Bounds, Lanes};
use crate::world::object::{Leaf, LeafFlags, Member};
use crate::world::parts::Parts;
use crate::world::shape::Shape;

/// In which lanes points may be in a box: there it is above zero.
fn may_meet(bounds: Bounds, point: &[Band; 3]) -> Lanes {
    let mut may = Lanes::splat(1.0);
    for (axis, coordinate) in point.iter().enumerate() {
        // What is no number may be anywhere.
        let unless = |beside: bool, may: f64| if beside { -1.0 } else { may };
        may = coordinate.high().zip(may, |high, may| unless(high < bounds.min[axis], may));
        may = coordinate.low().zip(may, |low, may| unless(low > bounds.max[axis], may));
    }
    may
}

impl Parts {
    /// What holds whether points that these hold are inside a member and its clips: 1, 0 or both.
    pub fn inside_along(&self, member: Member, point: &[Band; 3]) -> Band {
        let extent = self.extent(member);
        let beyond = Band::constant(f64::from(extent.beyond));
        let near = may_meet(extent.bounds, point);
        if (-near).all_positive() {
            return beyond;
        }
        let clips = self.limits(member).map_or(&[][..], |limits| &limits.clips);
        let inside = match member {
            Member::Leaf(number) => self.leaf(number).contains_along(point),
            Member::Group(number) => {
                let group = self.group(number);
                let members = group.members.iter().map(|&member| self.inside_along(member, point));
                let no = Band::constant(0.0);
                match group.operation.decisive() {
                    true => members.reduce(Band::or).unwrap_or(no),
                    false => members.reduce(Band::and).unwrap_or(no.is_false()),
                }
            }
        };
        let inside = clips.iter().map(|&clip| self.inside_along(clip, point)).fold(inside, Band::and);
        inside.where_positive(near, beyond)
    }
}

impl Leaf {
    fn contains_along(&self, point: &[Band; 3]) -> Band {
        if !self.flags.contains(LeafFlags::SOLID) {
            return Band::constant(0.0);
        }
        let inner = self.transform.as_ref().map_or(*point, |transform| transform.inverse_along(*point));
        let inside = self.primitive.inside_along(&inner);
        if self.flags.contains(LeafFlags::INVERTED) { inside.is_false() } else { inside }
    }
}
