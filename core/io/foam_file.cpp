// SPDX-License-Identifier: Apache-2.0

#include "core/io/foam_file.h"

#include "core/files/content_text.h"
#include "core/files/file_io.h"
#include "core/io/evolver_file.h"
#include "core/io/foam_json.h"

#include <fmt/core.h>

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace foam {

namespace {

enum class FoamFormat {
    Json,
    Evolver,
};

FoamFormat format_of(const std::filesystem::path& path) {
    const std::string extension = path.extension().string();
    if (extension == ".json") {
        return FoamFormat::Json;
    }
    if (extension != ".fe" && extension != ".dmp") {
        throw std::invalid_argument(fmt::format(
            "'{}': the name of a foam file must end in .fe, .dmp or .json", path.string()));
    }
    return FoamFormat::Evolver;
}

// Returns the foam as text in the format that the extension selects. Throws OutputError if the
// format cannot store the foam.
std::string text_for(const std::filesystem::path& path, const Foam& foam) {
    try {
        return format_of(path) == FoamFormat::Json ? write_foam_json(foam) : write_evolver(foam);
    } catch (const std::range_error& error) {
        throw OutputError(fmt::format("cannot write '{}': {}", path.string(), error.what()));
    }
}

}  // namespace

void check_foam_name(const std::filesystem::path& path) {
    format_of(path);
}

LoadedFoam load_foam(const std::filesystem::path& path) {
    const FoamFormat format = format_of(path);
    const Bytes bytes = read_file(path, kFoamInput);
    if (format == FoamFormat::Json) {
        return {read_foam_json(as_text(bytes), path.string()), {}};
    }
    EvolverFoam read = read_evolver(as_text(bytes), path.string());
    return {std::move(read.foam), std::move(read.notes)};
}

void save_foam(const std::filesystem::path& path, const Foam& foam) {
    const std::string text = text_for(path, foam);
    write_file(path, std::as_bytes(std::span(text)));
}

}  // namespace foam
