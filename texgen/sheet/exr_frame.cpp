#include "texgen/sheet/exr_frame.h"

#include <fmt/core.h>

#include <string>
#include <utility>

namespace foam::texgen {

namespace {

/// The channels of a map, by the names that they have where it is alone.
std::vector<ExrPlane> planes_of(std::vector<ExrPlane> planes, std::string_view map) {
    const std::string layer = std::string(map) + '.';
    std::erase_if(planes, [&](const ExrPlane& plane) { return !plane.name.starts_with(layer); });
    for (ExrPlane& plane : planes) {
        plane.name.erase(0, layer.size());
    }
    return planes;
}

}  // namespace

ExrImage read_exr_frame(const MapFile& file, std::string_view map) {
    ExrImage image = read_exr(file.path);
    if (file.layered) {
        image.channels = planes_of(std::move(image.channels), map);
    }
    if (image.channels.empty()) {
        throw InputError(fmt::format("'{}' has no layer {}", file.path.string(), map));
    }
    return image;
}

}  // namespace foam::texgen
