// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/picture_layers.h"

#include <cstddef>
#include <map>
#include <utility>

namespace foam::texgen {

std::vector<PictureLayer> split_into_layers(Picture picture) {
    std::map<std::string, Picture> layers;
    for (ChannelGroup& group : picture.groups) {
        const std::string& channel = group.names.front();
        const std::size_t dot = channel.rfind('.');
        const std::string name = dot == std::string::npos ? "" : channel.substr(0, dot);
        Picture& layer = layers.try_emplace(name, Picture{{}, picture.metadata}).first->second;
        layer.groups.push_back(std::move(group));
    }
    std::vector<PictureLayer> list;
    list.reserve(layers.size());
    for (auto& [name, layer] : layers) {
        list.push_back({name, std::move(layer)});
    }
    return list;
}

}  // namespace foam::texgen
