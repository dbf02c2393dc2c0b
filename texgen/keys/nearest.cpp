// SPDX-License-Identifier: Apache-2.0

#include "texgen/keys/nearest.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

// Returns the Levenshtein distance of two texts: the smallest number of inserted, removed and
// replaced bytes that changes one text into the other. Computes it by dynamic programming and
// stores only one row of the table of distances.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
        }
    }
    return row.back();
}

// Returns the candidate that begins with a word. Returns an empty view if none or several do, or if
// the word has fewer than three bytes.
std::string_view completed(std::string_view word, std::span<const std::string_view> candidates) {
    constexpr std::size_t kMinBytes = 3;
    const auto begins = [&](std::string_view candidate) { return candidate.starts_with(word); };
    const bool is_unique =
        word.size() >= kMinBytes && std::ranges::count_if(candidates, begins) == 1;
    return is_unique ? *std::ranges::find_if(candidates, begins) : std::string_view();
}

}  // namespace

std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates) {
    std::string_view best;
    const std::size_t limit = std::min(std::max<std::size_t>(2, word.size() / 3), word.size() / 2);
    std::size_t best_distance = limit + 1;
    for (const std::string_view candidate : candidates) {
        const std::size_t distance = edit_distance(word, candidate);
        if (distance < best_distance) {
            best = candidate;
            best_distance = distance;
        }
    }
    return best.empty() ? completed(word, candidates) : best;
}

std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates) {
    const std::string_view meant = nearest(word, candidates);
    return meant.empty() ? "" : fmt::format("; did you mean '{}'?", meant);
}

}  // namespace foam::texgen
