//! What is finished of a picture that isn't: the file `NAME.pov-state` (docs/spec/camera-image.md 21).
//!
//! It appears when a rendering begins, grows with its blocks and goes when the picture is there. After a
//! stop, however sudden, `+C` takes the blocks from it and renders only the others. A moment's work may be
//! lost: blocks that are soon finished are written together, and those of a quick rendering never.
//!
//! The file is povista's own, not POV-Ray's: a line of text, a number that tells which picture it belongs
//! to, then records of a block's place, its pixels as they come from the renderer, and a checksum.

use std::collections::HashMap;
use std::fs::{File, OpenOptions};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use rustc_hash::FxHasher;

use crate::options::{LanguageOptions, Region, RenderOptions};
use crate::render::Sample;
use crate::source::Sources;

/// What the file begins with.
const HEAD: &[u8] = concat!("povista ", env!("CARGO_PKG_VERSION"), " render state\n").as_bytes();

/// Bytes of a block's place, of a pixel and of a checksum.
const PLACE: usize = 16;
const PIXEL: usize = 16;
const CHECKSUM: usize = 8;

/// How long finished blocks may wait to be written.
const MOMENT: Duration = Duration::from_millis(100);

/// A block: first and last column and row, as the file says it.
type Place = [u32; 4];

/// The finished part of a picture, in memory and on the disk.
pub(super) struct State {
    path: PathBuf,
    inner: Mutex<Inner>,
}

struct Inner {
    /// None once the disk takes no more.
    file: Option<File>,
    /// Blocks of an earlier run that nobody has asked for yet.
    known: HashMap<Place, Vec<Sample>>,
    /// Finished blocks that are yet to be written.
    waiting: Vec<(Place, Vec<Sample>)>,
    /// When blocks were last written.
    written: Instant,
}

impl Inner {
    /// Writes what waits; what doesn't fit on the disk is rendered again another time.
    fn write(&mut self) {
        for (place, pixels) in self.waiting.drain(..) {
            let Some(file) = &mut self.file else { break };
            let mut record = Vec::with_capacity(PLACE + pixels.len() * PIXEL + CHECKSUM);
            place.iter().for_each(|edge| record.extend_from_slice(&edge.to_le_bytes()));
            pixels.iter().flatten().for_each(|channel| record.extend_from_slice(&channel.to_le_bytes()));
            record.extend(checksum(&record).to_le_bytes());
            if file.write_all(&record).is_err() {
                self.file = None;
            }
        }
        self.written = Instant::now();
    }
}

impl Drop for Inner {
    fn drop(&mut self) {
        self.write();
    }
}

/// What became of an earlier run's file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Found {
    /// There was none, or nobody asked.
    Nothing,
    /// It holds so many pixels of this picture.
    Pixels(u64),
    /// It belongs to another picture: another scene, size or way to render.
    Another,
}

/// Where the state of a picture's file is kept.
pub(super) fn path_beside(picture: &Path) -> PathBuf {
    picture.with_extension("pov-state")
}

/// A number that differs when the picture may.
///
/// Threads and the ways to find objects never change it, so that a rendering can be continued with others.
pub(super) fn fingerprint(sources: &Sources, language: &LanguageOptions, render: &RenderOptions) -> u64 {
    let RenderOptions {
        width, height, region, block_size, antialias, sampling, quality, output_alpha, ..
    } = render;
    let RenderOptions { remove_bounds, split_unions, high_reproducibility, .. } = render;
    let LanguageOptions { declares, version, clock, .. } = language;
    let mut hasher = DefaultHasher::new();
    let look = (width, height, region, block_size, antialias, sampling, quality, output_alpha);
    let rest = (remove_bounds, split_unions, high_reproducibility, declares, version, clock);
    format!("{look:?} {rest:?}").hash(&mut hasher);
    for source in sources.all() {
        source.fingerprint().hash(&mut hasher);
    }
    hasher.finish()
}

