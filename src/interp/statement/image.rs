//! Image files and what is said about them (docs/spec/language.md 6.12).

use std::sync::Arc;

use crate::interp::stream::TokenKind;
use crate::interp::{Result, Vm, Word};
use crate::math::{DVec2, Gamma};
use crate::scene::image::{ImageFormat, ImageMap, ImageOrigin, ImageSource, PaletteSetting};
use crate::source::{FileKind, Span};

/// What an image is for: decides what may be said about it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Usage {
    /// `image_map`.
    Pigment,
    /// `bump_map`.
    Bumps,
    /// `image_pattern`.
    Pattern,
    /// `material_map`.
    MaterialMap,
    /// `height_field`.
    HeightField,
}

/// Reads the inside of an image block: the file, and what follows it.
pub(super) fn map(vm: &mut Vm<'_>, usage: Usage) -> Result<ImageMap> {
    read_map(vm, usage, &mut None)
}

/// Reads the inside of a `bump_map`; `bump_size` goes to `amount`.
pub(super) fn bumps(vm: &mut Vm<'_>, amount: &mut Option<f32>) -> Result<ImageMap> {
    read_map(vm, Usage::Bumps, amount)
}

fn read_map(vm: &mut Vm<'_>, usage: Usage, amount: &mut Option<f32>) -> Result<ImageMap> {
    // Old scenes give the mapping as a vector before the file: it has no effect any more.
    if matches!(vm.peek()?.kind, TokenKind::Vector(..)) {
        let place = vm.next()?.span;
        vm.warn(place, "the vector before an image has no effect", "rotate the image instead");
        vm.comma()?;
    }
    let mut map = ImageMap {
        source: Arc::new(source(vm, usage)?),
        map_type: 0,
        interpolate: 0,
        once: false,
        repeat: DVec2::ONE,
        offset: DVec2::ZERO,
        filter: Vec::new(),
        transmit: Vec::new(),
        use_index: usage == Usage::MaterialMap,
        use_alpha: false,
    };
    while let Some(word) = vm.peek_word()? {
        match word {
            Word::MapType => map.map_type = choice(vm, &[0, 1, 2, 5], usage == Usage::Pigment)?,
            Word::Interpolate => map.interpolate = choice(vm, &[2, 3, 4], usage == Usage::Pigment)?,
            Word::Once => {
                vm.next()?;
                map.once = true;
            }
            Word::Repeat => map.repeat = repeat(vm)?,
            Word::Offset => map.offset = vm.after_word(Vm::read_uv)?,
            Word::Filter | Word::Transmit if usage == Usage::Pigment => {
                let setting = palette(vm, &map.source.origin)?;
                if word == Word::Filter { &mut map.filter } else { &mut map.transmit }.push(setting);
            }
            Word::UseColor | Word::UseColour | Word::UseIndex => {
                vm.next()?;
                map.use_index = word == Word::UseIndex;
            }
            Word::UseAlpha if usage == Usage::Pattern => {
                vm.next()?;
                map.use_alpha = true;
            }
            Word::BumpSize if usage == Usage::Bumps => *amount = Some(vm.after_word(Vm::read_float)? as f32),
            _ => break,
        }
    }
    Ok(map)
}

/// Reads a number that has to be one of a few.
fn choice(vm: &mut Vm<'_>, known: &[i32], strict: bool) -> Result<u32> {
    let word = vm.next()?;
    let (number, place) = vm.located(Vm::read_int)?;
    if strict && !known.contains(&number) {
        let known: Vec<_> = known.iter().map(i32::to_string).collect();
        let name = vm.sources.text(word.span).to_owned();
        return Err(vm
            .error(place, format!("there is no `{name} {number}`"))
            .help(format!("it is one of {}", known.join(", "))));
    }
    Ok(number.max(0) as u32)
}

fn repeat(vm: &mut Vm<'_>) -> Result<DVec2> {
    vm.next()?;
    let (repeat, place) = vm.located(Vm::read_uv)?;
    if repeat.min_element() <= 0.0 {
        return Err(vm
            .error(place, "an image repeats more often than never")
            .help("both numbers have to be above 0"));
    }
    Ok(repeat)
}

/// Reads `filter all F`, `filter i, F` and the same with `transmit`.
fn palette(vm: &mut Vm<'_>, origin: &ImageOrigin) -> Result<PaletteSetting> {
    let keyword = vm.next()?.span;
    let index = if vm.accept(Word::All)? { None } else { Some(vm.read_count()?) };
    if index.is_some() && matches!(origin, ImageOrigin::Function { .. }) {
        return Err(vm
            .error(keyword.to(vm.last), "the image of a function has no palette")
            .help("write `all` instead of a number"));
    }
    vm.comma()?;
    Ok(PaletteSetting { index, amount: vm.read_float()? as f32 })
}

