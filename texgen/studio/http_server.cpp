// SPDX-License-Identifier: Apache-2.0

#include "texgen/studio/http_server.h"

#include "texgen/image/file_io.h"

// Boost.Asio 1.74 uses std::exchange without including its header.
#include <boost/asio.hpp>
#include <boost/beast.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// One thread, which calls run(), does all input and output. It reads a request, posts a call of the
// handler to a pool of threads, and writes the response when the pool has posted it back. A
// connection is therefore in one of three states: it reads (idle, until the request is complete),
// its handler works, or it writes.

namespace foam::texgen {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using tcp = asio::ip::tcp;
using boost::system::error_code;

constexpr std::chrono::milliseconds kTick{100};
// The time in which the rest of a rejected request is read, so that the client gets the response.
constexpr std::chrono::seconds kDrainTime{2};

// Returns the value of a field, or an empty text if the field is missing or occurs more than once.
std::string single(const http::fields& fields, std::string_view name) {
    const boost::string_view key(name.data(), name.size());
    return fields.count(key) == 1 ? std::string(fields[key]) : std::string();
}

HttpRequest plain(http::request<http::string_body>&& request) {
    return {.method = std::string(request.method_string()),
            .target = std::string(request.target()),
            .host = single(request, "Host"),
            .origin = single(request, "Origin"),
            .fetch_site = single(request, "Sec-Fetch-Site"),
            .content_type = single(request, "Content-Type"),
            .cookie = single(request, "Cookie"),
            .body = std::move(request.body())};
}

// Returns the response to a request that could not be read, or nullopt if the client has closed the
// connection or was too slow.
std::optional<HttpResponse> answer_to(const error_code& error) {
    const auto rejection = [](HttpStatus status, const char* message) {
        return HttpResponse{
            .status = status,
            .body = fmt::format(R"({{"error":{{"message":"{}","key":null}}}})", message)};
    };
    if (error == http::error::header_limit) {
        return rejection(HttpStatus::HeaderTooLarge, "the header of the request is too large");
    }
    if (error == http::error::body_limit) {
        return rejection(HttpStatus::PayloadTooLarge, "the body of the request is too large");
    }
    if (error.category() == make_error_code(http::error::bad_method).category() &&
        error != http::error::end_of_stream && error != http::error::partial_message) {
        return rejection(HttpStatus::BadRequest, "the request is not valid HTTP");
    }
    return std::nullopt;
}

}  // namespace

class HttpServer::Listener {
  public:
    Listener(int port, const HttpLimits& limits) : limits_(limits) {
        listen(tcp::endpoint(asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(port)));
        try {
            listen(tcp::endpoint(asio::ip::address_v6::loopback(),
                                 static_cast<std::uint16_t>(this->port())));
        } catch (const boost::system::system_error& error) {
            // A system without IPv6 is served by IPv4 alone.
            if (error.code() == asio::error::address_in_use) {
                throw;
            }
        }
    }

    int port() const { return acceptors_.front().local_endpoint().port(); }

    void run(const HttpHandler& handler,
             const std::function<void()>& on_tick,
             const std::function<void()>& on_end) {
        handler_ = &handler;
        asio::thread_pool pool(limits_.connections + acceptors_.size());
        pool_ = &pool;
        for (Acceptor& acceptor : acceptors_) {
            accept(acceptor);
        }
        tick(on_tick);
        try {
            io_.run();
        } catch (...) {
            on_end();
            pool.join();
            throw;
        }
    }

  private:
    using Acceptor = tcp::acceptor;

    class Connection : public std::enable_shared_from_this<Connection> {
      public:
        Connection(tcp::socket socket, Listener& listener)
            : stream_(std::move(socket)), listener_(listener) {
            error_code ignored;
            stream_.socket().set_option(tcp::no_delay(true), ignored);
        }

        bool is_idle() const { return is_idle_; }
        void close() { stream_.close(); }

        void read() {
            is_idle_ = true;
            listener_.move_to_end(this);
            parser_.emplace();
            parser_->header_limit(static_cast<std::uint32_t>(listener_.limits_.header_bytes));
            parser_->body_limit(listener_.limits_.body_bytes);
            stream_.expires_after(listener_.limits_.transfer);
            http::async_read(stream_,
                             buffer_,
                             *parser_,
                             [self = shared_from_this()](const error_code& error, std::size_t) {
                                 self->take(error);
                             });
        }

      private:
        // What follows a response: the next request, the end of the connection, or, after a request
        // that was not read completely, reading the rest of it.
        enum class Next { Read, Close, Drain };