impl State {
    /// Begins the file of a picture, with what an earlier run left if the trace is to be continued.
    ///
    /// # Errors
    /// The file cannot be read or written.
    pub(super) fn open(path: PathBuf, fingerprint: u64, continued: bool) -> io::Result<(Self, Found)> {
        let mut file = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(&path)?;
        let mut bytes = Vec::new();
        if continued {
            file.read_to_end(&mut bytes)?;
        }
        let (known, kept, found) = match body(&bytes, fingerprint) {
            Some(body) => {
                let (known, length) = records(body);
                let pixels = known.values().map(|pixels| pixels.len() as u64).sum();
                (known, bytes.len() - body.len() + length, Found::Pixels(pixels))
            }
            None if bytes.is_empty() => (HashMap::new(), 0, Found::Nothing),
            None => (HashMap::new(), 0, Found::Another),
        };
        // What was torn when the earlier run ended is written anew.
        file.set_len(kept as u64)?;
        file.seek(SeekFrom::End(0))?;
        if kept == 0 {
            file.write_all(HEAD)?;
            file.write_all(&fingerprint.to_le_bytes())?;
        }
        let inner = Inner { file: Some(file), known, waiting: Vec::new(), written: Instant::now() };
        Ok((Self { path, inner: Mutex::new(inner) }, found))
    }

    /// The pixels of a block that an earlier run finished.
    pub(super) fn take(&self, block: &Region) -> Option<Vec<Sample>> {
        self.lock().known.remove(&place(block))
    }

    /// Adds a finished block.
    pub(super) fn add(&self, block: &Region, pixels: &[Sample]) {
        let mut inner = self.lock();
        inner.waiting.push((place(block), pixels.to_vec()));
        if inner.written.elapsed() >= MOMENT {
            inner.write();
        }
    }

    /// The file.
    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// Removes the file: the picture is there.
    pub(super) fn finish(self) {
        self.lock().waiting.clear();
        // A state that stays is of no harm: it is replaced or continued by the next run.
        let _ = std::fs::remove_file(&self.path);
    }

    /// The contents; a thread that panicked while it held them left a whole record or none.
    fn lock(&self) -> MutexGuard<'_, Inner> {
        self.inner.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// What follows the head, if the file belongs to the picture.
fn body(bytes: &[u8], fingerprint: u64) -> Option<&[u8]> {
    bytes.strip_prefix(HEAD)?.strip_prefix(&fingerprint.to_le_bytes())
}

/// The whole records at the start of a file's body, and how many bytes they are.
fn records(body: &[u8]) -> (HashMap<Place, Vec<Sample>>, usize) {
    let mut known = HashMap::new();
    let mut rest = body;
    while let Some((place, pixels, after)) = record(rest) {
        known.insert(place, pixels);
        rest = after;
    }
    (known, body.len() - rest.len())
}

/// The record a text of bytes begins with, and what follows it.
fn record(bytes: &[u8]) -> Option<(Place, Vec<Sample>, &[u8])> {
    let (edges, _) = bytes.split_at_checked(PLACE)?;
    let [left, right, top, bottom] = numbers(edges)?;
    let count = (right.checked_sub(left)? as usize).checked_mul(bottom.checked_sub(top)? as usize)?;
    let length = count.checked_mul(PIXEL)?.checked_add(PLACE)?;
    let (whole, rest) = bytes.split_at_checked(length)?;
    let (sum, rest) = rest.split_at_checked(CHECKSUM)?;
    if checksum(whole).to_le_bytes() != sum {
        return None;
    }
    let pixels = whole[PLACE..].chunks_exact(PIXEL).filter_map(numbers).map(|bits| bits.map(f32::from_bits));
    Some(([left, right, top, bottom], pixels.collect(), rest))
}

/// Four numbers of 32 bits.
fn numbers(bytes: &[u8]) -> Option<[u32; 4]> {
    let mut numbers = [0; 4];
    for (number, bytes) in numbers.iter_mut().zip(bytes.chunks_exact(4)) {
        *number = u32::from_le_bytes(bytes.try_into().ok()?);
    }
    Some(numbers)
}

fn checksum(bytes: &[u8]) -> u64 {
    let mut hasher = FxHasher::default();
    hasher.write(bytes);
    hasher.finish()
}

fn place(block: &Region) -> Place {
    [block.columns.start, block.columns.end, block.rows.start, block.rows.end]
}

#[cfg(test)]
mod tests {
    use super::*;

