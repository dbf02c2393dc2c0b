// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/studio/http_message.h"

#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace foam::texgen {

/// Decides which requests a studio answers: only those of its own page, in a browser that was
/// opened with the address that the program printed. A page of another site could otherwise send
/// requests to the loopback interface.
///
/// - The header `Host` must be the address of the studio. A name that an attacker has made point to
///   this machine (DNS rebinding) is rejected.
/// - Requests below /api/ need a cookie with a secret of 128 random bits. The page gets the cookie
///   from /api/session in exchange for a token, which is also 128 random bits and can be used once.
///   Because of `SameSite=Strict`, a browser does not send the cookie with requests that pages of
///   other sites make.
/// - The headers of a POST request must say that its content is JSON (`Content-Type`). They must
///   also say that the request comes from the page of the studio (`Origin` and `Sec-Fetch-Site`).
///   Pages of other sites cannot forge the last two headers.
/// - A GET request that comes from another site, as `Sec-Fetch-Site` says, is rejected, except for
///   the page "/".
class Access {
  public:
    /// Draws the token and the secret from the random numbers of the system. `port` is the port of
    /// the server. Throws std::runtime_error if the system gives no random numbers.
    explicit Access(int port);

    /// Returns the token for the address of the page.
    const std::string& token() const { return token_; }

    /// Returns an error response if a request does not come from the page of the studio, or has a
    /// wrong method or content type. Returns nullopt if the request may be answered. Does not check
    /// the cookie.
    std::optional<HttpResponse> rejection(const HttpRequest& request) const;

    /// Returns true if a request has the cookie.
    bool has_cookie(const HttpRequest& request) const;

    /// Exchanges the token for the cookie: returns a response that sets the cookie. Returns nullopt
    /// if the token is wrong or was used before.
    std::optional<HttpResponse> exchange(std::string_view token);

  private:
    int port_;
    std::string token_;
    std::string secret_;
    std::mutex mutex_;
    bool token_is_used_ = false;  // protected by the mutex
};

/// Returns a response with the header fields that every response of the studio has. They restrict
/// what a page may load and which pages may embed or read the response, and forbid caching.
HttpResponse with_safety_fields(HttpResponse response);

/// Returns an error response. Its message is the given one as the program prints it: one line of
/// limited length (shown_text). `key` names the preset key that the error concerns, or is empty.
HttpResponse error_response(HttpStatus status,
                            const std::string& message,
                            const std::string& key = {});

}  // namespace foam::texgen
