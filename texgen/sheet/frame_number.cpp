// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/frame_number.h"

#include <algorithm>
#include <array>
#include <string>

namespace foam::texgen {

namespace {

constexpr int kAdvance = kDigitWidth + 1;  // pixels from one digit to the next

// The rows of a digit from top to bottom. The highest of the five bits of a row is its leftmost
// pixel.
using Digit = std::array<unsigned, kDigitHeight>;

constexpr std::array<Digit, 10> kDigits = {{
    {0b01110, 0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b01110},
    {0b00100, 0b01100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110},
    {0b01110, 0b10001, 0b00001, 0b00110, 0b01000, 0b10000, 0b11111},
    {0b01110, 0b10001, 0b00001, 0b00110, 0b00001, 0b10001, 0b01110},
    {0b00010, 0b00110, 0b01010, 0b10010, 0b11111, 0b00010, 0b00010},
    {0b11111, 0b10000, 0b11110, 0b00001, 0b00001, 0b10001, 0b01110},
    {0b00110, 0b01000, 0b10000, 0b11110, 0b10001, 0b10001, 0b01110},
    {0b11111, 0b00001, 0b00010, 0b00100, 0b00100, 0b01000, 0b01000},
    {0b01110, 0b10001, 0b10001, 0b01110, 0b10001, 0b10001, 0b01110},
    {0b01110, 0b10001, 0b10001, 0b01111, 0b00001, 0b00010, 0b01100},
}};

void draw_digit(
    ImageView<std::uint8_t> image, int left, int bottom, const Digit& digit, std::uint8_t gray) {
    for (int y = 0; y < kDigitHeight; ++y) {
        const unsigned row = digit.at(static_cast<std::size_t>(kDigitHeight - 1 - y));
        for (int x = 0; x < kDigitWidth; ++x) {
            if ((row >> (kDigitWidth - 1 - x) & 1U) != 0) {
                std::ranges::fill(image.pixel(left + x, bottom + y), gray);
            }
        }
    }
}

}  // namespace

int number_width(int number) {
    return static_cast<int>(std::to_string(number).size()) * kAdvance - 1;
}

void draw_number(
    ImageView<std::uint8_t> image, int left, int bottom, int number, std::uint8_t gray) {
    for (const char digit : std::to_string(number)) {
        draw_digit(image, left, bottom, kDigits.at(static_cast<std::size_t>(digit - '0')), gray);
        left += kAdvance;
    }
}

}  // namespace foam::texgen
