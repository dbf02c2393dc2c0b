// SPDX-License-Identifier: Apache-2.0

#include "texgen/studio/routes.h"

#include "core/files/file_io.h"
#include "texgen/animation/progress_text.h"
#include "texgen/bake/frame_range.h"
#include "texgen/json/json_value.h"
#include "texgen/maps/all_maps.h"
#include "texgen/studio/access.h"
#include "texgen/studio/baked_sets.h"
#include "texgen/studio/downloads.h"
#include "texgen/studio/settings.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <span>
#include <string_view>

namespace foam::texgen {

namespace {

std::string page_of(const JsonValue& request) {
    constexpr std::size_t kMaxPageBytes = 64;
    const std::string& page = request["page"].text();
    if (page.empty() || page.size() > kMaxPageBytes) {
        request["page"].reject(fmt::format("a text of 1 to {} bytes", kMaxPageBytes));
    }
    return page;
}

int frame_of(const JsonValue& request) {
    return static_cast<int>(request["frame"].integer(1, kLastFrame));
}

BakedImage baked_image(const JsonValue& request) {
    return {
        request["folder"].text(), request["set"].text(), request["map"].text(), frame_of(request)};
}

PictureRequest picture_request(const JsonValue& request) {
    constexpr std::array<std::string_view, 3> kQualities = {"draft", "full", "exact"};
    constexpr std::array<std::string_view, 2> kSamples = {"rgba", "float"};
    PictureRequest picture{
        .page = page_of(request), .frame = frame_of(request), .map = request["map"].text()};
    // The member `width` is the largest width and height (REQUESTS.md).
    if (const auto width = request.find("width")) {
        picture.side = static_cast<int>(width->integer(1, kMaxPictureSide));
    }
    if (const auto quality = request.find("quality")) {
        const std::string& word = quality->word(kQualities);
        picture.quality =
            static_cast<PictureQuality>(std::ranges::find(kQualities, word) - kQualities.begin());
    }
    if (const auto samples = request.find("samples")) {
        picture.floats = samples->word(kSamples) == "float";
    }
    return picture;
}

Json simulation_json(const SimulationState& state) {
    constexpr std::array<std::string_view, 3> kStatus = {"running", "complete", "failed"};
    return {{"status", kStatus.at(static_cast<std::size_t>(state.status))},
            {"done", state.done},
            {"total", state.total},
            {"phase", name_of(state.progress.phase)},
            {"text", phase_text(state.progress)},
            {"cycle", state.progress.cycle},
            {"closing_error", number_or_null(state.closing_error)},
            {"message", state.message}};
}

/// Answers POST requests, with one function per path (kRoutes).
class StudioRoutes {
  public:
    StudioRoutes(const StudioFolder& folder, FrameStore& store, Painter& painter, BakeJobs& bakes)
        : folder_(folder), store_(store), painter_(painter), bakes_(bakes) {}

    HttpResponse settings(const JsonValue& request) const {
        return json_response(describe_settings(read_settings(request), folder_));
    }

    HttpResponse picture(const JsonValue& request) const {
        return painter_.draw(live_preset(request), picture_request(request));
    }

    HttpResponse simulation(const JsonValue& request) const {
        return json_response(simulation_json(store_.want(live_preset(request), page_of(request))));
    }

    HttpResponse pick(const JsonValue& request) const {
        constexpr int kMax = std::numeric_limits<int>::max();
        const auto x = static_cast<int>(request["x"].integer(0, kMax));
        const auto y = static_cast<int>(request["y"].integer(0, kMax));
        return json_response(painter_.pick(live_preset(request), picture_request(request), x, y));
    }

    HttpResponse bake(const JsonValue& request) const {
        return json_response(bakes_.start(read_bake_request(request)));
    }

    HttpResponse bake_status(const JsonValue& request) const {
        return json_response(bakes_.status(request["bake"].count()));
    }

    HttpResponse bake_cancel(const JsonValue& request) const {
        bakes_.cancel(request["bake"].count());
        return {.status = HttpStatus::NoContent};
    }

