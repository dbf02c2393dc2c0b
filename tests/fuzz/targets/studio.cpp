// SPDX-License-Identifier: Apache-2.0

#include "core/files/scratch_folder.h"
#include "core/files/shown_text.h"
#include "tests/fuzz/fuzz_target.h"
#include "texgen/studio/handler.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <string_view>

// The input is a request: one line each for the method, the target, Host, Origin, Sec-Fetch-Site,
// Content-Type and Cookie, and then the body. The cookie "valid" stands for the cookie of the
// studio.

namespace foam::fuzz {

namespace {

using texgen::HttpRequest;
using texgen::HttpResponse;
using texgen::HttpStatus;

// A studio in a folder with a preset that is quick to simulate and draw.
class FuzzedStudio {
  public:
    FuzzedStudio() : studio_(scratch_.path(), kPort) {
        std::ofstream(scratch_.path() / "tiny.toml")
            << "[foam]\nbubbles = 12\n[frames]\ncount = 2\n[image]\nsize = [16, 16]\n";
        HttpRequest login{.method = "POST",
                          .target = "/api/session",
                          .host = "localhost:1",
                          .origin = "http://localhost:1",
                          .fetch_site = "same-origin",
                          .content_type = "application/json",
                          .body = R"({"token":")" + studio_.token() + R"("})"};
        for (const auto& [name, value] : studio_.handle(login).headers) {
            if (name == "Set-Cookie") {
                cookie_ = value.substr(0, value.find(';'));
            }
        }
    }

    HttpResponse handle(HttpRequest request) {
        if (request.cookie == "valid") {
            request.cookie = cookie_;
        }
        return studio_.handle(request);
    }

  private:
    static constexpr int kPort = 1;
    ScratchFolder scratch_;
    texgen::Studio studio_;
    std::string cookie_;
};

std::string take_line(std::string_view& input) {
    const std::size_t end = std::min(input.find('\n'), input.size());
    const std::string line(input.substr(0, end));
    input.remove_prefix(std::min(end + 1, input.size()));
    return line;
}

// Returns true if a request simulates or draws the foam of its settings. With arbitrary settings
// this may take long, and rightly so.
bool is_slow(const HttpRequest& request) {
    constexpr std::array kSlow = {
        "/api/picture", "/api/simulation", "/api/pick", "/api/bake", "/api/download"};
    if (std::find(kSlow.begin(), kSlow.end(), request.target) == kSlow.end()) {
        return false;
    }
    const nlohmann::json body = nlohmann::json::parse(request.body, nullptr, false);
    return !(body.is_object() && body.contains("settings") &&
             body["settings"] ==
                 nlohmann::json{{"preset", "tiny.toml"}, {"set", nlohmann::json::array()}});
}

void check_json(const std::string& body) {
    const nlohmann::json json = nlohmann::json::parse(body, nullptr, false);
    require(!json.is_discarded(), "the answer is JSON");
    if (json.is_object() && json.contains("error")) {
        const std::string message = json["error"]["message"];
        require(is_harmless(message), "an error is described in one line");
    }
}

}  // namespace

void fuzz_studio(std::string_view input) {
    static FuzzedStudio studio;
    HttpRequest request{.method = take_line(input),
                        .target = take_line(input),
                        .host = take_line(input),
                        .origin = take_line(input),
                        .fetch_site = take_line(input),
                        .content_type = take_line(input),
                        .cookie = take_line(input)};
    request.body = input;
    if (is_slow(request)) {
        return;
    }
    const HttpResponse response = studio.handle(request);
    require(response.status != HttpStatus::InternalError, "no request makes the studio fail");
    const bool is_data = response.status == HttpStatus::Ok && request.target.starts_with("/api/");
    require(!is_data || (request.cookie == "valid" && request.host == "localhost:1"),
            "only the page of the studio gets data");
    if (response.content_type == "application/json" && response.status != HttpStatus::NoContent) {
        check_json(response.body);
    }
}

}  // namespace foam::fuzz
