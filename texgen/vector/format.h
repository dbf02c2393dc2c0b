// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/vector/mesh_estimate.h"
#include "texgen/vector/vector_source.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// A format of files that describe a frame by its arcs or as a
/// mesh instead of pixels. README.md explains how to
/// add a format.
struct VectorFormat {
    std::string_view name;    // name in messages, such as "SVG"
    std::string_view suffix;  // end of its file names, such as ".svg"
    std::string_view unit;    // unit of lengths

    /// Returns the names of the files of a frame. A name takes the place of {map} in file names.
    std::vector<std::string> (*parts)(const VectorSettings& settings) = nullptr;
    /// Throws std::invalid_argument if no frame can be written with these settings.
    void (*check)(const VectorSettings& settings) = nullptr;
    /// Returns the content of the file with one of these names. Throws std::invalid_argument if the
    /// frame or the options cannot be drawn, and std::bad_alloc if the machine has too little
    /// memory.
    std::string (*encode)(const VectorSource& source, std::string_view part) = nullptr;
    /// Estimates a mesh (estimated_mesh); nullptr for drawings and tables.
    MeshEstimate (*estimate)(const VectorSettings& settings, int bubbles) = nullptr;
};

/// Returns all formats.
std::span<const VectorFormat> vector_formats();

/// Returns the format whose suffix is the end of the file name, or nullptr if there is none.
const VectorFormat* find_vector_format(std::string_view file_name);

/// Returns the suffixes of all formats, such as ".svg or .dxf", for messages.
std::string vector_suffixes();

/// Returns a description of a part of a frame in a few words, such as "films as arcs".
std::string_view meaning_of_part(std::string_view part);

}  // namespace foam::texgen
