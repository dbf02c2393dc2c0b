// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {

/// A request to the studio, with the header fields that the studio uses. If a header field is
/// missing or occurs more than once, the member for it is empty.
struct HttpRequest {
    std::string method;  // "GET", "POST", ...
    std::string target;  // the path, such as "/api/picture"
    std::string host = {};
    std::string origin = {};
    std::string fetch_site = {};  // Sec-Fetch-Site
    std::string content_type = {};
    std::string cookie = {};
    std::string body = {};
};

/// The status codes of HTTP that the studio uses.
enum class HttpStatus : unsigned {
    Ok = 200,
    NoContent = 204,
    BadRequest = 400,
    Forbidden = 403,
    NotFound = 404,
    MethodNotAllowed = 405,
    Conflict = 409,
    PayloadTooLarge = 413,
    Unprocessable = 422,
    HeaderTooLarge = 431,
    InternalError = 500,
};

/// The response to a request.
struct HttpResponse {
    HttpStatus status = HttpStatus::Ok;
    std::string content_type = "application/json";
    std::vector<std::pair<std::string, std::string>> headers = {};  // further fields of the header
    std::string body = {};
};

/// Answers requests. May be called from several threads at once. Must not throw.
using HttpHandler = std::function<HttpResponse(const HttpRequest&)>;

}  // namespace foam::texgen
