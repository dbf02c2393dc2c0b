#pragma once

#include "texgen/manifest/manifest.h"
#include "texgen/sheet/layout.h"
#include "texgen/sheet/map_sequence.h"

#include <span>
#include <string>

namespace foam::texgen {

/// A sheet that has been written.
struct SheetImage {
    std::string file;  // its name, beside the JSON
    MapSequence sequence;
};

/// What a program that plays these sheets has to know, as JSON; README.md has the members.
std::string flipbook_json(const BakedSet& set,
                          std::span<const int> frames,
                          const SheetLayout& layout,
                          std::span<const SheetImage> images);

}  // namespace foam::texgen