    HttpResponse save(const JsonValue& request) const {
        const PageSettings settings = read_settings(request);
        const std::string& file = request["file"].text();
        const std::filesystem::path path = folder_.below(file);
        const std::string name = path.filename().string();
        if (!file.ends_with(".toml") || !is_plain_name(name)) {
            throw PathRejected(fmt::format("'{}': must be the name of a .toml file", file));
        }
        if (!request["overwrite"].flag() && is_existing(path)) {
            return error_response(HttpStatus::Conflict, fmt::format("'{}' exists", file));
        }
        const std::string toml = preset_file(settings, load_settings(settings, folder_));
        make_folders(path.parent_path());
        write_file(path, std::as_bytes(std::span(toml)));
        return json_response({{"file", file}});
    }

    HttpResponse download(const JsonValue& request) const {
        constexpr std::array<std::string_view, 4> kKinds = {"frame", "drawing", "loop", "preset"};
        const std::string& kind = request["kind"].word(kKinds);
        const PageSettings settings = read_settings(request);
        if (kind == "preset") {
            return preset_download(settings, load_settings(settings, folder_));
        }
        const Preset preset = live_preset(request);
        const std::string map(find_map(request["map"].text()).name);
        if (kind == "frame") {
            return frame_download(preset, map, frame_of(request), store_);
        }
        if (kind == "drawing") {
            return drawing_download(preset, map, frame_of(request), store_);
        }
        std::optional<int> side;
        if (const auto width = request.find("width")) {
            side = static_cast<int>(width->integer(1, kMaxPictureSide));
        }
        return loop_download(preset, map, side, store_);
    }

    HttpResponse bakes(const JsonValue&) const {
        return json_response(describe_baked_sets(folder_));
    }

    HttpResponse baked(const JsonValue& request) const {
        const auto side = static_cast<int>(request["width"].integer(1, kMaxPictureSide));
        return baked_picture(folder_, baked_image(request), side);
    }

    HttpResponse baked_pick(const JsonValue& request) const {
        return json_response(pick_baked(
            folder_, baked_image(request), request["x"].number(), request["y"].number()));
    }

    // The handler has already noted that there was a request; that keeps the server running.
    HttpResponse alive(const JsonValue& request) const {
        page_of(request);
        return {.status = HttpStatus::NoContent};
    }

  private:
    Preset live_preset(const JsonValue& request) const {
        return load_live_preset(read_settings(request), folder_);
    }

    const StudioFolder& folder_;
    FrameStore& store_;
    Painter& painter_;
    BakeJobs& bakes_;
};

struct StudioRoute {
    std::string_view target;
    HttpResponse (StudioRoutes::*answer)(const JsonValue& request) const;
};

constexpr std::array kRoutes{StudioRoute{"/api/settings", &StudioRoutes::settings},
                             StudioRoute{"/api/picture", &StudioRoutes::picture},
                             StudioRoute{"/api/simulation", &StudioRoutes::simulation},
                             StudioRoute{"/api/pick", &StudioRoutes::pick},
                             StudioRoute{"/api/bake", &StudioRoutes::bake},
                             StudioRoute{"/api/bake/status", &StudioRoutes::bake_status},
                             StudioRoute{"/api/bake/cancel", &StudioRoutes::bake_cancel},
                             StudioRoute{"/api/save", &StudioRoutes::save},
                             StudioRoute{"/api/download", &StudioRoutes::download},
                             StudioRoute{"/api/bakes", &StudioRoutes::bakes},
                             StudioRoute{"/api/baked", &StudioRoutes::baked},
                             StudioRoute{"/api/baked/pick", &StudioRoutes::baked_pick},
                             StudioRoute{"/api/alive", &StudioRoutes::alive}};

}  // namespace

HttpResponse json_response(const Json& json) {
    return {.body = json_text(json)};
}

HttpResponse answer_json(const std::string& body,
                         const std::function<HttpResponse(const JsonValue& request)>& answer) {
    if (body.empty()) {
        return error_response(HttpStatus::BadRequest, "the request must have a JSON object");
    }
    std::optional<JsonDocument> document;
    try {
        document.emplace(body, "the request");
    } catch (const InputError& error) {
        return error_response(HttpStatus::BadRequest, error.what());
    }
    return answer(document->root());
}

std::optional<HttpResponse> answer_post(const std::string& target,
                                        const std::string& body,
                                        const StudioParts& parts) {
    const auto* const route = std::ranges::find(kRoutes, target, &StudioRoute::target);
    if (route == kRoutes.end()) {
        return std::nullopt;
    }
    const StudioRoutes routes(parts.folder, parts.store, parts.painter, parts.bakes);
    return answer_json(body,
                       [&](const JsonValue& request) { return (routes.*route->answer)(request); });
}

}  // namespace foam::texgen
