// SPDX-License-Identifier: Apache-2.0

#include "texgen/studio/handler.h"

#include "texgen/image/memory.h"
#include "texgen/studio/page_files.h"
#include "texgen/studio/program_description.h"
#include "texgen/studio/routes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace foam::texgen {

namespace {

// The memory for the states of foams, in bytes.
constexpr std::size_t kStoreBytes = 1UL << 30;

std::string_view content_type_of(std::string_view name) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kTypes{{
        {".html", "text/html; charset=utf-8"},
        {".css", "text/css; charset=utf-8"},
        {".js", "text/javascript; charset=utf-8"},
        {".svg", "image/svg+xml"},
    }};
    const auto* const found =
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

/// Calls `answer` and returns its response, or the response to the exception that it throws.
HttpResponse guarded(const std::function<HttpResponse()>& answer) {
    try {
        return answer();
    } catch (const SettingsRejected& error) {
        return error_response(HttpStatus::Unprocessable, error.what(), error.key());
    } catch (const SimulationStopped& error) {
        return error_response(HttpStatus::Conflict, error.what());
    } catch (const BakeIsRunning& error) {
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
    return with_safety_fields(guarded([&] { return answer(request); }));
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
        HttpResponse forbidden = error_response(
            HttpStatus::Forbidden, "open the address that 'foamtex studio' has printed");
        if (!is_post || request.target != "/api/session") {
            return forbidden;
        }
        return answer_json(request.body, [&](const JsonValue& body) {
            return access_.exchange(body["token"].text()).value_or(std::move(forbidden));
        });
    }
    last_request_ = std::chrono::steady_clock::now();
    if (request.target == "/api/session") {
        return {.status = is_post ? HttpStatus::NoContent : HttpStatus::MethodNotAllowed};
    }
    if (request.target == "/api/program") {
        return is_post ? error_response(HttpStatus::MethodNotAllowed, "use GET")
                       : json_response(describe_program(folder_));
    }
    if (is_post) {
        std::optional<HttpResponse> response =
            answer_post(request.target, request.body, {folder_, store_, painter_, bakes_});
        if (response) {
            return *std::move(response);
        }
    }
    return error_response(is_post ? HttpStatus::NotFound : HttpStatus::MethodNotAllowed,
                          is_post ? "the studio has no such request" : "use POST");
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