        // Continues after a request has been read, or could not be read.
        void take(const error_code& error) {
            is_idle_ = false;
            if (error) {
                if (std::optional<HttpResponse> answer = answer_to(error)) {
                    write(*std::move(answer), Next::Drain);
                } else {
                    listener_.remove(this);
                }
                return;
            }
            stream_.expires_never();
            const Next next = parser_->get().keep_alive() ? Next::Read : Next::Close;
            asio::post(
                *listener_.pool_,
                [self = shared_from_this(), request = plain(parser_->release()), next]() mutable {
                    HttpResponse response = (*self->listener_.handler_)(request);
                    asio::post(self->listener_.io_,
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
            stream_.expires_after(listener_.limits_.transfer);
            http::async_write(
                stream_,
                *message_,
                [self = shared_from_this(), next](const error_code& error, std::size_t) {
                    self->message_.reset();
                    if (!error && next == Next::Read && self->listener_.waiting_.empty()) {
                        self->read();
                    } else if (!error && next == Next::Drain) {
                        self->begin_drain();
                    } else {
                        self->listener_.remove(self.get());
                    }
                });
        }

        // Ends the connection so that the client gets the whole response: if the socket were closed
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
            stream_.async_read_some(
                buffer_.prepare(kDrainBytes),
                [self = shared_from_this()](const error_code& error, std::size_t) {
                    if (error) {
                        self->listener_.remove(self.get());
                    } else {
                        self->drain();
                    }
                });
        }

        static constexpr std::size_t kDrainBytes = 64 * 1024;

        beast::tcp_stream stream_;
        beast::flat_buffer buffer_;
        std::optional<http::request_parser<http::string_body>> parser_;
        std::optional<http::response<http::string_body>> message_;
        Listener& listener_;
        bool is_idle_ = true;  // true if nobody misses the connection when it is closed
    };

    void listen(const tcp::endpoint& endpoint) {
        Acceptor acceptor(io_);
        acceptor.open(endpoint.protocol());
        if (endpoint.address().is_v6()) {
            acceptor.set_option(asio::ip::v6_only(true));
        }
        acceptor.set_option(Acceptor::reuse_address(true));
        acceptor.bind(endpoint);
        acceptor.listen();
        acceptors_.push_back(std::move(acceptor));
    }

    void accept(Acceptor& acceptor) {
        acceptor.async_accept([this, &acceptor](const error_code& error, tcp::socket socket) {
            if (!error) {
                connections_.push_back(std::make_shared<Connection>(std::move(socket), *this));
                connections_.back()->read();
            }
            if (connections_.size() <= limits_.connections) {
                accept(acceptor);
            } else {
                waiting_.push_back(&acceptor);
                close_idle();
            }
        });
    }

    // Closes the connection that has waited longest for a request, except for the newest one.
    void close_idle() {
        const auto newest = std::prev(connections_.end());
        const auto idle = std::find_if(
            connections_.begin(), newest, [](const auto& one) { return one->is_idle(); });
        if (idle != newest) {
            (*idle)->close();
        }
    }

    void move_to_end(const Connection* connection) {
        const auto found =
            std::ranges::find(connections_, connection, [](const auto& one) { return one.get(); });
        connections_.splice(connections_.end(), connections_, found);
    }

    void remove(const Connection* connection) {
        connections_.remove_if([&](const auto& one) { return one.get() == connection; });
        while (!waiting_.empty() && connections_.size() <= limits_.connections) {
            Acceptor* const acceptor = waiting_.back();
            waiting_.pop_back();
            accept(*acceptor);
        }
    }

    void tick(const std::function<void()>& on_tick) {
        timer_.expires_after(kTick);
        timer_.async_wait([this, &on_tick](const error_code&) {
            on_tick();
            tick(on_tick);
        });
    }

    HttpLimits limits_;
    asio::io_context io_{1};
    std::vector<Acceptor> acceptors_;
    std::vector<Acceptor*> waiting_;  // acceptors that wait for a connection to end
    // In the order in which they began to wait for a request.
    std::list<std::shared_ptr<Connection>> connections_;
    asio::steady_timer timer_{io_};
    asio::thread_pool* pool_ = nullptr;
    const HttpHandler* handler_ = nullptr;
};

HttpServer::HttpServer(int port, const HttpLimits& limits) {
    try {
        listener_ = std::make_unique<Listener>(port, limits);
    } catch (const boost::system::system_error& error) {
        throw OutputError(
            fmt::format("cannot listen on port {}: {}", port, error.code().message()));
    }
}

HttpServer::~HttpServer() = default;

int HttpServer::port() const {
    return listener_->port();
}

void HttpServer::run(const HttpHandler& handler,
                     const std::function<void()>& on_tick,
                     const std::function<void()>& on_end) {
    listener_->run(handler, on_tick, on_end);
}

}  // namespace foam::texgen
