// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/normal_angles.h"

#include "core/geometry/elementary.h"

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace foam::texgen {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;  // degrees per radian
constexpr double kOpposite = 180.0;  // degrees; also the result if a normal has no direction

using Normal = std::array<double, 3>;

/// Reads the normals of a picture row by row.
class NormalRows {
  public:
    explicit NormalRows(const Picture& picture)
        : channels_(channels_of(picture)),
          row_(static_cast<std::size_t>(picture.width())),
          normals_(row_.size()) {}

    /// Returns the normals of a row, which are valid until the next call.
    const std::vector<Normal>& read(int y) {
        for (std::size_t k = 0; k < channels_.size(); ++k) {
            read_numbers(channels_[k], y, row_);
            const bool codes = channels_[k].group->has_codes();
            for (std::size_t x = 0; x < row_.size(); ++x) {
                normals_[x].at(k) = codes ? 2.0 * row_[x] - 1.0 : row_[x];
            }
        }
        return normals_;
    }

  private:
    std::vector<PictureChannel> channels_;
    std::vector<double> row_;
    std::vector<Normal> normals_;
};

double dot(const Normal& a, const Normal& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double length_of_cross(const Normal& a, const Normal& b) {
    const Normal cross = {
        a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    return std::sqrt(dot(cross, cross));
}

bool has_direction(const Normal& normal) {
    const double square = dot(normal, normal);
    return square > 0.0 && std::isfinite(square);
}

/// Returns true if the samples are equal; NaN is equal to NaN.
bool are_equal(const Normal& a, const Normal& b) {
    for (std::size_t k = 0; k < a.size(); ++k) {
        if (a.at(k) != b.at(k) && !(std::isnan(a.at(k)) && std::isnan(b.at(k)))) {
            return false;
        }
    }
    return true;
}

// The arc tangent is accurate for small angles, for which the arc cosine of the dot product is not.
double angle_between(const Normal& a, const Normal& b) {
    if (are_equal(a, b)) {
        return 0.0;
    }
    return has_direction(a) && has_direction(b)
               ? kDegrees * ieee::atan2(length_of_cross(a, b), dot(a, b))
               : kOpposite;
}

}  // namespace

bool can_hold_normals(const Picture& picture) {
    return channels_of(picture).size() == Normal().size();
}

std::vector<double> normal_angles(const Picture& a, const Picture& b) {
    assert(can_hold_normals(a) && can_hold_normals(b));
    NormalRows left(a);
    NormalRows right(b);
    std::vector<double> angles;
    angles.reserve(static_cast<std::size_t>(a.width()) * static_cast<std::size_t>(a.height()));
    for (int y = 0; y < a.height(); ++y) {
        const std::vector<Normal>& left_row = left.read(y);
        const std::vector<Normal>& right_row = right.read(y);
        for (std::size_t x = 0; x < left_row.size(); ++x) {
            angles.push_back(angle_between(left_row[x], right_row[x]));
        }
    }
    return angles;
}

}  // namespace foam::texgen
