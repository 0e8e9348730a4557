//! The options POV-Ray knows by name (docs/spec/camera-image.md 17).

/// An option of POV-Ray, in the order of their names.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[expect(missing_docs, reason = "each is the option of docs/spec/camera-image.md 17 spelled in one word")]
pub enum Name {
    AllConsole,
    AllFile,
    Antialias,
    AntialiasDepth,
    AntialiasGamma,
    AntialiasThreshold,
    AppendFile,
    BitsPerColor,
    Bounding,
    BoundingMethod,
    BoundingThreshold,
    BspBaseAccessCost,
    BspChildAccessCost,
    BspISectCost,
    BspMaxDepth,
    BspMissChance,
    BufferOutput,
    BufferSize,
    Clock,
    ClocklessAnimation,
    Compression,
    ContinueTrace,
    CreateHistogram,
    CreateIni,
    CyclicAnimation,
    DebugConsole,
    DebugFile,
    Declare,
    Display,
    DisplayGamma,
    Dither,
    DitherMethod,
    DrawVistas,
    EndColumn,
    EndRow,
    FatalConsole,
    FatalErrorCommand,
    FatalErrorReturn,
    FatalFile,
    FieldRender,
    FileGamma,
    FinalClock,
    FinalFrame,
    FrameStep,
    GrayscaleOutput,
    Height,
    HighReproducibility,
    HistogramGridSize,
    HistogramName,
    HistogramType,
    IncludeHeader,
    IncludeIni,
    InitialClock,
    InitialFrame,
    InputFileName,
    Jitter,
    JitterAmount,
    LibraryPath,
    LightBuffer,
    MaxImageBufferMemory,
    OddField,
    OutputAlpha,
    OutputFileName,
    OutputFileType,
    OutputToFile,
    Palette,
    PauseWhenDone,
    PostFrameCommand,
    PostFrameReturn,
    PostSceneCommand,
    PostSceneReturn,
    PreFrameCommand,
    PreFrameReturn,
    PreSceneCommand,
    PreSceneReturn,
    PreviewEndSize,
    PreviewStartSize,
    Quality,
    RadiosityFileName,
    RadiosityFromFile,
    RadiosityToFile,
    RadiosityVainPretrace,
    RealTimeRaytracing,
    RemoveBounds,
    RenderBlockSize,
    RenderBlockStep,
    RenderConsole,
    RenderFile,
    RenderPattern,
    SamplingMethod,
    SplitUnions,
    StartColumn,
    StartRow,
    StatisticConsole,
    StatisticFile,
    SubsetEndFrame,
    SubsetStartFrame,
    TestAbort,
    TestAbortCount,
    UserAbortCommand,
    UserAbortReturn,
    Verbose,
    Version,
    VideoMode,
    VistaBuffer,
    WarningConsole,
    WarningFile,
    WarningLevel,
    Width,
    WorkThreads,
}

/// What an option's value looks like.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// On or off.
    Bool,
    /// A whole number.
    Int,
    /// A number in single precision.
    Float,
    /// A file name or path.
    Path,
    /// Text that is kept as it is.
    Text,
    /// The first letter chooses a file format.
    Format,
    /// A way to dither.
    Dither,
    /// `sRGB` or a number.
    Gamma,
    /// A path added to those searched.
    LibraryPath,
    /// `name=value` for the scene.
    Declare,
    /// An INI file to read now.
    Ini,
    /// A program with its parameters; only INI files may name one.
    Command,
    /// What earlier versions knew: INI files may still hold it, to no effect.
    Obsolete,
}

impl Name {
    /// Finds an option by what a user writes, in any case.
    pub fn find(word: &str) -> Option<Self> {
        let word = if word.eq_ignore_ascii_case("Bits_Per_Colour") { "Bits_Per_Color" } else { word };
        TABLE.iter().find(|(_, name, _)| name.eq_ignore_ascii_case(word)).map(|row| row.0)
    }