    const BLOCKS: [Region; 2] = [Region { columns: 0..3, rows: 0..2 }, Region { columns: 3..5, rows: 0..2 }];

    fn pixels(block: &Region, number: f32) -> Vec<Sample> {
        (0..block.area()).map(|index| [index as f32, number, f32::NAN, -0.0]).collect()
    }

    /// A file with both blocks.
    fn written(path: &Path) {
        let (state, found) = State::open(path.to_owned(), 7, true).expect("a new file");
        assert_eq!(found, Found::Nothing);
        for (number, block) in BLOCKS.iter().enumerate() {
            assert_eq!(state.take(block), None);
            state.add(block, &pixels(block, number as f32));
        }
    }

    #[test]
    fn blocks_come_back_to_the_bit() {
        let folder = tempfile::tempdir().expect("a folder for the test");
        let path = folder.path().join("a.pov-state");
        written(&path);
        let (state, found) = State::open(path.clone(), 7, true).expect("the file is there");
        assert_eq!(found, Found::Pixels(10));
        for (number, block) in BLOCKS.iter().enumerate() {
            let bits = |pixels: Vec<Sample>| pixels.iter().flatten().map(|c| c.to_bits()).collect::<Vec<_>>();
            let taken = state.take(block).expect("a known block");
            assert_eq!(bits(taken), bits(pixels(block, number as f32)));
        }
        state.finish();
        assert!(!path.exists());
    }

    #[test]
    fn a_torn_record_is_dropped_and_the_next_one_follows_the_whole_ones() {
        let folder = tempfile::tempdir().expect("a folder for the test");
        let path = folder.path().join("a.pov-state");
        written(&path);
        let bytes = std::fs::read(&path).expect("the file is there");
        let mut flipped = bytes.clone();
        *flipped.last_mut().expect("it isn't empty") ^= 1;
        for torn in [bytes[..bytes.len() - 5].to_vec(), flipped, [&bytes[..], &[9; 40]].concat()] {
            std::fs::write(&path, &torn).expect("the folder takes files");
            let (state, _) = State::open(path.clone(), 7, true).expect("the file is there");
            assert!(state.take(&BLOCKS[0]).is_some());
            if state.take(&BLOCKS[1]).is_none() {
                state.add(&BLOCKS[1], &pixels(&BLOCKS[1], 1.0));
            }
            drop(state);
            assert_eq!(std::fs::read(&path).expect("the file is there"), bytes);
        }
    }

    #[test]
    fn the_state_of_another_picture_is_not_used() {
        let folder = tempfile::tempdir().expect("a folder for the test");
        let path = folder.path().join("a.pov-state");
        written(&path);
        for (fingerprint, continued, expected) in
            [(8, true, Found::Another), (8, false, Found::Nothing), (7, true, Found::Another)]
        {
            let (state, found) =
                State::open(path.clone(), fingerprint, continued).expect("the file is there");
            assert_eq!((found, state.take(&BLOCKS[0])), (expected, None));
        }
        std::fs::write(&path, "something else").expect("the folder takes files");
        assert_eq!(State::open(path, 7, true).expect("the file is there").1, Found::Another);
    }

    #[test]
    fn the_fingerprint_tells_pictures_apart_but_not_threads() {
        let language = LanguageOptions::default();
        let options = RenderOptions::new(8, 6);
        let of = |language: &LanguageOptions, options: &RenderOptions, text: &str| {
            let mut sources = Sources::default();
            sources.add(crate::source::Source::new("a.pov", "", text.into()));
            fingerprint(&sources, language, options)
        };
        let this = of(&language, &options, "a");
        assert_eq!(this, of(&language, &RenderOptions { threads: Some(3), ..options.clone() }, "a"));
        assert_ne!(this, of(&language, &options, "b"));
        assert_ne!(this, of(&language, &RenderOptions::new(6, 8), "a"));
        assert_ne!(this, of(&language, &RenderOptions { quality: 3, ..options.clone() }, "a"));
        let clock = crate::options::Clock { value: 0.5, ..language.clock };
        assert_ne!(this, of(&LanguageOptions { clock, ..language }, &options, "a"));
    }
}
