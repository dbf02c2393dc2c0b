// SPDX-License-Identifier: Apache-2.0

#include "texgen/studio/access.h"

#include "core/files/shown_text.h"
#include "texgen/json/json_writer.h"

#include <fmt/format.h>
#include <sys/random.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace foam::texgen {

namespace {

constexpr std::array kHosts = {"127.0.0.1", "localhost", "[::1]"};

// A page may load only files of the studio itself, and pictures that its scripts have made.
constexpr const char* kContentPolicy =
    "default-src 'self'; img-src 'self' blob: data:; frame-ancestors 'none'; base-uri 'none'; "
    "form-action 'none'";

/// Returns 128 random bits as 32 hexadecimal digits.
std::string random_word() {
    std::array<unsigned char, 16> bytes{};
    if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
        throw std::runtime_error("the system gives no random numbers");
    }
    return fmt::format("{:02x}", fmt::join(bytes, ""));
}

/// Compares two texts in a time that does not depend on where they differ, so that nobody can find
/// a secret by measuring the time of guesses.
bool is_same_secret(std::string_view a, std::string_view b) {
    unsigned difference = a.size() == b.size() ? 0U : 1U;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        difference |= static_cast<unsigned>(a[i]) ^ static_cast<unsigned>(b[i]);
    }
    return difference == 0;
}

/// Returns the name of the cookie. It contains the port, because all ports of a machine share their
/// cookies.
std::string cookie_name(int port) {
    return fmt::format("foamtex_{}", port);
}

/// Returns the value of a cookie; empty if the header field does not contain it.
std::string_view cookie_value(std::string_view cookies, std::string_view name) {
    while (!cookies.empty()) {
        const std::size_t end = std::min(cookies.find(';'), cookies.size());
        std::string_view cookie = cookies.substr(0, end);
        cookies.remove_prefix(std::min(end + 1, cookies.size()));
        cookie.remove_prefix(std::min(cookie.find_first_not_of(' '), cookie.size()));
        if (cookie.size() > name.size() && cookie.starts_with(name) && cookie[name.size()] == '=') {
            return cookie.substr(name.size() + 1);
        }
    }
    return {};
}

bool is_own_host(std::string_view host, int port) {
    return std::ranges::any_of(
        kHosts, [&](const char* name) { return host == fmt::format("{}:{}", name, port); });
}

}  // namespace

Access::Access(int port) : port_(port), token_(random_word()), secret_(random_word()) {}

std::optional<HttpResponse> Access::rejection(const HttpRequest& request) const {
    if (!is_own_host(request.host, port_)) {
        return error_response(HttpStatus::Forbidden,
                              "the request names another host; open the address that 'foamtex "
                              "studio' has printed");
    }
    if (request.method == "GET") {
        // The header field Sec-Fetch-Site is "none" if the user has typed or opened the address. If
        // a browser does not send this field, the cookie still protects the studio.
        const bool own = request.fetch_site.empty() || request.fetch_site == "none" ||
                         request.fetch_site == "same-origin" || request.target == "/";
        return own ? std::nullopt
                   : std::optional(error_response(HttpStatus::Forbidden,
                                                  "another site may not use the studio"));
    }
    if (request.method != "POST") {
        return error_response(HttpStatus::MethodNotAllowed, "the method must be GET or POST");
    }
    if (request.origin != "http://" + request.host || request.fetch_site != "same-origin") {
        return error_response(HttpStatus::Forbidden, "another site may not use the studio");
    }
    if (request.content_type != "application/json") {
        return error_response(HttpStatus::BadRequest, "Content-Type must be application/json");
    }
    return std::nullopt;
}

bool Access::has_cookie(const HttpRequest& request) const {
    return is_same_secret(cookie_value(request.cookie, cookie_name(port_)), secret_);
}

std::optional<HttpResponse> Access::exchange(std::string_view token) {
    const std::scoped_lock lock(mutex_);
    if (token_is_used_ || !is_same_secret(token, token_)) {
        return std::nullopt;
    }
    token_is_used_ = true;
    return HttpResponse{
        .status = HttpStatus::NoContent,
        .headers = {{"Set-Cookie",
                     fmt::format("{}={}; HttpOnly; SameSite=Strict; Path=/; Max-Age=604800",
                                 cookie_name(port_),
                                 secret_)}}};
}

HttpResponse with_safety_fields(HttpResponse response) {
    const std::array<std::pair<const char*, const char*>, 5> fields{{
        {"Content-Security-Policy", kContentPolicy},
        {"X-Content-Type-Options", "nosniff"},
        {"Referrer-Policy", "no-referrer"},
        {"Cache-Control", "no-store"},
        {"Cross-Origin-Resource-Policy", "same-origin"},
    }};
    for (const auto& [name, value] : fields) {
        response.headers.emplace_back(name, value);
    }
    return response;
}

HttpResponse error_response(HttpStatus status, const std::string& message, const std::string& key) {
    const Json error = {{"message", shown_text(message)},
                        {"key", key.empty() ? Json(nullptr) : Json(key)}};
    return {.status = status, .body = json_text(Json{{"error", error}})};
}

}  // namespace foam::texgen
