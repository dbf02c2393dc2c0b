// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/maps/relief_section.h"
#include "texgen/maps/table_lookup.h"

#include <limits>
#include <vector>

namespace foam::texgen {

/// A lookup in the table of a VisibleSky. The VisibleSky must outlive the lookup.
struct SkyLookup {
    const double* table;
    int last;  // index of the last entry

    /// Returns the entry of the table for a distance from the film, in the unit of length of the
    /// ReliefSection. The entry is the visible fraction of the sky, raised to the exponent of the
    /// VisibleSky. The distance may be infinite; then the result is 1. Finite distances above
    /// ReliefSection::reach count as this reach. Loops that call this function can be vectorized.
    /// Precondition: the distance is not negative.
    double at(double distance) const {
        const double fraction = looked_up(table, last, distance * kSteps);
        return distance < std::numeric_limits<double>::infinity() ? fraction : 1.0;
    }

    static constexpr int kSteps = 128;  // entries per unit of length of the ReliefSection
};

/// A table of the visible fraction of a uniform sky, raised to a power. The entries are for points
/// of a cross-section of the relief (ReliefSection), in the order of their distance from the film.
class VisibleSky {
  public:
    /// The heights of the section are multiplied by `strength`. The visible fraction is raised to
    /// the power `exponent`.
    VisibleSky(const ReliefSection& section, double strength, double exponent);

    SkyLookup lookup() const { return {table_.data(), static_cast<int>(table_.size()) - 1}; }

  private:
    std::vector<double> table_;
};

}  // namespace foam::texgen
