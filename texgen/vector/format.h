// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/vector/mesh_estimate.h"
#include "texgen/vector/vector_source.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// A format of files that describe a frame by its arcs or as a mesh instead of pixels. A frame has
/// one or more parts, each of which is one file. README.md explains how to add a format.
struct VectorFormat {
    std::string_view name;    // name in messages, such as "SVG"
    std::string_view suffix;  // end of its file names, such as ".svg"
    std::string_view unit;    // unit of lengths

    /// Returns the names of the parts of a frame. The name of a part takes the place of {map} in
    /// the name of its file.
    std::vector<std::string> (*parts)(const VectorSettings& settings) = nullptr;
    /// Throws std::invalid_argument if no frame can be written with these settings.
    void (*check)(const VectorSettings& settings) = nullptr;
    /// Returns the content of the file of a part. Throws std::invalid_argument if the frame cannot
    /// be drawn with the settings of `source`. Throws std::bad_alloc if the machine has too little
    /// memory. Throws std::runtime_error for other errors of cairo, the library that writes PDFs
    /// (to_pdf).
    std::string (*encode)(const VectorSource& source, std::string_view part) = nullptr;
    /// Estimates the size of a mesh's file and the memory for making it (estimated_mesh). The
    /// pointer is nullptr for formats of drawings and tables.
    MeshEstimate (*estimate)(const VectorSettings& settings, int bubbles) = nullptr;
};

/// Returns all formats.
std::span<const VectorFormat> vector_formats();

/// Returns the format whose suffix is the end of the file name, in letters of either case, or
/// nullptr if there is none.
const VectorFormat* find_vector_format(std::string_view file_name);

/// Returns the suffixes of all formats, such as ".svg or .dxf", for messages.
std::string vector_suffixes();

/// Returns a description of the part with the given name in a few words, such as "a table of all
/// films". Returns an empty text for an unknown name.
std::string_view meaning_of_part(std::string_view part);

}  // namespace foam::texgen
