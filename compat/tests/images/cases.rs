//! Files with what is asked of them, and the comparison.

use std::fmt::Write as _;
use std::fs;
use std::time::Duration;

use povista_compat::numbers::{FILE, printed};
use povista_compat::program::Program;
use tempfile::TempDir;

/// Pixels of every image made here.
pub(crate) const WIDTH: usize = 16;
pub(crate) const HEIGHT: usize = 12;

/// Processor seconds for one scene.
const LIMIT: Duration = Duration::from_secs(120);

/// Repeatable bytes.
pub(crate) struct Noise(pub(crate) u64);

impl Noise {
    pub(crate) fn byte(&mut self) -> u8 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 56) as u8
    }

    pub(crate) fn bytes(&mut self, count: usize) -> Vec<u8> {
        (0..count).map(|_| self.byte()).collect()
    }

    /// Numbers below `end`.
    pub(crate) fn below(&mut self, end: usize, count: usize) -> Vec<u8> {
        (0..count).map(|_| (usize::from(self.byte()) % end) as u8).collect()
    }
}

/// Functions to be evaluated by both programs.
pub(crate) struct Cases {
    folder: TempDir,
    files: usize,
    /// What a message calls each function, its body, and the components to print.
    functions: Vec<(String, String, &'static [&'static str])>,
    points: String,
    /// What the scene begins with.
    header: String,
}

impl Cases {
    /// Functions that are asked at the middle of every pixel.
    pub(crate) fn at_pixels() -> Self {
        Self::at(&format!(
            "#for(J,0,{HEIGHT}-1) #for(I,0,{WIDTH}-1) #local X=(I+.5)/{WIDTH}; #local Y=(J+.5)/{HEIGHT}; #local Z=0;\n\
             PRINT #end #end"
        ))
    }

    /// Functions that are asked where `points` says, statements around `PRINT` that set X, Y and Z.
    pub(crate) fn at(points: &str) -> Self {
        Self {
            folder: tempfile::tempdir().unwrap(),
            files: 0,
            functions: Vec::new(),
            points: points.to_owned(),
            header: "#version 3.7; global_settings{assumed_gamma 1}".to_owned(),
        }
    }

    /// The same in a scene that begins otherwise.
    pub(crate) fn under(self, header: &str) -> Self {
        Self { header: header.to_owned(), ..self }
    }

    /// Puts a file where both programs find it; its name.
    pub(crate) fn file(&mut self, extension: &str, bytes: &[u8]) -> String {
        let name = format!("{}.{extension}", self.files);
        self.files += 1;
        fs::write(self.folder.path().join(&name), bytes).unwrap();
        name
    }

    /// Asks for the colours of an `image_map`.
    pub(crate) fn colors(&mut self, about: &str, map: &str) {
        self.add(
            about,
            format!("pigment{{image_map{{{map}}}}}"),
            &[".red", ".green", ".blue", ".filter", ".transmit"],
        );
    }

    /// Asks for the values of an `image_pattern`.
    pub(crate) fn values(&mut self, about: &str, map: &str) {
        self.add(about, format!("pattern{{image_pattern{{{map}}}}}"), &[""]);
    }

    /// Asks for the components of any function.
    pub(crate) fn add(&mut self, about: &str, body: String, components: &'static [&'static str]) {
        self.functions.push((about.to_owned(), body, components));
    }

    /// Asks for a file in all the usual ways: a keyword and the file's bytes.
    pub(crate) fn usual(&mut self, about: &str, keyword: &str, bytes: &[u8]) {
        let name = self.file(keyword, bytes);
        for after in ["", "gamma 1", "gamma srgb interpolate 2", "premultiplied on", "premultiplied off"] {
            self.colors(&format!("{about}, {after}"), &format!("{keyword} \"{name}\" {after}"));
        }
        for after in ["", "use_alpha", "gamma 2"] {
            self.values(&format!("{about}, pattern {after}"), &format!("{keyword} \"{name}\" {after}"));
        }
    }

    /// Compares both programs' numbers: the greatest difference has to stay within `allowed`.
    #[track_caller]
    pub(crate) fn compare(&self, allowed: f64) {
        let scene = self.scene();
        let [theirs, ours] = [Program::povray(), Program::povista()]
            .map(|program| program.and_then(|program| printed(&program, self.folder.path(), &scene, LIMIT)))
            .map(|numbers| numbers.unwrap_or_else(|error| panic!("{error}")));
        let components: Vec<_> =
            self.functions.iter().map(|(about, _, components)| (about, components.len())).collect();
        let each = theirs.len() / components.iter().map(|(_, count)| count).sum::<usize>();
        let mut start = 0;
        let mut wrong = String::new();
        let mut greatest: f64 = 0.0;
        for (about, count) in components {
            let range = start..start + count * each;
            start = range.end;
            let pairs = theirs[range.clone()].iter().zip(&ours[range]);
            // NaN where both have it is no difference.
            let differences = pairs.map(|(a, b)| if a.is_nan() && b.is_nan() { 0.0 } else { (a - b).abs() });
            let worst =
                differences.fold(0.0, |worst: f64, d| if d.is_nan() { f64::NAN } else { worst.max(d) });
            greatest = greatest.max(worst);
            if worst.is_nan() || worst > allowed {
                writeln!(wrong, "{about}: {worst}").unwrap();
            }
        }
        println!(
            "{} functions, {} numbers, greatest difference {greatest}",
            self.functions.len(),
            theirs.len()
        );
        assert_eq!((theirs.len(), start), (ours.len(), theirs.len()));
        assert!(wrong.is_empty(), "{wrong}");
    }

    fn scene(&self) -> String {
        let mut scene = format!("{} #fopen OUT \"{FILE}\" write\n", self.header);
        for (number, (_, body, components)) in self.functions.iter().enumerate() {
            writeln!(scene, "#declare F{number}=function{{{body}}}").unwrap();
            let print = |c: &&str| format!("str(F{number}(X,Y,Z){c},0,17),\" \"");
            let print: Vec<_> = components.iter().map(print).collect();
            let print = format!("#write(OUT,{},\"\\n\")", print.join(","));
            writeln!(scene, "{}", self.points.replace("PRINT", &print)).unwrap();
        }
        scene + "#fclose OUT camera{}"
    }
}
