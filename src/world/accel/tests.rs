//! All kinds must find the same: random boxes at all sizes and places, asked with random rays.

use super::*;
use crate::math::{Bounds, Lanes};
use crate::world::ray::Rays;

/// A small generator of repeatable numbers.
struct Numbers(u64);

impl Numbers {
    /// In 0 … 1.
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    /// In the cube -1 … 1.
    fn vector(&mut self) -> DVec3 {
        DVec3::new(self.next(), self.next(), self.next()) * 2.0 - 1.0
    }
}

fn boxes(numbers: &mut Numbers, count: u32, size: f64, at: DVec3) -> Vec<(Bounds, u32)> {
    let mut random = |number| {
        let middle = numbers.vector();
        let mut half = numbers.vector() * numbers.next() * 0.2;
        if number % 5 == 0 {
            half.y = 0.0;
        }
        (Bounds::new(at + size * (middle - half), at + size * (middle + half)), number)
    };
    (0..count).map(&mut random).collect()
}

/// The nearest box, by entry and then by number, asked of one kind.
fn nearest(accel: &Accel, boxes: &[(Bounds, u32)], ray: &Ray) -> Option<(f64, u32)> {
    let slabs = Slabs::new(ray);
    let mut best: Option<(f64, u32)> = None;
    accel.along(ray, Range::AHEAD, |item| {
        let bounds = boxes[item as usize].0;
        if let Some(entry) = slabs.entry(&bounds, Range::AHEAD) {
            let hit = (entry.max(0.0), item);
            if best.is_none_or(|best| hit < best) {
                best = Some(hit);
            }
        }
        best.map_or(f64::INFINITY, |best| best.0)
    });
    best
}

#[test]
fn every_kind_finds_the_same_nearest_box_at_every_scale_and_place() {
    let mut numbers = Numbers(1);
    for (size, at) in [
        (1.0, DVec3::ZERO),
        (1e-8, DVec3::new(1.0, 2.0, 3.0)),
        (1e8, DVec3::ZERO),
        (1.0, DVec3::splat(1e7)),
        (1e-30, DVec3::ZERO),
        (1e150, DVec3::ZERO),
    ] {
        let boxes = boxes(&mut numbers, 300, size, at);
        let linear = Accel::new(boxes.clone(), Accelerator::Linear);
        let trees = [Accelerator::Bvh, Accelerator::Octree].map(|kind| Accel::new(boxes.clone(), kind));
        let mut met = 0;
        for turn in 0..2000 {
            let mut direction = numbers.vector();
            if turn % 3 == 0 {
                direction[turn % 9 / 3] = 0.0;
            }
            let far = if turn % 10 == 0 { 1e6 } else { 1.5 };
            let target = at + size * numbers.vector();
            let ray = Ray::new(target - far * size * direction, direction.normalize());
            let found = nearest(&linear, &boxes, &ray);
            for tree in &trees {
                assert_eq!(nearest(tree, &boxes, &ray), found, "size {size}, turn {turn}");
            }
            met += usize::from(found.is_some());
        }
        assert!(met > 1000, "size {size}: the rays met {met} boxes");
    }
}

#[test]
fn rays_in_the_plane_of_a_face_and_through_corners_find_the_box() {
    let boxes: Vec<_> = (0..8)
        .map(|i| (Bounds::new(DVec3::X * f64::from(i), DVec3::new(f64::from(i) + 1.0, 1.0, 1.0)), i))
        .collect();
    let kinds = [Accelerator::Bvh, Accelerator::Octree];
    for (kind, (origin, direction)) in kinds.into_iter().flat_map(|kind| {
        [
            (DVec3::new(3.0, 0.0, -5.0), DVec3::Z),
            (DVec3::new(3.0, 1.0, -5.0), DVec3::Z),
            (DVec3::new(-1.0, -1.0, -1.0), DVec3::ONE.normalize()),
            (DVec3::new(3.0, 0.5, 0.5), DVec3::X),
        ]
        .map(|ray| (kind, ray))
    }) {
        let tree = Accel::new(boxes.clone(), kind);
        let ray = Ray::new(origin, direction);
        let mut items = Vec::new();
        tree.along(&ray, Range::AHEAD, |item| {
            items.push(item);
            f64::INFINITY
        });
        items.sort_unstable();
        let expected: Vec<u32> = boxes
            .iter()
            .filter(|(bounds, _)| Slabs::new(&ray).meet(bounds, Range::AHEAD))
            .map(|&(_, item)| item)
            .collect();
        assert!(
            !expected.is_empty() && expected.iter().all(|item| items.contains(item)),
            "{kind:?}, {ray:?}: {items:?}"
        );
    }
}

