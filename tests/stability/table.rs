//! What was reached, kept in `table.txt`, and of some subjects under many more rays in `many.txt`.

use std::fmt::Write;
use std::path::PathBuf;
use std::sync::Mutex;
use std::time::SystemTime;

use crate::shoot::Score;
use crate::{RAYS, povray, told};

/// Several tests may renew their rows at once.
static FILE: Mutex<()> = Mutex::new(());

const HEAD: &str = "\
subject                 where       rays     hits   false  missed  undecidable      ulps     degrees
";

/// A table: ours, that of many rays, or POV-Ray's where it is asked.
fn path(name: &str) -> PathBuf {
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

/// How many rays a table was made with; where that was by hand, when and how.
fn notes() -> String {
    if povray::rays().is_some() {
        return String::new();
    }
    let Some(rays) = told() else {
        return format!("# {RAYS} rays to each of 5 sizes and 3 places.\n");
    };
    let seconds = SystemTime::UNIX_EPOCH.elapsed().map_or(0, |time| time.as_secs());
    let date = chrono::DateTime::from_timestamp(seconds as i64, 0).unwrap_or_default().date_naive();
    let command = "cargo test --profile testing --test stability NAME";
    format!(
        "# {rays} rays to each of 5 sizes and 3 places.\n\
         # POVISTA_STABILITY=renew POVISTA_STABILITY_RAYS={rays} {command}, last on {date}.\n"
    )
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
    let renew =
        povray::rays().is_some() || std::env::var("POVISTA_STABILITY").is_ok_and(|word| word == "renew");
    let file = path(match (povray::rays(), renew && told().is_some()) {
        (Some(_), _) => "povray.txt",
        (None, true) => "many.txt",
        (None, false) => "table.txt",
    });
    let _guard = FILE.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    let table = std::fs::read_to_string(&file).unwrap_or_default();
    let of = |row: &str| row.split_whitespace().take(2).collect::<Vec<_>>().join(" ");
    if renew {
        let is_kept = |old: &&str| !old.starts_with('#') && !rows.iter().any(|row| of(row) == of(old));
        let mut kept: Vec<&str> = table.lines().skip(1).filter(is_kept).collect();
        kept.extend(rows.iter().map(String::as_str));
        kept.sort_by_key(|row| (row.split_whitespace().next().map(str::to_owned), row.contains("places")));
        std::fs::write(file, format!("{HEAD}{}\n{}", kept.join("\n"), notes()))
            .expect("the table can be written");
        return;
    }
    for row in &rows {
        let old = table.lines().find(|old| of(old) == of(row));
        let old = old.unwrap_or_else(|| panic!("the table has no row for `{}`", of(row)));
        let (now, then) = (bars(row), bars(old));
        // Twice as many rays find worse ones: by hand only what is wrong counts.
        let count = if told().is_some() { 2 } else { 4 };
        assert!(
            now.iter().zip(&then).take(count).all(|(now, then)| now <= then),
            "worse than it was:\n{HEAD}{row}\n{old}"
        );
    }
}
