// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/color.h"
#include "texgen/image/image.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace foam::texgen {

/// A text below a picture. It takes several lines if it is wider than the picture.
struct ThumbnailLabel {
    std::string text;
    std::vector<Srgb8> colors{};  // drawn as squares after the text
};

/// A reduced picture of a frame, with three channels.
struct Thumbnail {
    Image<std::uint8_t> pixels;
    std::vector<ThumbnailLabel> labels;
};

/// The layout of a contact sheet.
struct ContactSheetLayout {
    int columns = 0;        // 0: the sheet becomes about 1.5 times as wide as high
    int magnification = 1;  // magnification of the labels (label.h)
};

/// Returns an image of thumbnails on a gray background, from left to right and from top to bottom,
/// each with its labels below it. A label that is wider than the thumbnail takes several lines, and
/// its colors become narrow enough to fit on one line. If a label has more colors than the
/// thumbnail has columns of pixels, only one color per column is drawn. These colors are evenly
/// spaced in the list. Precondition: all thumbnails have the same size. Throws
/// std::invalid_argument if there are no thumbnails.
Image<std::uint8_t> contact_sheet(std::span<const Thumbnail> thumbnails,
                                  const ContactSheetLayout& layout = {});

}  // namespace foam::texgen
