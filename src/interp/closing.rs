//! What is said about a scene as a whole, once all of it was read.

use super::Vm;
use crate::diag::Severity;

/// Features of POV-Ray 3.7 that it calls experimental, in its own words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "each is what its description says")]
pub enum Experimental {
    Spline,
    Slope,
    Subsurface,
    Backside,
    MeshCamera,
    Tiff,
}

impl Experimental {
    fn text(self) -> &'static str {
        match self {
            Experimental::Spline => "`spline`",
            Experimental::Slope => "`slope` with `altitude`",
            Experimental::Subsurface => "`subsurface`",
            Experimental::Backside => "`diffuse` of the back side",
            Experimental::MeshCamera => "`mesh_camera`",
            Experimental::Tiff => "TIFF images",
        }
    }
}

impl Vm<'_> {
    /// Notes that a scene uses an experimental feature.
    pub fn note_experimental(&mut self, feature: Experimental) {
        if !self.experimental.contains(&feature) {
            self.experimental.push(feature);
        }
    }

    /// Says what concerns the scene as a whole; docs/spec/language.md 2.11 and 7.2.
    pub(super) fn closing_remarks(&mut self) {
        self.remark_gamma();
        self.remark_version();
        if !self.experimental.is_empty() {
            let features: Vec<&str> = self.experimental.iter().map(|feature| feature.text()).collect();
            let message =
                format!("the scene uses what POV-Ray 3.7 calls experimental: {}", features.join(", "));
            let help = "another version of POV-Ray may read it differently";
            self.remark(Severity::Warning, &message, help);
        }
    }

    fn remark_gamma(&mut self) {
        if self.gamma.is_some() {
            return;
        }
        if self.version_written && self.version >= 370 {
            self.remark(
                Severity::Possible,
                "the scene does not set `assumed_gamma`, so 1.0 is assumed",
                "write `global_settings { assumed_gamma 1.0 }`",
            );
        } else {
            self.remark(
                Severity::Warning,
                "the scene does not set `assumed_gamma`, so colors are not corrected for the display",
                "that is how scenes before version 3.7 are rendered; newer ones set `global_settings { assumed_gamma 1.0 }`",
            );
        }
    }

    fn remark_version(&mut self) {
        if !self.version_written {
            self.remark_missing_version("the scene does not say which version of the language it is in");
        } else if self.version_late {
            self.remark_missing_version("`#version` is not the first thing in the scene");
        }
        if self.version_written && self.version < 350 {
            let version = f64::from(self.version) / 100.0;
            let message = format!("the scene is in version {version:.1} of the language");
            let help = "what it owes to mistakes of POV-Ray 3.1 and older looks different";
            self.remark(Severity::Warning, &message, help);
        }
    }
}
