// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/all_maps.h"
#include "texgen/maps/frame_layers.h"
#include "texgen/vector/vector_options.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// What a vector file contains: a part of a frame, and the options.
struct VectorSource {
    FrameLayers& layers;
    const MapOptions& maps;
    const VectorOptions& options;
    std::vector<std::string> map_names;  // image.maps of the preset
    std::string title;
    std::string description;
};

/// A format of files that describe a frame by its arcs instead of pixels. README.md explains how to
/// add a format.
struct VectorFormat {
    std::string_view name;    // name in messages, such as "SVG"
    std::string_view suffix;  // end of its file names, such as ".svg"

    /// Returns the names of the files of a frame. A name takes the place of {map} in file names.
    std::vector<std::string> (*parts)(const VectorOptions& options,
                                      const std::vector<std::string>& map_names) = nullptr;
    /// Returns the content of the file with one of these names. Throws std::invalid_argument if the
    /// frame or the options cannot be drawn, and std::bad_alloc if the machine has too little
    /// memory.
    std::string (*encode)(const VectorSource& source, std::string_view part) = nullptr;
};

/// Returns all formats.
std::span<const VectorFormat> vector_formats();

/// Returns the format whose suffix is the end of the file name, or nullptr if there is none.
const VectorFormat* find_vector_format(std::string_view file_name);

/// Returns the suffixes of all formats, such as ".svg or .dxf", for messages.
std::string vector_suffixes();

/// Returns true if a part of a frame is a table, whose lengths are in foam units, or consists of
/// tables.
bool is_table_part(std::string_view part);

/// Returns a description of a part of a frame in a few words, such as "films as arcs".
std::string_view meaning_of_part(std::string_view part);

}  // namespace foam::texgen