/// Reads a file or function and how its values are to be understood. The file has to be there.
pub(super) fn source(vm: &mut Vm<'_>, usage: Usage) -> Result<ImageSource> {
    let span = vm.here()?;
    let origin = if vm.peek_word()? == Some(Word::Function) { function(vm)? } else { file(vm, usage, span)? };
    let mut source = ImageSource { span, origin, gamma: None, premultiplied: None };
    while matches!(source.origin, ImageOrigin::File { .. }) {
        match vm.peek_word()? {
            Some(Word::Gamma) => {
                vm.next()?;
                source.gamma = Some(if vm.accept(Word::Srgb)? {
                    Gamma::Srgb
                } else {
                    Gamma::Power(vm.read_float()? as f32)
                });
            }
            Some(Word::Premultiplied) => source.premultiplied = Some(vm.after_word(Vm::read_flag)?),
            _ => break,
        }
        vm.comma()?;
    }
    source.span = span.to(vm.last);
    Ok(source)
}

/// Reads `function width, height { … }`.
fn function(vm: &mut Vm<'_>) -> Result<ImageOrigin> {
    let keyword = vm.next()?;
    let mut size = [0; 2];
    for value in &mut size {
        let (number, place) = vm.located(Vm::read_int)?;
        *value = match u32::try_from(number) {
            Ok(number) if number > 0 => number,
            _ => return Err(vm.error(place, "an image is at least one pixel wide and high")),
        };
        vm.comma()?;
    }
    let function = vm.read_function_after(keyword, true)?;
    Ok(ImageOrigin::Function { width: size[0], height: size[1], function: Arc::new(function) })
}

fn file(vm: &mut Vm<'_>, usage: Usage, start: Span) -> Result<ImageOrigin> {
    let mut format = None;
    if let Some(named) = vm.peek_word()?.and_then(format_of_word) {
        vm.next()?;
        format = Some(named);
    }
    let (name, place) = vm.located(Vm::read_file_name)?;
    let format = match (format, name.rsplit_once('.')) {
        (Some(format), _) => format,
        // A bare name means a file of the kind pictures are written as, which is PNG unless set otherwise.
        (None, None) => ImageFormat::Png,
        (None, Some((_, extension))) => match format_of_extension(extension) {
            Some(format) => format,
            None => {
                return Err(vm
                    .error(place, format!("`{extension}` is no kind of image known here"))
                    .help("write the format before the name, such as `png`"));
            }
        },
    };
    match (format, usage) {
        (ImageFormat::Pot, Usage::HeightField) => {}
        (ImageFormat::Pot, _) => return Err(vm.error(start, "`pot` images are for a `height_field` only")),
        (ImageFormat::Iff, Usage::HeightField) => {
            return Err(vm.error(start, "an `iff` image cannot be used for a `height_field`"));
        }
        _ => {}
    }
    let path = vm.find_file(&name, FileKind::Other(extensions(format)), place)?;
    Ok(ImageOrigin::File { format, name: name.to_string(), path })
}

fn format_of_word(word: Word) -> Option<ImageFormat> {
    use ImageFormat::*;
    Some(match word {
        Word::Gif => Gif,
        Word::Tga => Tga,
        Word::Png => Png,
        Word::Pgm => Pgm,
        Word::Ppm => Ppm,
        Word::Jpeg => Jpeg,
        Word::Tiff => Tiff,
        Word::Bmp => Bmp,
        Word::Exr => Exr,
        Word::Hdr => Hdr,
        Word::Iff => Iff,
        Word::Sys => Sys,
        Word::Pot => Pot,
        _ => return None,
    })
}

/// The format an extension stands for.
fn format_of_extension(extension: &str) -> Option<ImageFormat> {
    use ImageFormat::*;
    Some(match extension.to_ascii_lowercase().as_str() {
        "gif" => Gif,
        "tga" => Tga,
        "png" => Png,
        "pgm" => Pgm,
        "ppm" => Ppm,
        "jpg" | "jpeg" => Jpeg,
        "tif" | "tiff" => Tiff,
        "bmp" => Bmp,
        "exr" => Exr,
        "hdr" => Hdr,
        "iff" => Iff,
        "pot" => Pot,
        _ => return None,
    })
}

/// The extensions that may be left out.
fn extensions(format: ImageFormat) -> &'static [&'static str] {
    use ImageFormat::*;
    match format {
        Gif => &[".gif", ".GIF"],
        Tga => &[".tga", ".TGA"],
        Png => &[".png", ".PNG"],
        Pgm => &[".pgm", ".PGM"],
        Ppm => &[".ppm", ".PPM"],
        Jpeg => &[".jpg", ".JPG", ".jpeg", ".JPEG"],
        Tiff => &[".tif", ".TIF", ".tiff", ".TIFF"],
        Bmp => &[".bmp", ".BMP"],
        Exr => &[".exr", ".EXR"],
        Hdr => &[".hdr", ".HDR"],
        Iff => &[".iff", ".IFF"],
        Pot => &[".pot", ".POT"],
        Sys => &[],
    }
}
