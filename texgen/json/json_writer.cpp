// SPDX-License-Identifier: Apache-2.0

#include "texgen/json/json_writer.h"

#include <cmath>

namespace foam::texgen {

Json number_or_null(const std::optional<double>& number) {
    return number && std::isfinite(*number) ? Json(*number) : Json(nullptr);
}

Json path_list(std::span<const std::filesystem::path> paths) {
    Json list = Json::array();
    for (const std::filesystem::path& path : paths) {
        list.push_back(path.string());
    }
    return list;
}

std::string json_text(const Json& value) {
    constexpr int kOneLine = -1;
    return value.dump(kOneLine, ' ', false, Json::error_handler_t::replace);
}

std::string indented(const Json& value) {
    constexpr int kIndent = 2;
    return value.dump(kIndent, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace foam::texgen
