//! What was reached, kept in `table.txt`.

use std::fmt::Write;
use std::path::PathBuf;
use std::sync::Mutex;

use crate::shoot::Score;
use crate::{FEWER, RAYS, povray};

/// Several tests may renew their rows at once.
static FILE: Mutex<()> = Mutex::new(());

const HEAD: &str = "\
subject                 where       rays     hits   false  missed  undecidable      ulps     degrees
";

/// The table: ours, or POV-Ray's where it is asked.
fn path() -> PathBuf {
    let name = if povray::rays().is_some() { "povray.txt" } else { "table.txt" };
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/stability").join(name)
}

fn row(name: &str, place: &str, score: &Score) -> String {
    if score.rays == 0 {
        return format!("{name:<23} {place:<7} refused");
    }
    let mut row = String::new();
    let share = 100.0 * score.undecidable as f64 / score.rays as f64;
    write!(
        row,
        "{name:<23} {place:<7} {:>8} {:>8} {:>7} {:>7} {share:>11.3}% {:>9.2} {:>11.1e}",
        score.rays, score.hits, score.false_hits, score.missed, score.ulps, score.degrees
    )
    .expect("strings can be written to");
    row
}

/// How many rays the table was made with.
fn notes() -> String {
    if povray::rays().is_some() {
        return String::new();
    }
    let fewer = FEWER.iter().map(|(rays, names, why)| format!("# {rays} to {}: {why}.\n", names.join(", ")));
    let all = format!("# {RAYS} rays to each of 5 sizes and 3 places, but for those named here.\n");
    std::iter::once(all).chain(fewer).collect()
}

/// The numbers of a row that must not grow: false, missed, ulps, degrees.
fn bars(row: &str) -> [f64; 4] {
    let words: Vec<&str> = row.split_whitespace().collect();
    [4, 5, 7, 8].map(|i| words.get(i).and_then(|word| word.parse().ok()).unwrap_or(f64::INFINITY))
}

/// Compares with the rows of the table, or renews them.
pub(crate) fn judge(name: &str, sized: &Score, placed: &Score) {
    let rows = [row(name, "sizes", sized), row(name, "places", placed)];
    println!("{HEAD}{}\n{}", rows[0], rows[1]);
    let by_hand = std::env::var_os("POVISTA_STABILITY_RAYS").is_some();
    let renew = povray::rays().is_some()
        || std::env::var("POVISTA_STABILITY").is_ok_and(|word| word == "renew") && !by_hand;
    let _guard = FILE.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    let table = std::fs::read_to_string(path()).unwrap_or_default();
    let of = |row: &str| row.split_whitespace().take(2).collect::<Vec<_>>().join(" ");
    if renew {
        let is_kept = |old: &&str| !old.starts_with('#') && !rows.iter().any(|row| of(row) == of(old));
        let mut kept: Vec<&str> = table.lines().skip(1).filter(is_kept).collect();
        kept.extend(rows.iter().map(String::as_str));
        kept.sort_by_key(|row| (row.split_whitespace().next().map(str::to_owned), row.contains("places")));
        std::fs::write(path(), format!("{HEAD}{}\n{}", kept.join("\n"), notes()))
            .expect("the table can be written");
        return;
    }
    for row in &rows {
        let old = table.lines().find(|old| of(old) == of(row));
        let old = old.unwrap_or_else(|| panic!("the table has no row for `{}`", of(row)));
        let (now, then) = (bars(row), bars(old));
        // Twice as many rays find worse ones: by hand only what is wrong counts.
        let count = if by_hand { 2 } else { 4 };
        assert!(
            now.iter().zip(&then).take(count).all(|(now, then)| now <= then),
            "worse than it was:\n{HEAD}{row}\n{old}"
        );
    }
}
