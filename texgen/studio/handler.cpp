// SPDX-License-Identifier: Apache-2.0

#include "texgen/studio/handler.h"

#include "core/parallel/parallel_for.h"
#include "texgen/animation/progress_text.h"
#include "texgen/bake/bake.h"
#include "texgen/bake/reduced_image.h"
#include "texgen/image/apng.h"
#include "texgen/image/file_io.h"
#include "texgen/image/memory.h"
#include "texgen/image/scratch_folder.h"
#include "texgen/json/json_value.h"
#include "texgen/manifest/manifest_file.h"
#include "texgen/maps/all_maps.h"
#include "texgen/material/profile.h"
#include "texgen/material/shipped_profiles.h"
#include "texgen/preset/drawn_images.h"
#include "texgen/preset/load_preset.h"
#include "texgen/preset/preset_schema.h"
#include "texgen/preset/shipped_presets.h"
#include "texgen/sheet/display_frame.h"
#include "texgen/sheet/map_sequence.h"
#include "texgen/studio/page_files.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <new>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

// The memory for the states of foams, in bytes.
constexpr std::size_t kStoreBytes = 1UL << 30;
constexpr int kLargestFrame = 1'000'000;

// What a page may load: only files of the studio itself, and pictures that its scripts have made.
constexpr const char* kContentPolicy =
    "default-src 'self'; img-src 'self' blob: data:; frame-ancestors 'none'; base-uri 'none'; "
    "form-action 'none'";

HttpResponse json_response(const Json& json) {
    return {.body = json_text(json)};
}

std::string_view content_type_of(std::string_view name) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kTypes{{
        {".html", "text/html; charset=utf-8"},
        {".css", "text/css; charset=utf-8"},
        {".js", "text/javascript; charset=utf-8"},
        {".svg", "image/svg+xml"},
    }};
    const auto found =
        std::ranges::find_if(kTypes, [&](const auto& type) { return name.ends_with(type.first); });
    return found == kTypes.end() ? "application/octet-stream" : found->second;
}

HttpResponse page_response(std::string_view target) {
    const std::string_view name = target == "/" ? "index.html" : target.substr(1);
    const auto found = std::ranges::find(page_files(), name, &PageFile::name);
    if (found == page_files().end()) {
        return error_response(HttpStatus::NotFound, "the studio has no such page");
    }
    return {.content_type = std::string(content_type_of(name)),
            .body = std::string(found->content)};
}

Json preset_summary(const ShippedPreset& shipped) {
    const Preset preset = load_preset(std::string(shipped.name));
    Json maps = Json::array();
    for (const DrawnImage& image : drawn_images(preset)) {
        maps.push_back(image.name());
    }
    return {{"name", shipped.name},
            {"description", preset.description},
            {"size", {preset.image.width, preset.image.height}},
            {"frames", preset.frames.count},
            {"maps", maps}};
}

Json map_summary(const Map& map) {
    constexpr std::array<std::string_view, 3> kKinds = {"color", "number", "id"};
    return {{"name", map.name},
            {"meaning", map.meaning},
            {"unit", map.unit},
            {"channels", map.channels},
            {"kind", kKinds.at(static_cast<std::size_t>(map.kind))}};
}

Json describe_program(const StudioFolder& folder) {
    Json presets = Json::array();
    for (const ShippedPreset& shipped : shipped_presets()) {
        presets.push_back(preset_summary(shipped));
    }
    Json maps = Json::array();
    for (const Map& map : all_maps()) {
        maps.push_back(map_summary(map));
    }
    Json profiles = Json::array();
    for (const ShippedProfile& shipped : shipped_profiles()) {
        const Profile profile = load_profile(std::string(shipped.name));
        profiles.push_back({{"name", profile.name}, {"description", profile.description}});
    }
    return {{"version", FOAMTEX_VERSION},
            {"folder", folder.path().string()},
            {"threads", thread_count(0)},
            {"presets", presets},
            {"files", folder.preset_files()},
            {"maps", maps},
            {"profiles", profiles},
            {"schema", Json::parse(preset_schema())},
            {"largest_width", kLargestPicture},
            {"largest_foam", kLargestLiveFoam}};
}

std::string page_of(const JsonValue& request) {
    constexpr std::size_t kLongestPage = 64;
    const std::string& page = request["page"].text();
    if (page.empty() || page.size() > kLongestPage) {
        request["page"].reject(fmt::format("a text of 1 to {} bytes", kLongestPage));
    }
    return page;
}

