#include "texgen/sheet/sheet_files.h"

#include "texgen/image/file_io.h"

#include <fmt/core.h>

namespace foam::texgen {

void write_sheet(const MapSequence& sequence,
                 const SheetLayout& layout,
                 const std::filesystem::path& path) {
    check_layout(layout);
    make_folders(path.parent_path());
    if (path.extension() == ".exr") {
        write_exr_sheet(sequence, layout, path);
    } else {
        write_png_sheet(sequence, layout, path);
    }
}

std::string text_of(const SheetLayout& layout) {
    return fmt::format("{} x {} frames of {} x {}, gutter {}",
                       layout.columns,
                       layout.rows(),
                       layout.frame_width,
                       layout.frame_height,
                       layout.gutter);
}

void check_extents(const MapFile& file, const SheetLayout& layout, int width, int height) {
    if (width != layout.frame_width || height != layout.frame_height) {
        throw InputError(fmt::format("'{}' is {} x {}, not {} x {}",
                                     file.path.string(),
                                     width,
                                     height,
                                     layout.frame_width,
                                     layout.frame_height));
    }
}

}  // namespace foam::texgen
