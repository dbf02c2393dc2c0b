// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/simulate_frames.h"
#include "texgen/preset/assignment.h"
#include "texgen/variations/drawn_variations.h"
#include "texgen/variations/variation.h"
#include "texgen/variations/variation_files.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace foam::texgen {

/// The variations of a preset, for one sheet.
struct VariationSet {
    std::string preset;                   // a name or a path
    std::vector<Assignment> assignments;  // the same for all variations, such as those of --set
    std::vector<Variation> variations;
    int columns = 0;  // columns of the sheet (ContactSheetLayout)
};

/// A variation after its picture has been drawn.
struct WrittenVariation {
    std::size_t number = 0;  // from 1
    Variation variation;
    RunOutcome outcome;
    std::optional<std::filesystem::path> preset;  // its preset file; nullopt if the run failed
};

/// The files of a set of variations.
struct WrittenVariations {
    std::filesystem::path sheet;
    std::vector<WrittenVariation> variations;

    /// Returns the paths of the sheet and of the preset files.
    std::vector<std::filesystem::path> files() const;
};

/// Writes the sheet of the pictures, and a preset file for each variation whose run is complete.
/// Then removes the files in `earlier` that were not replaced; a file that cannot be removed stays.
/// Precondition: there are as many pictures as variations, and each variation has an assignment.
/// Throws OutputError if a file cannot be written.
WrittenVariations write_variations(const VariationSet& set,
                                   const std::vector<DrawnVariation>& drawn,
                                   const VariationFiles& names,
                                   const std::vector<std::filesystem::path>& earlier);

}  // namespace foam::texgen
