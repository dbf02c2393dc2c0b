// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"

#include <string>
#include <vector>

namespace foam::texgen {

/// The size of the images, and the maps that are drawn for every frame.
struct ImageOptions {
    int width = 1024;   // pixels
    int height = 1024;  // pixels
    std::vector<std::string> maps = {"albedo"};
};

Keys<ImageOptions> image_keys();

}  // namespace foam::texgen
