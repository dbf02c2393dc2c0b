// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/outline/disc_index.h"

#include <boost/geometry/core/cs.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

namespace foam::texgen {

namespace {

namespace bg = boost::geometry;

using TreePoint = bg::model::point<double, 2, bg::cs::cartesian>;
using TreeBox = bg::model::box<TreePoint>;
using TreeEntry = std::pair<TreeBox, std::size_t>;

// Returns a box around a disc, with a margin that is larger than the rounding errors.
TreeBox box_around(const Disc& disc) {
    constexpr double kRounding = 1e-12;
    const double reach =
        disc.radius + kRounding * (disc.radius + disc.center.cwiseAbs().maxCoeff());
    return {{disc.center.x() - reach, disc.center.y() - reach},
            {disc.center.x() + reach, disc.center.y() + reach}};
}

}  // namespace

class DiscIndex::Tree {
  public:
    explicit Tree(std::span<const Disc> discs) : entries_(entries_of(discs)) {}

    void find(const Disc& disc, std::vector<std::size_t>& found) const {
        const TreeBox box = box_around(disc);
        for (auto entry = entries_.qbegin(bg::index::intersects(box)); entry != entries_.qend();
             ++entry) {
            found.push_back(entry->second);
        }
        std::ranges::sort(found);
    }

  private:
    static std::vector<TreeEntry> entries_of(std::span<const Disc> discs) {
        std::vector<TreeEntry> entries;
        entries.reserve(discs.size());
        for (std::size_t k = 0; k < discs.size(); ++k) {
            entries.emplace_back(box_around(discs[k]), k);
        }
        return entries;
    }

    // The constructor of the tree gets all entries at once (bulk loading), which gives a faster
    // tree than single insertions.
    bg::index::rtree<TreeEntry, bg::index::quadratic<16>> entries_;
};

DiscIndex::DiscIndex() = default;
DiscIndex::~DiscIndex() = default;

void DiscIndex::build_tree(std::size_t count) {
    tree_ = discs_.empty() ? nullptr : std::make_unique<Tree>(discs_);
    all_.resize(tree_ ? 0 : count);
    std::iota(all_.begin(), all_.end(), std::size_t{0});
}

std::span<const std::size_t> DiscIndex::near(const Disc& disc) {
    if (!tree_) {
        return all_;
    }
    found_.clear();
    tree_->find(disc, found_);
    return found_;
}

}  // namespace foam::texgen