    /// The option's name in INI files.
    pub fn as_str(self) -> &'static str {
        TABLE[self as usize].1
    }

    /// What its value looks like.
    pub fn kind(self) -> Kind {
        TABLE[self as usize].2
    }

    /// Every option.
    pub fn all() -> impl Iterator<Item = Self> {
        TABLE.iter().map(|row| row.0)
    }

    /// The options of a kind.
    pub fn of_kind(kind: Kind) -> impl Iterator<Item = Self> {
        Self::all().filter(move |name| name.kind() == kind)
    }

    /// The known name nearest to a misspelt one.
    pub fn nearest(word: &str) -> Option<&'static str> {
        let word = word.to_ascii_lowercase();
        TABLE
            .iter()
            .map(|(_, name, _)| (strsim::damerau_levenshtein(&word, &name.to_ascii_lowercase()), *name))
            .min()
            .filter(|(distance, name)| *distance <= name.len() / 3)
            .map(|(_, name)| name)
    }
}

use Kind::{Bool, Float, Format, Int, Path, Text};

/// Every option once, in the order of [`Name`].
const TABLE: &[(Name, &str, Kind)] = &[
    (Name::AllConsole, "All_Console", Bool),
    (Name::AllFile, "All_File", Path),
    (Name::Antialias, "Antialias", Bool),
    (Name::AntialiasDepth, "Antialias_Depth", Int),
    (Name::AntialiasGamma, "Antialias_Gamma", Float),
    (Name::AntialiasThreshold, "Antialias_Threshold", Float),
    (Name::AppendFile, "Append_File", Bool),
    (Name::BitsPerColor, "Bits_Per_Color", Int),
    (Name::Bounding, "Bounding", Bool),
    (Name::BoundingMethod, "Bounding_Method", Int),
    (Name::BoundingThreshold, "Bounding_Threshold", Int),
    (Name::BspBaseAccessCost, "BSP_BaseAccessCost", Float),
    (Name::BspChildAccessCost, "BSP_ChildAccessCost", Float),
    (Name::BspISectCost, "BSP_ISectCost", Float),
    (Name::BspMaxDepth, "BSP_MaxDepth", Int),
    (Name::BspMissChance, "BSP_MissChance", Float),
    (Name::BufferOutput, "Buffer_Output", Kind::Obsolete),
    (Name::BufferSize, "Buffer_Size", Kind::Obsolete),
    (Name::Clock, "Clock", Float),
    (Name::ClocklessAnimation, "Clockless_Animation", Bool),
    (Name::Compression, "Compression", Int),
    (Name::ContinueTrace, "Continue_Trace", Bool),
    (Name::CreateHistogram, "Create_Histogram", Kind::Obsolete),
    (Name::CreateIni, "Create_Ini", Path),
    (Name::CyclicAnimation, "Cyclic_Animation", Bool),
    (Name::DebugConsole, "Debug_Console", Bool),
    (Name::DebugFile, "Debug_File", Path),
    (Name::Declare, "Declare", Kind::Declare),
    (Name::Display, "Display", Bool),
    (Name::DisplayGamma, "Display_Gamma", Kind::Gamma),
    (Name::Dither, "Dither", Bool),
    (Name::DitherMethod, "Dither_Method", Kind::Dither),
    (Name::DrawVistas, "Draw_Vistas", Bool),
    (Name::EndColumn, "End_Column", Float),
    (Name::EndRow, "End_Row", Float),
    (Name::FatalConsole, "Fatal_Console", Bool),
    (Name::FatalErrorCommand, "Fatal_Error_Command", Kind::Command),
    (Name::FatalErrorReturn, "Fatal_Error_Return", Text),
    (Name::FatalFile, "Fatal_File", Path),
    (Name::FieldRender, "Field_Render", Bool),
    (Name::FileGamma, "File_Gamma", Kind::Gamma),
    (Name::FinalClock, "Final_Clock", Float),
    (Name::FinalFrame, "Final_Frame", Int),
    (Name::FrameStep, "Frame_Step", Int),
    (Name::GrayscaleOutput, "Grayscale_Output", Bool),
    (Name::Height, "Height", Int),
    (Name::HighReproducibility, "High_Reproducibility", Bool),
    (Name::HistogramGridSize, "Histogram_Grid_Size", Kind::Obsolete),
    (Name::HistogramName, "Histogram_Name", Kind::Obsolete),
    (Name::HistogramType, "Histogram_Type", Kind::Obsolete),
    (Name::IncludeHeader, "Include_Header", Path),
    (Name::IncludeIni, "Include_Ini", Kind::Ini),
    (Name::InitialClock, "Initial_Clock", Float),
    (Name::InitialFrame, "Initial_Frame", Int),
    (Name::InputFileName, "Input_File_Name", Path),
    (Name::Jitter, "Jitter", Bool),
    (Name::JitterAmount, "Jitter_Amount", Float),
    (Name::LibraryPath, "Library_Path", Kind::LibraryPath),
    (Name::LightBuffer, "Light_Buffer", Bool),
    (Name::MaxImageBufferMemory, "Max_Image_Buffer_Memory", Int),
    (Name::OddField, "Odd_Field", Bool),
    (Name::OutputAlpha, "Output_Alpha", Bool),
    (Name::OutputFileName, "Output_File_Name", Path),
    (Name::OutputFileType, "Output_File_Type", Format),
    (Name::OutputToFile, "Output_To_File", Bool),
    (Name::Palette, "Palette", Text),
    (Name::PauseWhenDone, "Pause_When_Done", Bool),
    (Name::PostFrameCommand, "Post_Frame_Command", Kind::Command),
    (Name::PostFrameReturn, "Post_Frame_Return", Text),
    (Name::PostSceneCommand, "Post_Scene_Command", Kind::Command),
    (Name::PostSceneReturn, "Post_Scene_Return", Text),
    (Name::PreFrameCommand, "Pre_Frame_Command", Kind::Command),
    (Name::PreFrameReturn, "Pre_Frame_Return", Text),
    (Name::PreSceneCommand, "Pre_Scene_Command", Kind::Command),
    (Name::PreSceneReturn, "Pre_Scene_Return", Text),
    (Name::PreviewEndSize, "Preview_End_Size", Int),
    (Name::PreviewStartSize, "Preview_Start_Size", Int),
    (Name::Quality, "Quality", Int),
    (Name::RadiosityFileName, "Radiosity_File_Name", Path),
    (Name::RadiosityFromFile, "Radiosity_From_File", Bool),
    (Name::RadiosityToFile, "Radiosity_To_File", Bool),
    (Name::RadiosityVainPretrace, "Radiosity_Vain_Pretrace", Bool),
    (Name::RealTimeRaytracing, "Real_Time_Raytracing", Bool),
    (Name::RemoveBounds, "Remove_Bounds", Bool),
    (Name::RenderBlockSize, "Render_Block_Size", Int),
    (Name::RenderBlockStep, "Render_Block_Step", Int),
    (Name::RenderConsole, "Render_Console", Bool),
    (Name::RenderFile, "Render_File", Path),
    (Name::RenderPattern, "Render_Pattern", Int),
    (Name::SamplingMethod, "Sampling_Method", Int),
    (Name::SplitUnions, "Split_Unions", Bool),
    (Name::StartColumn, "Start_Column", Float),
    (Name::StartRow, "Start_Row", Float),
    (Name::StatisticConsole, "Statistic_Console", Bool),
    (Name::StatisticFile, "Statistic_File", Path),
    (Name::SubsetEndFrame, "Subset_End_Frame", Float),
    (Name::SubsetStartFrame, "Subset_Start_Frame", Float),
    (Name::TestAbort, "Test_Abort", Bool),
    (Name::TestAbortCount, "Test_Abort_Count", Int),
    (Name::UserAbortCommand, "User_Abort_Command", Kind::Command),
    (Name::UserAbortReturn, "User_Abort_Return", Text),
    (Name::Verbose, "Verbose", Bool),
    (Name::Version, "Version", Float),
    (Name::VideoMode, "Video_Mode", Text),
    (Name::VistaBuffer, "Vista_Buffer", Bool),
    (Name::WarningConsole, "Warning_Console", Bool),
    (Name::WarningFile, "Warning_File", Path),
    (Name::WarningLevel, "Warning_Level", Int),
    (Name::Width, "Width", Int),
    (Name::WorkThreads, "Work_Threads", Int),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_follows_the_enum() {
        for (index, (name, text, _)) in TABLE.iter().enumerate() {
            assert_eq!(*name as usize, index, "{text}");
        }
    }

    #[test]
    fn names_are_found_in_any_case() {
        assert_eq!(Name::find("output_file_NAME"), Some(Name::OutputFileName));
        assert_eq!(Name::find("bits_per_colour"), Some(Name::BitsPerColor));
        assert_eq!(Name::find("colour"), None);
    }

    #[test]
    fn a_misspelt_name_has_a_neighbour() {
        assert_eq!(Name::nearest("Heigth"), Some("Height"));
        assert_eq!(Name::nearest("Completely_Different_Words"), None);
    }
}
