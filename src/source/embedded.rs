//! Include files that come with povista, for machines where none are installed. An installed
//! file of the same name wins.

/// Name and text of each.
const FILES: &[(&str, &str)] = &[("colors.inc", include_str!("embedded/colors.inc"))];

/// The text of an embedded include file.
pub(super) fn find(name: &str) -> Option<&'static str> {
    FILES.iter().find(|(known, _)| *known == name).map(|&(_, text)| text)
}
