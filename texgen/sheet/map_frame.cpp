// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/map_frame.h"

#include "core/files/file_io.h"
#include "texgen/image/format.h"

#include <fmt/core.h>

#include <string>
#include <vector>

namespace foam::texgen {

namespace {

// Keeps only the channel groups in one layer of an EXR. Removes the prefix of the layer, such as
// "albedo.", from the names of their channels.
void keep_layer(std::vector<ChannelGroup>& groups, const std::string& prefix) {
    std::erase_if(groups, [&](const ChannelGroup& group) {
        return !group.names.front().starts_with(prefix);
    });
    for (ChannelGroup& group : groups) {
        for (std::string& name : group.names) {
            name.erase(0, prefix.size());
        }
    }
}

}  // namespace

Picture read_map_frame(const MapFile& file, std::string_view map) {
    Picture picture = read_picture(file.path);
    if (file.layered) {
        keep_layer(picture.groups, std::string(map) + '.');
    }
    if (picture.groups.empty()) {
        throw InputError(fmt::format("'{}' has no layer '{}'", file.path.string(), map));
    }
    return picture;
}

}  // namespace foam::texgen
