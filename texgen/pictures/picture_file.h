// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/keys/value.h"
#include "texgen/pictures/source_picture.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace foam::texgen {

/// The value of a key that names a picture: the path of its file, and the picture itself. Reading
/// the key reads the file. A bad file is therefore an error of the preset.
struct PictureFile {
    std::string path{};                              // empty if no picture is named
    std::shared_ptr<const SourcePicture> picture{};  // null if no picture is named
    // pixel_hash of the picture after its colors have been converted to the primaries of sRGB
    std::string hash{};

    bool is_set() const { return picture != nullptr; }
};

/// Returns true if the text is the name of a picture: if it has the suffix of an image format.
bool is_picture_name(std::string_view text);

/// Returns the end of a regular expression (ECMA 262) for the names of pictures, without an anchor.
/// It matches the suffixes of all image formats, in letters of either case. It is escaped for a
/// JSON string.
std::string picture_suffix_pattern();

/// Returns the picture in a file. Colors with other primaries are converted to those of sRGB.
/// Throws the exceptions of read_picture (format.h) and source_picture_of.
PictureFile read_picture_file(const std::string& path);

/// The kind of values (value_kinds.h) that name a picture: paths of image files, and the empty
/// string, which names no picture.
struct PictureFiles {
    std::string allowed() const;
    std::string schema() const;
    bool read(const Value& value, PictureFile& member) const;
    Value write(const PictureFile& member) const { return {member.path}; }
    std::string fault(const Value& value) const;
    std::optional<NamedFile> file(const PictureFile& member) const;
};

}  // namespace foam::texgen
