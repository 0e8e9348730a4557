//! Cuts the picture into blocks and hands them to threads (docs/spec/camera-image.md 10).

use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

use rayon::prelude::*;

use super::film::Image;
use super::sampling::Sample;
use super::stats::Statistics;
use super::{Progress, Rendered};
use crate::options::{Region, RenderOptions};

/// Stack of a thread that renders: the ray tree is at most 256 levels deep.
const STACK: usize = 64 << 20;

/// Renders every block of the picture with `render`, which gives the colours of a block's pixels
/// row by row.
pub(super) fn render(
    options: &RenderOptions,
    progress: &dyn Progress,
    render: impl Fn(&Region) -> (Vec<Sample>, Statistics) + Sync,
) -> Rendered {
    let blocks = blocks(&options.region, options.block_size.min(options.width.max(options.height)));
    let total = options.region.area();
    let done = AtomicU64::new(0);
    let finished = Mutex::new((Image::new(options.width, options.height), Statistics::default()));
    let work = |block: &Region| {
        let (pixels, statistics) = match progress.known(block) {
            Some(pixels) => (pixels, Statistics::default()),
            None => {
                let rendered = render(block);
                progress.keep(block, &rendered.0);
                rendered
            }
        };
        if let Ok(mut finished) = finished.lock() {
            paste(&mut finished.0, block, &pixels);
            finished.1 += statistics;
        }
        let before = done.fetch_add(block.area(), Ordering::Relaxed);
        progress.advance(before + block.area(), total);
    };
    if options.threads == Some(1) {
        // The thread that waits may as well work.
        stacker::grow(STACK, || blocks.iter().for_each(work));
    } else {
        let mut builder = rayon::ThreadPoolBuilder::new().stack_size(STACK);
        if let Some(threads) = options.threads {
            builder = builder.num_threads(threads);
        }
        let all = || blocks.par_iter().with_max_len(1).for_each(work);
        match builder.build() {
            Ok(pool) => pool.install(all),
            // No threads to be had: the caller's own pool is slower, not different.
            Err(_) => all(),
        }
    }
    let (image, statistics) = finished.into_inner().unwrap_or_else(|poisoned| poisoned.into_inner());
    Rendered { image, statistics }
}

/// The squares of a region, row by row from its top left corner.
fn blocks(region: &Region, edge: u32) -> Vec<Region> {
    let edge = edge.max(1) as usize;
    let cut = |start: u32, end: u32| {
        (start..end).step_by(edge).map(move |from| from..end.min(from.saturating_add(edge as u32)))
    };
    let (rows, columns) = (&region.rows, &region.columns);
    cut(rows.start, rows.end)
        .flat_map(|rows| {
            cut(columns.start, columns.end).map(move |columns| Region { columns, rows: rows.clone() })
        })
        .collect()
}

/// Puts a block's pixels into the picture; transmit becomes alpha.
fn paste(image: &mut Image, block: &Region, pixels: &[Sample]) {
    let width = block.columns.len();
    for (row, line) in block.rows.clone().zip(pixels.chunks_exact(width)) {
        let start = row as usize * image.width as usize + block.columns.start as usize;
        for (pixel, &[r, g, b, transmit]) in image.pixels[start..start + width].iter_mut().zip(line) {
            *pixel = [r, g, b, 1.0 - transmit];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_cover_the_region_once_from_its_corner() {
        let region = Region { columns: 3..75, rows: 5..40 };
        let blocks = blocks(&region, 32);
        assert_eq!(blocks[0], Region { columns: 3..35, rows: 5..37 });
        assert_eq!(blocks[2], Region { columns: 67..75, rows: 5..37 });
        assert_eq!(blocks.iter().map(Region::area).sum::<u64>(), region.area());
    }

    #[test]
    fn an_empty_region_has_no_blocks() {
        assert_eq!(blocks(&Region { columns: 5..5, rows: 0..9 }, 32), []);
        #[expect(clippy::reversed_empty_ranges, reason = "what `+SC5 +EC3` asks for")]
        let backwards = Region { columns: 5..3, rows: 0..9 };
        assert_eq!(blocks(&backwards, 32), []);
    }
}
