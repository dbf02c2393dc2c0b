// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/image_options.h"

#include "texgen/keys/value_kinds.h"
#include "texgen/maps/all_maps.h"

#include <fmt/core.h>

#include <functional>

namespace foam::texgen {

namespace {

constexpr int kMaxExtent = 16384;  // pixels; a square image of 8-bit RGBA then takes 1 GB

// The kind of values of image.size: [width, height] in pixels.
struct Sizes {
    Integers extent{1, kMaxExtent};

    std::string allowed() const {
        return fmt::format("[width, height], each {}", extent.allowed());
    }
    std::string schema() const { return list_schema(extent.schema(), 2, 2); }
    bool read(const Value& value, ImageOptions& member) const {
        const auto* list = std::get_if<Value::List>(&value.data);
        ImageOptions sized = member;
        const bool allowed = list != nullptr && list->size() == 2 &&
                             extent.read(list->front(), sized.width) &&
                             extent.read(list->back(), sized.height);
        member = allowed ? sized : member;
        return allowed;
    }
    Value write(const ImageOptions& member) const {
        return {Value::List{extent.write(member.width), extent.write(member.height)}};
    }
};

}  // namespace

Keys<ImageOptions> image_keys() {
    return {make_key<ImageOptions>("size", Sizes{}, "image size in pixels", std::identity())
                .in("pixels"),
            key("maps",
                WordLists{map_names()},
                "maps that are drawn for every frame",
                &ImageOptions::maps)};
}

}  // namespace foam::texgen