#[test]
fn every_kind_finds_the_same_boxes_around_a_point() {
    let mut numbers = Numbers(2);
    for (size, at) in [(1.0, DVec3::ZERO), (1e-6, DVec3::splat(100.0)), (1e8, DVec3::ZERO)] {
        let boxes = boxes(&mut numbers, 400, size, at);
        let trees = [Accelerator::Bvh, Accelerator::Octree].map(|kind| Accel::new(boxes.clone(), kind));
        for (turn, tree) in (0..500).flat_map(|turn| trees.iter().map(move |tree| (turn, tree))) {
            // Corners are the hardest points.
            let corner = boxes[turn % 400].0.max;
            let point = if turn % 2 == 0 { at + size * numbers.vector() } else { corner };
            let mut found = Vec::new();
            tree.any_around(point, |item| {
                found.push(item);
                false
            });
            let expected = boxes.iter().filter(|(bounds, _)| bounds.contains(point));
            for (_, item) in expected {
                assert!(found.contains(item), "{item} is around {point}");
            }
            assert!(found.len() < 100, "{} of 400 boxes asked", found.len());
        }
    }
}

#[test]
fn a_pencil_lists_every_box_that_one_of_its_rays_meets() {
    let mut numbers = Numbers(5);
    for (size, at) in
        [(1.0, DVec3::ZERO), (1e-8, DVec3::new(1.0, 2.0, 3.0)), (1e8, DVec3::ZERO), (1.0, DVec3::splat(1e7))]
    {
        let boxes = boxes(&mut numbers, 300, size, at);
        let tree = Accel::new(boxes.clone(), Accelerator::Bvh);
        let (mut within, mut met) = (Within::default(), 0);
        for turn in 0..400 {
            let mut around = |far: f64| {
                let (middle, half) = (numbers.vector() * far, numbers.vector() * 0.1);
                Bounds::new(at + size * (middle - half), at + size * (middle + half))
            };
            let pencil = Pencil {
                from: around(if turn % 2 == 0 { 2.0 } else { 0.5 }),
                through: around(1.0),
                ends: false,
            };
            if !tree.within(&pencil, &mut within) {
                continue;
            }
            let mut point = |of: Bounds| of.min + of.size() * (numbers.vector() + 1.0) / 2.0;
            let mut rays = Rays { origin: [Lanes::ZERO; 3], direction: [Lanes::ZERO; 3] };
            for lane in 0..Lanes::COUNT {
                let (origin, target) = (point(pencil.from), point(pencil.through));
                let direction = (target - origin).normalize();
                for axis in 0..3 {
                    rays.origin[axis].0[lane] = origin[axis];
                    rays.direction[axis].0[lane] = direction[axis];
                }
            }
            let four = Four::new(&rays, &within);
            for (lane, (bounds, item)) in (0..4).flat_map(|lane| boxes.iter().map(move |item| (lane, item))) {
                let Some(entry) = Slabs::new(&rays.ray(lane)).entry(bounds, Range::AHEAD) else { continue };
                let boxed = within.items().iter().find(|boxed| boxed.number == *item).unwrap();
                assert!(boxed.entry <= entry.max(0.0), "size {size}, turn {turn}");
                for end in [entry.max(0.0), f64::INFINITY] {
                    assert!(
                        four.meet(boxed, &Lanes::splat(end)) >> lane & 1 == 1,
                        "size {size}, turn {turn}"
                    );
                }
                met += 1;
            }
        }
        assert!(met > 500, "size {size}: the rays met {met} boxes");
    }
}

#[test]
fn equal_boxes_and_single_boxes_make_sound_trees() {
    let cube = Bounds::new(-DVec3::ONE, DVec3::ONE);
    let point = Bounds::new(DVec3::ONE, DVec3::ONE);
    for boxes in [vec![(cube, 7)], (0..1000).map(|i| (cube, i)).collect(), vec![(point, 0); 3]] {
        for kind in [Accelerator::Bvh, Accelerator::Octree] {
            let tree = Accel::new(boxes.clone(), kind);
            let mut count = 0;
            tree.along(&Ray::new(DVec3::new(1.0, 1.0, -9.0), DVec3::Z), Range::AHEAD, |_| {
                count += 1;
                f64::INFINITY
            });
            assert_eq!(count, boxes.len(), "{kind:?}");
        }
    }
}

#[test]
fn a_near_hit_ends_the_search() {
    let boxes: Vec<_> = (0..1000)
        .map(|i| (Bounds::new(DVec3::splat(f64::from(i)), DVec3::splat(f64::from(i) + 0.5)), i))
        .collect();
    for kind in [Accelerator::Bvh, Accelerator::Octree] {
        let tree = Accel::new(boxes.clone(), kind);
        let mut asked = Vec::new();
        tree.along(&Ray::new(DVec3::splat(-1.0), DVec3::ONE.normalize()), Range::AHEAD, |item| {
            asked.push(item);
            2.0
        });
        assert_eq!(asked, [0], "{kind:?}");
    }
}

#[test]
fn negative_infinity_ends_the_search_at_once() {
    let mut numbers = Numbers(9);
    let boxes = boxes(&mut numbers, 60, 1.0, DVec3::ZERO);
    for kind in [Accelerator::Linear, Accelerator::Octree, Accelerator::Bvh] {
        let accel = Accel::new(boxes.clone(), kind);
        for _ in 0..50 {
            let ray = Ray::new(DVec3::Z * -4.0, (numbers.vector() + DVec3::Z * 4.0).normalize());
            let mut visits = 0;
            accel.along(&ray, Range::AHEAD, |_| {
                visits += 1;
                f64::NEG_INFINITY
            });
            assert!(visits <= 1, "{kind:?} went on {visits} times");
        }
    }
}
