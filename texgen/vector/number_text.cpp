// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/number_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace foam::texgen {

namespace {

constexpr int kMaxDecimals = 9;
// The largest finite double has 309 digits before the decimal point.
using NumberBuffer = std::array<char, 400>;

std::string fixed_text(double number, int decimals) {
    NumberBuffer buffer;
    const auto [end, error] = std::to_chars(
        buffer.data(), buffer.data() + buffer.size(), number, std::chars_format::fixed, decimals);
    std::string text(buffer.data(), end);
    if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') {
            text.pop_back();
        }
    }
    return text == "-0" ? "0" : text;
}

}  // namespace

std::string length_text(double millimeters) {
    int decimals = kMaxDecimals;
    for (double size = std::abs(millimeters); size >= 1e3 && decimals > 0; size /= 10.0) {
        --decimals;
    }
    return fixed_text(millimeters, decimals);
}

std::string exact_text(double number) {
    NumberBuffer buffer;
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
    return std::string(buffer.data(), end);
}

}  // namespace foam::texgen
