//! Every primitive under rays of all scales, with each crossing proven by interval arithmetic.
//!
//! `table.txt` holds what was reached; a test fails where anything gets worse. To renew it:
//!
//! ```text
//! POVISTA_STABILITY=renew cargo test --profile testing --test stability
//! ```
//!
//! and by hand, with more rays to a scale (`POVISTA_STABILITY_SHOW=1` shows those that go wrong,
//! `POVISTA_STABILITY=renew` keeps the row in `many.txt`):
//!
//! ```text
//! POVISTA_STABILITY_RAYS=1000000 cargo test --profile testing --test stability -- --nocapture
//! ```

mod certify;
mod curve;
mod double;
mod form;
mod interval;
mod invariance;
mod model;
mod povray;
mod real;
mod shoot;
mod subject;
mod table;

use std::sync::atomic::{AtomicU64, Ordering};

use povista::compile::compile;
use povista::diag::Collect;
use povista::interp::interpret;
use povista::math::DVec3;
use povista::options::{LanguageOptions, RenderOptions};
use povista::source::{Library, Source, Sources};
use povista::world::World;

use model::Subject;
use shoot::{Score, Target};

/// Sizes a subject is made in.
const SIZES: [f64; 5] = [1e-8, 1e-4, 1.0, 1e4, 1e8];

/// How far from the origin a subject of size 1 is put.
const PLACES: [f64; 3] = [1e3, 1e5, 1e7];

/// Rays to a scale, unless told otherwise: what the bar is measured with.
const RAYS: u64 = 10_000;

/// A distance with an error of more units than these is worth being shown.
const FAR_OFF: f64 = 1000.0;

/// Rays to a scale, where that was told by hand.
fn told() -> Option<u64> {
    std::env::var("POVISTA_STABILITY_RAYS").ok().and_then(|n| n.parse().ok())
}

/// The world with one object.
fn world(object: &str) -> World {
    let text = format!("#version 3.7; global_settings {{ assumed_gamma 1 }} {object}");
    let mut sources = Sources::new(Library::default());
    let main = sources.add(Source::new("subject.pov", "", text.into_bytes()));
    let mut sink = Collect::default();
    let scene = interpret(main, &mut sources, &LanguageOptions::default(), &mut sink);
    let scene = scene.unwrap_or_else(|| panic!("{object:.400}: {:?}", sink.diagnostics));
    let compiled = compile(scene, &RenderOptions::new(8, 6));
    assert!(compiled.unsupported.is_empty(), "{object:.400}: {:?}", compiled.unsupported);
    compiled.world
}

/// Shoots at one object in one place, on all processors.
fn score<M: Subject>(model: &M, object: &str, size: f64, place: DVec3, rays: u64) -> Score {
    let world = world(object);
    let target = Target { model, geometry: &world.geometry, size, place };
    if let Some(rays) = povray::rays() {
        return povray::score(&target, object, rays).unwrap_or_default();
    }
    let next = AtomicU64::new(0);
    let threads = std::thread::available_parallelism().map_or(1, |n| n.get());
    let work = || {
        /// Rays taken at a time.
        const BATCH: u64 = 250;
        let mut score = Score::default();
        loop {
            let from = next.fetch_add(BATCH, Ordering::Relaxed);
            if from >= rays {
                return score;
            }
            for number in from..(from + BATCH).min(rays) {
                let one = target.shoot(number);
                let is_wrong = one.false_hits + one.missed > 0 || one.ulps > FAR_OFF;
                if is_wrong && std::env::var_os("POVISTA_STABILITY_SHOW").is_some() {
                    println!("{object}\n  {}", target.story(number));
                }
                score.add(&one);
            }
        }
    };
    std::thread::scope(|scope| {
        // As much as the threads of the renderer have.
        let spawn = |_| std::thread::Builder::new().stack_size(64 << 20).spawn_scoped(scope, work);
        let workers: Vec<_> =
            (0..threads).map(spawn).map(|worker| worker.expect("there are threads")).collect();
        workers.into_iter().fold(Score::default(), |mut all, worker| {
            all.add(&worker.join().expect("the worker has not panicked"));
            all
        })
    })
}

/// Puts a subject through all sizes and places: what `make` makes is an object and its model.
fn shoot_at<M: Subject>(name: &str, make: impl Fn(f64) -> (String, M)) {
    let rays = told().unwrap_or(RAYS);
    let (mut sized, mut placed) = (Score::default(), Score::default());
    for size in SIZES {
        let (object, model) = make(size);
        sized.add(&score(&model, &object, size, DVec3::ZERO, rays));
    }
    let (object, model) = make(1.0);
    for place in PLACES {
        let at = DVec3::new(1.0, -0.75, 0.5) * place;
        let object = format!("object {{ {object} translate <{:e},{:e},{:e}> }}", at.x, at.y, at.z);
        placed.add(&score(&model, &object, 1.0, at, rays));
    }
    table::judge(name, &sized, &placed);
}