int frame_of(const JsonValue& request) {
    return static_cast<int>(request["frame"].integer(1, kLargestFrame));
}

PictureRequest picture_request(const JsonValue& request) {
    constexpr std::array<std::string_view, 3> kQualities = {"draft", "full", "exact"};
    constexpr std::array<std::string_view, 2> kSamples = {"rgba", "float"};
    PictureRequest picture{
        .page = page_of(request), .frame = frame_of(request), .map = request["map"].text()};
    if (const auto width = request.find("width")) {
        picture.side = static_cast<int>(width->integer(1, kLargestPicture));
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

HttpResponse attachment(std::span<const std::byte> content,
                        const std::string& name,
                        const std::string& type) {
    return {.content_type = type,
            .headers = {{"Content-Disposition", fmt::format("attachment; filename=\"{}\"", name)}},
            .body = std::string(reinterpret_cast<const char*>(content.data()), content.size())};
}

/// Bakes frames of one map as PNGs into a scratch folder and returns the contents of their files,
/// in the order of the frames.
std::vector<Bytes> baked_frames(Preset preset,
                                const std::string& map,
                                const std::vector<int>& frames,
                                const FrameSource& source) {
    const ScratchFolder scratch;
    preset.image.maps = {map};
    preset.output.pack.clear();
    preset.output.names.clear();
    preset.output.pattern = (scratch.path() / "frame.######.png").string();
    const BakeSummary summary = bake(preset, {.frames = frames, .source = source});
    std::vector<Bytes> files;
    for (const std::filesystem::path& path : summary.files) {
        files.push_back(read_file(path));
    }
    return files;
}

/// The work of the routes that start with "/api/", apart from /api/session.
class Routes {
  public:
    Routes(const StudioFolder& folder, FrameStore& store, Painter& painter, BakeJobs& bakes)
        : folder_(folder), store_(store), painter_(painter), bakes_(bakes) {}

    HttpResponse settings(const JsonValue& request) {
        return json_response(describe_settings(read_settings(request), folder_));
    }

    HttpResponse picture(const JsonValue& request) {
        return painter_.draw(live(request), picture_request(request));
    }

    HttpResponse simulation(const JsonValue& request) {
        return json_response(simulation_json(store_.want(live(request), page_of(request))));
    }

    HttpResponse pick(const JsonValue& request) {
        constexpr int kLargest = std::numeric_limits<int>::max();
        const auto x = static_cast<int>(request["x"].integer(0, kLargest));
        const auto y = static_cast<int>(request["y"].integer(0, kLargest));
        return json_response(painter_.pick(live(request), picture_request(request), x, y));
    }

    HttpResponse bake(const JsonValue& request) {
        return json_response(bakes_.start(read_bake_request(request)));
    }

    HttpResponse bake_status(const JsonValue& request) {
        return json_response(bakes_.status(request["bake"].count()));
    }

    HttpResponse bake_cancel(const JsonValue& request) {
        bakes_.cancel(request["bake"].count());
        return {.status = HttpStatus::NoContent};
    }

    HttpResponse save(const JsonValue& request) {
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

    HttpResponse download(const JsonValue& request) {
        constexpr std::array<std::string_view, 3> kKinds = {"frame", "loop", "preset"};
        const std::string& kind = request["kind"].word(kKinds);
        const PageSettings settings = read_settings(request);
        if (kind == "preset") {
            const PagePreset loaded = load_settings(settings, folder_);
            const std::string toml = preset_file(settings, loaded);
            return attachment(
                std::as_bytes(std::span(toml)), loaded.preset.name + ".toml", "application/toml");
        }
        Preset preset = live(request);
        const std::string map(find_map(request["map"].text()).name);
        return kind == "frame" ? frame_file(preset, map, frame_of(request))
                               : loop_file(std::move(preset), map, request);
    }

    HttpResponse bakes(const JsonValue&) {
        Json all = Json::array();
        for (const std::filesystem::path& manifest : folder_.bakes()) {
            add_sets(manifest, all);
        }
        return json_response({{"bakes", all}});
    }

    HttpResponse baked(const JsonValue& request) {
        const std::filesystem::path folder = folder_.below(request["folder"].text());
        const std::string& preset = request["preset"].text();
        const std::string& map = request["map"].text();
        const int frame = frame_of(request);
        const Manifest manifest = read_manifest(folder);
        const auto set = std::ranges::find(manifest.sets, preset, &BakedSet::preset);
        if (set == manifest.sets.end()) {
            throw std::invalid_argument(fmt::format("no images of '{}' were baked", preset));
        }
        const MapSequence sequence = map_sequence(*set, folder, map, std::span(&frame, 1));
        folder_.below(sequence.files.front().path.lexically_relative(folder_.path()).string());
        const auto side = static_cast<int>(request["width"].integer(1, kLargestPicture));
        return baked_picture(sequence, side);
    }

    HttpResponse alive(const JsonValue& request) {
        page_of(request);
        return {.status = HttpStatus::NoContent};
    }

  private:
    Preset live(const JsonValue& request) { return load_live(read_settings(request), folder_); }

    HttpResponse frame_file(const Preset& preset, const std::string& map, int frame) {
        const std::vector<Bytes> files = baked_frames(preset, map, {frame}, store_.source(preset));
        return attachment(
            files.at(0), fmt::format("{}_{}.{:04}.png", preset.name, map, frame), "image/png");
    }

    HttpResponse loop_file(Preset preset, const std::string& map, const JsonValue& request) {
        const FrameSource source = store_.source(preset);
        if (const auto width = request.find("width")) {
            const ReducedImage reduced =
                reduced_image(preset, static_cast<int>(width->integer(1, kLargestPicture)));
            preset.image.width = reduced.width;
            preset.image.height = reduced.height;
            preset.maps = reduced.options;
        }
        std::vector<int> frames(static_cast<std::size_t>(preset.frames.count));
        std::iota(frames.begin(), frames.end(), 1);
        ApngMuxer muxer(preset.frames.count, {preset.output.frames_per_second, 1});
        for (const Bytes& file : baked_frames(preset, map, frames, source)) {
            muxer.add(file);
        }
        return attachment(
            muxer.finish(), fmt::format("{}_{}_loop.png", preset.name, map), "image/png");
    }

    void add_sets(const std::filesystem::path& manifest, Json& all) const {
        const std::string folder = manifest.parent_path().string();
        try {
            for (const BakedSet& set : read_manifest(folder_.below(folder)).sets) {
                Json maps = Json::array();
                for (const ManifestMap& map : set.maps) {
                    maps.push_back(
                        {{"name", map.name}, {"kind", map.samples ? map.samples->kind : ""}});
                }
                all.push_back({{"folder", folder},
                               {"preset", set.preset},
                               {"size", {set.width, set.height}},
                               {"frames", set.frames()},
                               {"frames_per_second", set.frames_per_second},
                               {"maps", maps}});
            }
        } catch (const InputError&) {
            // A folder with a damaged manifest is not offered.
        }
    }

    static HttpResponse baked_picture(const MapSequence& sequence, int side) {
        DisplayFrame frame = read_display_frame(sequence.files.front(), sequence.map);
        const int width = frame.pixels.width();
        const int height = frame.pixels.height();
        const double scale = std::min(1.0, static_cast<double>(side) / std::max(width, height));
        if (scale < 1.0) {
            frame = reduced(frame,
                            std::max(1, static_cast<int>(width * scale)),
                            std::max(1, static_cast<int>(height * scale)));
        }
        const Image<std::uint8_t> codes = codes_of(frame);
        const Json header = {{"width", codes.width()},
                             {"height", codes.height()},
                             {"channels", 4},
                             {"frame", sequence.files.front().frame},
                             {"exact", scale == 1.0},
                             {"low", nullptr},
                             {"high", nullptr}};
        return {.content_type = "application/octet-stream",
                .headers = {{"X-Foamtex-Picture", json_text(header)}},
                .body = rgba_from_top(codes)};
    }

    const StudioFolder& folder_;
    FrameStore& store_;
    Painter& painter_;
    BakeJobs& bakes_;
};

struct Route {
    std::string_view target;
    HttpResponse (Routes::*answer)(const JsonValue& request);
};

constexpr std::array kRoutes{Route{"/api/settings", &Routes::settings},
                             Route{"/api/picture", &Routes::picture},
                             Route{"/api/simulation", &Routes::simulation},
                             Route{"/api/pick", &Routes::pick},
                             Route{"/api/bake", &Routes::bake},
                             Route{"/api/bake/status", &Routes::bake_status},
                             Route{"/api/bake/cancel", &Routes::bake_cancel},
                             Route{"/api/save", &Routes::save},
                             Route{"/api/download", &Routes::download},
                             Route{"/api/bakes", &Routes::bakes},
                             Route{"/api/baked", &Routes::baked},
                             Route{"/api/alive", &Routes::alive}};

/// Calls `answer` and returns its response, or the response to the exception that it throws.
HttpResponse guarded(const std::function<HttpResponse()>& answer) {
    try {
        return answer();
    } catch (const SettingsRejected& error) {
        return error_response(HttpStatus::Unprocessable, error.what(), error.key());
    } catch (const FrameReplaced& error) {
        return error_response(HttpStatus::Conflict, error.what());
    } catch (const BakeRuns& error) {
        return error_response(HttpStatus::Conflict, error.what());
    } catch (const OutOfMemory& error) {
        return error_response(HttpStatus::InternalError, error.what());
    } catch (const std::bad_alloc&) {
        return error_response(HttpStatus::InternalError, "out of memory");
    } catch (const std::exception& error) {
        return error_response(HttpStatus::Unprocessable, error.what());
    }
}

}  // namespace

Studio::Studio(const std::filesystem::path& folder, int port)
    : access_(port),
      folder_(folder),
      store_(kStoreBytes),
      painter_(store_),
      bakes_(folder_, store_),
      last_request_(std::chrono::steady_clock::now()) {}

HttpResponse Studio::handle(const HttpRequest& request) {
    HttpResponse response = guarded([&] { return answer(request); });
    const std::array<std::pair<const char*, const char*>, 5> fields{{
        {"Content-Security-Policy", kContentPolicy},
        {"X-Content-Type-Options", "nosniff"},
        {"Referrer-Policy", "no-referrer"},
        {"Cache-Control", "no-store"},
        {"Cross-Origin-Resource-Policy", "same-origin"},
    }};
    response.headers.insert(response.headers.end(), fields.begin(), fields.end());
    return response;
}

HttpResponse Studio::answer(const HttpRequest& request) {
    if (std::optional<HttpResponse> rejection = access_.rejection(request)) {
        return *std::move(rejection);
    }
    if (request.target.starts_with("/api/")) {
        return answer_api(request);
    }
    if (request.method != "GET") {
        return error_response(HttpStatus::MethodNotAllowed, "pages are read with GET");
    }
    return page_response(request.target);
}

HttpResponse Studio::answer_api(const HttpRequest& request) {
    const bool is_post = request.method == "POST";
    if (!access_.has_cookie(request)) {
        const HttpResponse refused = error_response(
            HttpStatus::Forbidden, "open the address that 'foamtex studio' has printed");
        if (!is_post || request.target != "/api/session") {
            return refused;
        }
        const JsonDocument body(request.body, "the request");
        return access_.exchange(body.root()["token"].text()).value_or(refused);
    }
    last_request_ = std::chrono::steady_clock::now();
    if (request.target == "/api/session") {
        return {.status = is_post ? HttpStatus::NoContent : HttpStatus::MethodNotAllowed};
    }
    if (request.target == "/api/program") {
        return is_post ? error_response(HttpStatus::MethodNotAllowed, "use GET")
                       : json_response(describe_program(folder_));
    }
    const auto route = std::ranges::find(kRoutes, request.target, &Route::target);
    if (route == kRoutes.end()) {
        return error_response(HttpStatus::NotFound, "the studio has no such request");
    }
    if (!is_post) {
        return error_response(HttpStatus::MethodNotAllowed, "use POST");
    }
    std::optional<JsonDocument> body;
    try {
        body.emplace(request.body, "the request");
    } catch (const InputError& error) {
        return error_response(HttpStatus::BadRequest, error.what());
    }
    Routes routes(folder_, store_, painter_, bakes_);
    return (routes.*route->answer)(body->root());
}

std::chrono::steady_clock::duration Studio::idle_time() {
    const auto now = std::chrono::steady_clock::now();
    if (bakes_.is_running()) {
        last_request_ = now;
    }
    return now - last_request_.load();
}

void Studio::stop() {
    store_.stop();
    bakes_.stop();
}

}  // namespace foam::texgen
