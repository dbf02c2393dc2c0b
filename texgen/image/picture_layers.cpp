// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/picture_layers.h"

#include <map>
#include <utility>

namespace foam::texgen {

std::vector<PictureLayer> split_into_layers(Picture picture) {
    std::map<std::string, Picture> layers;
    for (ChannelGroup& group : picture.groups) {
        const std::string name(layer_of(group.names.front()));
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
