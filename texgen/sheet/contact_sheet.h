// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/image.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace foam::texgen {

/// A reduced picture of a frame, with three channels.
struct Thumbnail {
    Image<std::uint8_t> pixels;
    std::vector<std::string> labels;  // lines below the picture
};

/// The layout of a contact sheet.
struct ContactSheetLayout {
    int columns = 0;        // 0: the sheet becomes about 1.5 times as wide as high
    int magnification = 1;  // of labels, see label.h
};

/// Returns an image of thumbnails on a gray background, from left to right and from top to bottom,
/// each with its labels below it. Labels that are wider than the thumbnail are cut. Precondition:
/// all thumbnails have the same size and the same number of labels. Throws std::invalid_argument if
/// there are no thumbnails.
Image<std::uint8_t> contact_sheet(std::span<const Thumbnail> thumbnails,
                                  const ContactSheetLayout& layout = {});

}  // namespace foam::texgen
