//! Looking a value up in a map (docs/spec/patterns-textures.md 3.1).

/// Positions and entries in the order written; at least one entry. For `average` positions are weights.
#[derive(Clone, Debug)]
pub struct BlendMap<T> {
    entries: Box<[(f32, T)]>,
}

/// What a map has at a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pick<T> {
    /// One entry alone.
    One(T),
    /// Two entries, `current` with share `t`.
    Two {
        /// The earlier entry.
        previous: T,
        /// The later entry.
        current: T,
        /// 0 … 1.
        t: f64,
    },
}

impl<T> BlendMap<T> {
    /// `None` without entries.
    pub fn new(entries: impl IntoIterator<Item = (f32, T)>) -> Option<Self> {
        let entries: Box<[_]> = entries.into_iter().collect();
        (!entries.is_empty()).then_some(Self { entries })
    }

    /// Positions and entries, at least one.
    #[inline]
    pub fn entries(&self) -> &[(f32, T)] {
        &self.entries
    }

    /// The entries that show at `value`. Positions need not be sorted; the rule is then followed literally.
    #[inline(always)]
    pub fn pick(&self, value: f64) -> Pick<&T> {
        let entries = &self.entries;
        let (last, last_entry) = &entries[entries.len() - 1];
        if value >= f64::from(*last) {
            return Pick::One(last_entry);
        }
        // A value that is no number takes the first entry, as POV-Ray's does.
        let mut i = 0;
        loop {
            if value <= f64::from(entries[i].0) || value.is_nan() {
                break;
            }
            i += 1;
            if i == entries.len() {
                return Pick::One(last_entry);
            }
        }
        let (at, current) = &entries[i];
        if i == 0 || value == f64::from(*at) {
            return Pick::One(current);
        }
        let (before, previous) = &entries[i - 1];
        Pick::Two { previous, current, t: (value - f64::from(*before)) / f64::from(at - before) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn map(positions: &[f32]) -> BlendMap<usize> {
        BlendMap::new(positions.iter().copied().zip(0..)).unwrap()
    }

    #[test]
    fn equal_positions_make_a_step() {
        let map = map(&[0.2, 0.5, 0.5, 0.5, 0.7]);
        assert_eq!(map.pick(0.1), Pick::One(&0));
        assert_eq!(map.pick(0.5), Pick::One(&1));
        let Pick::Two { previous: 3, current: 4, t } = map.pick(0.5000001) else { panic!() };
        assert!(t > 0.0 && t < 1e-6);
        assert_eq!(map.pick(0.7_f32.into()), Pick::One(&4));
        assert_eq!(map.pick(9.0), Pick::One(&4));
    }

    #[test]
    fn unsorted_positions_follow_the_rule_literally() {
        let map = map(&[0.8, 0.3, 0.6]);
        assert_eq!(map.pick(0.35), Pick::One(&0));
        assert_eq!(map.pick(0.59), Pick::One(&0));
        assert_eq!(map.pick(0.65), Pick::One(&2));
    }

    #[test]
    fn no_number_takes_the_first_entry() {
        assert_eq!(map(&[0.2, 0.5]).pick(f64::NAN), Pick::One(&0));
        assert_eq!(map(&[0.2, 0.5]).pick(f64::INFINITY), Pick::One(&1));
        assert_eq!(map(&[0.2, 0.5]).pick(f64::NEG_INFINITY), Pick::One(&0));
    }
}
