//! Space cut into eighths: a ray walks from cell to cell, and the first hit ends its search.
//!
//! An item is listed in every leaf cell its box touches. Neighbouring cells share the numbers of the planes
//! between them, and the test of a box against a ray is monotone in those numbers: so a ray that meets an item's
//! box meets a cell that lists it, whatever rounding does.

use std::cell::RefCell;

use super::Hull;
use super::linear::Slabs;
use crate::math::{Bounds, DVec3};
use crate::world::ray::{Range, Ray};

/// Cells with no more items are not cut.
const FEW: usize = 8;

/// A leaf this deep is a 4096th as wide as the whole.
const DEEPEST: u32 = 12;

/// A cell is left whole whose eighths would list so many times its items: they overlap too much.
const MOST_COPIES: usize = 4;

/// A tree of cells over bounded items.
#[derive(Debug)]
pub struct Octree {
    items: Vec<(Bounds, u32)>,
    /// The root first.
    cells: Vec<Cell>,
    /// What leaf cells list: places among the items.
    lists: Vec<u32>,
}

#[derive(Clone, Copy, Debug)]
struct Cell {
    bounds: Bounds,
    content: Content,
}

#[derive(Clone, Copy, Debug)]
enum Content {
    /// Eight cells from this one on.
    Eighths(u32),
    /// A part of the lists.
    Items { first: u32, end: u32 },
}

/// Which items a walk has come across: those whose mark is its number.
#[derive(Debug, Default)]
struct Marks {
    marks: Vec<u32>,
    walk: u32,
}

thread_local! {
    /// Walks nest where a member of a compound is asked, so there may be several.
    static SPARE: RefCell<Vec<Marks>> = const { RefCell::new(Vec::new()) };
}

impl Marks {
    /// Lends marks for so many items, none of which has been seen.
    fn lend(items: usize, walk: impl FnOnce(&mut Self)) {
        let mut marks = SPARE.with_borrow_mut(Vec::pop).unwrap_or_default();
        if marks.walk == u32::MAX {
            marks = Self::default();
        }
        marks.walk += 1;
        if marks.marks.len() < items {
            marks.marks.resize(items, 0);
        }
        walk(&mut marks);
        SPARE.with_borrow_mut(|spare| spare.push(marks));
    }

    /// Whether the item is seen for the first time.
    fn is_new(&mut self, item: u32) -> bool {
        std::mem::replace(&mut self.marks[item as usize], self.walk) != self.walk
    }
}

impl Octree {
    /// Takes items, all bounded.
    pub fn new(items: Vec<(Bounds, u32)>) -> Self {
        let bounds = items.iter().fold(Bounds::EMPTY, |all, (bounds, _)| all.union(*bounds));
        let all: Vec<u32> = (0..items.len() as u32).collect();
        let mut tree = Self { items, cells: Vec::new(), lists: Vec::new() };
        tree.cells.push(Cell { bounds, content: Content::Eighths(0) });
        tree.fill(0, all, 0);
        tree
    }

    /// Lists items in a cell, or in its eighths.
    fn fill(&mut self, cell: usize, items: Vec<u32>, depth: u32) {
        let bounds = self.cells[cell].bounds;
        let eighths = eighths(bounds);
        if items.len() > FEW && depth < DEEPEST && bounds.center().is_finite() {
            let within = |eighth: &Bounds| -> Vec<u32> {
                items.iter().copied().filter(|&i| touch(eighth, &self.items[i as usize].0)).collect()
            };
            let lists = eighths.each_ref().map(within);
            if lists.iter().map(Vec::len).sum::<usize>() < MOST_COPIES * items.len() {
                drop(items);
                let first = self.cells.len();
                self.cells[cell].content = Content::Eighths(first as u32);
                let empty = Content::Items { first: 0, end: 0 };
                self.cells.extend(eighths.map(|bounds| Cell { bounds, content: empty }));
                for (eighth, list) in (first..).zip(lists) {
                    self.fill(eighth, list, depth + 1);
                }
                return;
            }
        }
        let first = self.lists.len() as u32;
        self.lists.extend(items);
        self.cells[cell].content = Content::Items { first, end: self.lists.len() as u32 };
    }

    /// See [`Accel::along`](super::Accel::along).
    pub fn along(&self, ray: &Ray, range: Range, mut visit: impl FnMut(u32) -> f64) {
        let slabs = Slabs::new(ray);
        let mut range = range;
        Marks::lend(self.items.len(), |marks| {
            let mut waiting = vec![(f64::NEG_INFINITY, 0)];
            while let Some((entry, cell)) = waiting.pop() {
                // The end may have come nearer while the cell waited.
                if !Slabs::in_reach(entry, range.max) {
                    continue;
                }
                match self.cells[cell as usize].content {
                    Content::Eighths(first) => {
                        let from = waiting.len();
                        for eighth in first..first + 8 {
                            let met = slabs.entry(&self.cells[eighth as usize].bounds, range);
                            waiting.extend(met.map(|entry| (entry, eighth)));
                        }
                        waiting[from..].sort_by(|a, b| b.0.total_cmp(&a.0));
                    }
                    Content::Items { first, end } => {
                        for &item in &self.lists[first as usize..end as usize] {
                            let (bounds, number) = &self.items[item as usize];
                            if slabs.meet(bounds, range) && marks.is_new(item) {
                                range.max = visit(*number);
                                if range.max == f64::NEG_INFINITY {
                                    return;
                                }
                            }
                        }
                    }
                }
            }
        });
    }

    /// See [`Accel::any_touching`](super::Accel::any_touching).
    pub fn any_touching(&self, hull: &Hull, mut test: impl FnMut(u32) -> bool) -> bool {
        self.items.iter().any(|(bounds, number)| hull.meets(bounds) && test(*number))
    }

    /// See [`Accel::any_around`](super::Accel::any_around): items on the border between cells may be
    /// tested more than once.
    pub fn any_around(&self, point: DVec3, mut test: impl FnMut(u32) -> bool) -> bool {
        let mut waiting = vec![0];
        while let Some(cell) = waiting.pop() {
            let Cell { bounds, content } = self.cells[cell as usize];
            if !bounds.contains(point) {
                continue;
            }
            match content {
                Content::Eighths(first) => waiting.extend(first..first + 8),
                Content::Items { first, end } => {
                    let items = self.lists[first as usize..end as usize].iter();
                    let mut around = items.map(|&item| &self.items[item as usize]);
                    if around.any(|(bounds, number)| bounds.contains(point) && test(*number)) {
                        return true;
                    }
                }
            }
        }
        false
    }
}

/// The eighths of a box.
fn eighths(Bounds { min, max }: Bounds) -> [Bounds; 8] {
    let middle = min * 0.5 + max * 0.5;
    std::array::from_fn(|number| {
        let mut eighth = Bounds { min, max };
        for axis in 0..3 {
            if number >> axis & 1 == 0 {
                eighth.max[axis] = middle[axis];
            } else {
                eighth.min[axis] = middle[axis];
            }
        }
        eighth
    })
}

/// Whether two boxes share a point, be it of their borders.
fn touch(a: &Bounds, b: &Bounds) -> bool {
    a.min.cmple(b.max).all() && b.min.cmple(a.max).all()
}
