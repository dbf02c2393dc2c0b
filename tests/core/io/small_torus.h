// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/io/format_error.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <string_view>

namespace foam::test {

/// A data file of one bubble on a torus of 3 x 2. The bubble is its own neighbor on all six sides.
/// There are two junctions and three straight films. The comments in the text are line numbers.
inline constexpr const char* kSmallTorus = R"(STRING
SPACE_DIMENSION 2
TORUS_FILLED
PERIODS
3 0
0 2
vertices  // 7
1 0 0.5
2 1 1
edges     // 10
1 1 2 * *
2 2 1 + +
3 2 1 + *
faces     // 14
1 1 2 -3 -1 -2 3
bodies    // 16
1 1 volume 6
)";

/// The same foam as the text of a JSON state (foam_json.h).
inline constexpr const char* kSmallState = R"({
"format": "foamtex-foam",
"version": 1,
"torus": [3.0, 2.0],
"film_tension": 1.0,
"time": 0.0,
"next_identity": 1,
"junctions": [
[0.0, 0.5, 3],
[1.0, 1.0, 4]
],
"films": [
[0, 1, 0, 0, 2, 3, 0, 0, 1],
[1, 0, 0, 0, 5, 4, 1, 1, 1],
[1, 0, 0, 0, 0, 1, 1, 0, 1]
],
"bubbles": [
[0, 0.0, 6.0, 0, 6]
]
}
)";

/// Returns the text with the first occurrence of `old` replaced. The test fails if there is none.
inline std::string edited(std::string text, std::string_view old, std::string_view replacement) {
    const std::size_t at = text.find(old);
    EXPECT_NE(at, std::string::npos) << "no '" << old << "' to replace";
    return at == std::string::npos ? text : text.replace(at, old.size(), replacement);
}

/// Expects the action to throw FormatError with "file:line: message".
inline void expect_format_error(const std::function<void()>& action, const std::string& what) {
    try {
        action();
        ADD_FAILURE() << "no error, but expected: " << what;
    } catch (const FormatError& error) {
        EXPECT_EQ(error.what(), what);
    }
}

}  // namespace foam::test
