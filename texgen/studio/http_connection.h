// SPDX-License-Identifier: Apache-2.0

#pragma once

// Only http_server.cpp includes this header, because Boost.Beast takes long to compile.

#include "texgen/studio/access.h"
#include "texgen/studio/http_limits.h"
#include "texgen/studio/http_message.h"

// Boost.Asio 1.74 uses std::exchange without including <utility>. http_message.h, above, includes
// it.
#include <boost/asio.hpp>
#include <boost/beast.hpp>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace foam::texgen {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using tcp = asio::ip::tcp;
using boost::system::error_code;

/// The longest time for which the rest of a rejected request is read, so that the client gets the
/// response.
inline constexpr std::chrono::seconds kDrainTime{2};

/// Returns the value of a header field, or an empty text if the field is missing or occurs more
/// than once.
inline std::string field_value(const http::fields& fields, std::string_view name) {
    const boost::string_view key(name.data(), name.size());
    return fields.count(key) == 1 ? std::string(fields[key]) : std::string();
}

/// Returns a request of Boost.Beast as an HttpRequest.
inline HttpRequest to_http_request(http::request<http::string_body>&& request) {
    return {.method = std::string(request.method_string()),
            .target = std::string(request.target()),
            .host = field_value(request, "Host"),
            .origin = field_value(request, "Origin"),
            .fetch_site = field_value(request, "Sec-Fetch-Site"),
            .content_type = field_value(request, "Content-Type"),
            .cookie = field_value(request, "Cookie"),
            .body = std::move(request.body())};
}

/// Returns the response to a request that could not be read, or nullopt if the client has closed
/// the connection or was too slow.
inline std::optional<HttpResponse> response_to(const error_code& error) {
    if (error == http::error::header_limit) {
        return error_response(HttpStatus::HeaderTooLarge, "the header of the request is too large");
    }
    if (error == http::error::body_limit) {
        return error_response(HttpStatus::PayloadTooLarge, "the body of the request is too large");
    }
    if (error.category() == make_error_code(http::error::bad_method).category() &&
        error != http::error::end_of_stream && error != http::error::partial_message) {
        return error_response(HttpStatus::BadRequest, "the request is not valid HTTP");
    }
    return std::nullopt;
}

class HttpConnection;

/// The interface by which a connection uses its server.
class HttpConnectionOwner {
  public:
    virtual ~HttpConnectionOwner() = default;

    virtual const HttpLimits& limits() const = 0;
    /// Returns the context whose thread reads and writes.
    virtual asio::io_context& io() = 0;
    /// Returns the threads that call `handle`.
    virtual asio::thread_pool& pool() = 0;
    virtual HttpResponse handle(const HttpRequest& request) const = 0;
    /// Returns true if the server does not accept connections at one of its addresses, because
    /// there are too many or because accepting one has failed.
    virtual bool is_crowded() const = 0;
    /// Moves a connection, which begins to wait for a request, to the end of the list of
    /// connections. If a new connection is one too many, the server closes the first idle
    /// connection of this list, but never the new one.
    virtual void move_to_end(const HttpConnection* connection) = 0;
    /// Forgets a connection that has ended.
    virtual void remove(const HttpConnection* connection) = 0;
};

/// A connection of the server. Reads a request, lets a thread of the pool handle it, writes the
/// response, and begins again. All functions are called on the thread of io().
class HttpConnection : public std::enable_shared_from_this<HttpConnection> {
  public:
    HttpConnection(tcp::socket socket, HttpConnectionOwner& owner)
        : stream_(std::move(socket)), owner_(owner) {
        error_code ignored;
        stream_.socket().set_option(tcp::no_delay(true), ignored);
    }

    bool is_idle() const { return is_idle_; }
    void close() { stream_.close(); }

    void read() {
        is_idle_ = true;
        owner_.move_to_end(this);
        parser_.emplace();
        parser_->header_limit(static_cast<std::uint32_t>(owner_.limits().header_bytes));
        parser_->body_limit(owner_.limits().body_bytes);
        stream_.expires_after(owner_.limits().transfer);
        http::async_read(stream_,
                         buffer_,
                         *parser_,
                         [self = shared_from_this()](const error_code& error, std::size_t) {
                             self->on_read(error);
                         });
    }

  private:
    // The action after a response:
    // - Read: read the next request.
    // - Close: close the connection.
    // - Drain: read the rest of a request that was rejected before it was read completely, and
    //   then close the connection.
    enum class Next { Read, Close, Drain };

    // Continues after a request has been read, or could not be read.
    void on_read(const error_code& error) {
        is_idle_ = false;
        if (error) {
            if (std::optional<HttpResponse> answer = response_to(error)) {
                write(with_safety_fields(*std::move(answer)), Next::Drain);
            } else {
                owner_.remove(this);
            }
            return;
        }
        stream_.expires_never();
        const Next next = parser_->get().keep_alive() ? Next::Read : Next::Close;
        asio::post(owner_.pool(),
                   [self = shared_from_this(),
                    request = to_http_request(parser_->release()),
                    next]() mutable {
                       HttpResponse response = self->owner_.handle(request);
                       asio::post(self->owner_.io(),
                                  [self, response = std::move(response), next]() mutable {
                                      self->write(std::move(response), next);
                                  });
                   });
    }

    void write(HttpResponse response, Next next) {
        message_.emplace();
        message_->result(static_cast<unsigned>(response.status));
        message_->set(http::field::content_type, response.content_type);
        for (const auto& [name, value] : response.headers) {
            message_->set(name, value);
        }
        message_->keep_alive(next == Next::Read);
        message_->body() = std::move(response.body);
        message_->prepare_payload();
        stream_.expires_after(owner_.limits().transfer);
        http::async_write(stream_,
                          *message_,
                          [self = shared_from_this(), next](const error_code& error, std::size_t) {
                              self->message_.reset();
                              if (!error && next == Next::Read && !self->owner_.is_crowded()) {
                                  self->read();
                              } else if (!error && next == Next::Drain) {
                                  self->begin_drain();
                              } else {
                                  self->owner_.remove(self.get());
                              }
                          });
    }

    // Ends the connection so that the client gets the whole response. If the socket were closed
    // while parts of the request are unread, the system would reset the connection.
    void begin_drain() {
        is_idle_ = true;
        error_code ignored;
        stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
        stream_.expires_after(kDrainTime);
        drain();
    }

    void drain() {
        buffer_.clear();
        stream_.async_read_some(buffer_.prepare(kDrainBytes),
                                [self = shared_from_this()](const error_code& error, std::size_t) {
                                    if (error) {
                                        self->owner_.remove(self.get());
                                    } else {
                                        self->drain();
                                    }
                                });
    }

    static constexpr std::size_t kDrainBytes = 65'536;

    beast::tcp_stream stream_;
    beast::flat_buffer buffer_;
    std::optional<http::request_parser<http::string_body>> parser_;
    std::optional<http::response<http::string_body>> message_;
    HttpConnectionOwner& owner_;
    bool is_idle_ = true;  // true unless a request is being handled or a response written
};

}  // namespace foam::texgen
