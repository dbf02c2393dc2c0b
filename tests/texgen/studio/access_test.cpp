// SPDX-License-Identifier: Apache-2.0

#include "texgen/studio/access.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace foam::texgen {
namespace {

constexpr int kPort = 8080;

HttpRequest page_request() {
    return {.method = "GET", .target = "/", .host = "localhost:8080", .fetch_site = "none"};
}

HttpRequest post() {
    return {.method = "POST",
            .target = "/api/settings",
            .host = "localhost:8080",
            .origin = "http://localhost:8080",
            .fetch_site = "same-origin",
            .content_type = "application/json"};
}

HttpStatus status_of(const HttpRequest& request) {
    const Access access(kPort);
    const std::optional<HttpResponse> rejection = access.rejection(request);
    return rejection ? rejection->status : HttpStatus::Ok;
}

TEST(Access, AcceptsThePageAndItsRequests) {
    EXPECT_EQ(status_of(page_request()), HttpStatus::Ok);
    EXPECT_EQ(status_of(post()), HttpStatus::Ok);
}

TEST(Access, AcceptsEachNameOfTheLoopbackInterfaceButNoOther) {
    for (const char* host : {"localhost:8080", "127.0.0.1:8080", "[::1]:8080"}) {
        HttpRequest request = post();
        request.host = host;
        request.origin = std::string("http://") + host;
        EXPECT_EQ(status_of(request), HttpStatus::Ok) << host;
    }
    // A name of an attacker that points to 127.0.0.1, another port, and near misses.
    for (const char* host : {"evil.example:8080",
                             "localhost",
                             "localhost:8081",
                             "localhost:8080.evil.example",
                             "127.0.0.1.evil.example:8080",
                             "0.0.0.0:8080",
                             "LOCALHOST:8080",
                             " localhost:8080",
                             ""}) {
        HttpRequest request = page_request();
        request.host = host;
        EXPECT_EQ(status_of(request), HttpStatus::Forbidden) << host;
    }
}

TEST(Access, RejectsForeignOrigins) {
    for (const char* origin : {"http://evil.example",
                               "null",
                               "",
                               "https://localhost:8080",
                               "http://localhost:8081",
                               // Another name of the same machine is another origin.
                               "http://127.0.0.1:8080"}) {
        HttpRequest request = post();
        request.origin = origin;
        EXPECT_EQ(status_of(request), HttpStatus::Forbidden) << origin;
    }
}

TEST(Access, RejectsRequestsThatAnotherSiteStarted) {
    for (const char* site : {"cross-site", "same-site", "none", ""}) {
        HttpRequest request = post();
        request.fetch_site = site;
        EXPECT_EQ(status_of(request), HttpStatus::Forbidden) << site;
    }
    HttpRequest read = page_request();
    read.target = "/api/program";
    read.fetch_site = "cross-site";
    EXPECT_EQ(status_of(read), HttpStatus::Forbidden);
}

TEST(Access, ALinkOfAnotherSiteMayOpenThePage) {
    HttpRequest request = page_request();
    request.fetch_site = "cross-site";
    EXPECT_EQ(status_of(request), HttpStatus::Ok);
}

TEST(Access, RejectsBodiesThatAFormCanSend) {
    for (const char* type : {"text/plain",
                             "application/x-www-form-urlencoded",
                             "multipart/form-data; boundary=x",
                             ""}) {
        HttpRequest request = post();
        request.content_type = type;
        EXPECT_EQ(status_of(request), HttpStatus::BadRequest) << type;
    }
}

TEST(Access, RejectsOtherMethods) {
    for (const char* method : {"PUT", "DELETE", "OPTIONS", "HEAD", "TRACE", ""}) {
        HttpRequest request = post();
        request.method = method;
        EXPECT_EQ(status_of(request), HttpStatus::MethodNotAllowed) << method;
    }
}

// Returns NAME=VALUE of the cookie that a response sets.
std::string cookie_of(const HttpResponse& response) {
    for (const auto& [name, value] : response.headers) {
        if (name == "Set-Cookie") {
            return value.substr(0, value.find(';'));
        }
    }
    return "";
}

TEST(Access, ExchangesTheTokenOnce) {
    Access access(kPort);
    EXPECT_FALSE(access.exchange(""));
    EXPECT_FALSE(access.exchange(access.token().substr(1)));
    const std::optional<HttpResponse> response = access.exchange(access.token());
    ASSERT_TRUE(response);
    HttpRequest request = post();
    EXPECT_FALSE(access.has_cookie(request));
    request.cookie = cookie_of(*response);
    EXPECT_TRUE(access.has_cookie(request));
    EXPECT_FALSE(access.exchange(access.token()));
}

TEST(Access, TheCookieIsHiddenFromScriptsAndFromOtherSites) {
    Access access(kPort);
    const std::string field = access.exchange(access.token())->headers.front().second;
    EXPECT_NE(field.find("; HttpOnly"), std::string::npos);
    EXPECT_NE(field.find("; SameSite=Strict"), std::string::npos);
}

TEST(Access, FindsTheCookieAmongOthersAndRejectsForgedOnes) {
    Access access(kPort);
    const std::string cookie = cookie_of(*access.exchange(access.token()));
    HttpRequest request = post();
    request.cookie = "theme=dark; " + cookie + "; other=1";
    EXPECT_TRUE(access.has_cookie(request));
    for (const std::string& forged : {"x" + cookie,
                                      cookie + "0",
                                      cookie.substr(0, cookie.size() - 1),
                                      std::string("foamtex_8080="),
                                      std::string("foamtex_8080"),
                                      std::string(";;;=;")}) {
        request.cookie = forged;
        EXPECT_FALSE(access.has_cookie(request)) << forged;
    }
}

TEST(Access, TokensHave128RandomBits) {
    std::set<std::string> tokens;
    for (int k = 0; k < 100; ++k) {
        const Access access(kPort);
        EXPECT_EQ(access.token().size(), 32U);
        EXPECT_EQ(access.token().find_first_not_of("0123456789abcdef"), std::string::npos);
        tokens.insert(access.token());
    }
    EXPECT_EQ(tokens.size(), 100U);
}

}  // namespace
}  // namespace foam::texgen
