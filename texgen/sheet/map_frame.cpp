// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/map_frame.h"

#include "core/files/file_io.h"
#include "texgen/image/format.h"

#include <fmt/core.h>

#include <string>
#include <vector>

namespace foam::texgen {

namespace {

// Keeps only the channel groups in one layer of an EXR. Removes the name of the layer and the dot,
// such as "albedo.", from the names of their channels.
void keep_layer(std::vector<ChannelGroup>& groups, std::string_view layer) {
    std::erase_if(
        groups, [&](const ChannelGroup& group) { return layer_of(group.names.front()) != layer; });
    for (ChannelGroup& group : groups) {
        for (std::string& name : group.names) {
            name.erase(0, layer.size() + 1);
        }
    }
}

}  // namespace

Picture read_map_frame(const MapFile& file, std::string_view map) {
    Picture picture = read_picture(file.path);
    if (file.layered) {
        keep_layer(picture.groups, map);
    }
    if (picture.groups.empty()) {
        throw InputError(fmt::format("'{}' has no layer '{}'", file.path.string(), map));
    }
    return picture;
}

}  // namespace foam::texgen
