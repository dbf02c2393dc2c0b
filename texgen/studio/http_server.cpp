// SPDX-License-Identifier: Apache-2.0

#include "texgen/studio/http_server.h"

#include "core/files/file_io.h"
#include "texgen/studio/http_connection.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <list>
#include <memory>
#include <utility>
#include <vector>

// One thread, which calls run(), does all input and output. It reads a request, posts a call of the
// handler to a pool of threads, and writes the response when the pool has posted it back. A
// connection is therefore in one of three states: it reads (idle, until the request is complete),
// its handler works, or it writes. In addition, it drains (also idle) after the response to a
// request that could not be read (HttpConnection::begin_drain).

namespace foam::texgen {

namespace {

constexpr std::chrono::milliseconds kTick{100};

}  // namespace

class HttpServer::Listener final : public HttpConnectionOwner {
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

    const HttpLimits& limits() const override { return limits_; }
    asio::io_context& io() override { return io_; }
    asio::thread_pool& pool() override { return *pool_; }
    HttpResponse handle(const HttpRequest& request) const override { return (*handler_)(request); }
    bool is_crowded() const override { return !waiting_.empty(); }

    void move_to_end(const HttpConnection* connection) override {
        const auto found =
            std::ranges::find(connections_, connection, [](const auto& one) { return one.get(); });
        connections_.splice(connections_.end(), connections_, found);
    }

    void remove(const HttpConnection* connection) override {
        connections_.remove_if([&](const auto& one) { return one.get() == connection; });
        accept_again();
    }

  private:
    using Acceptor = tcp::acceptor;

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
            if (error) {  // no file descriptor is free, for example
                waiting_.push_back(&acceptor);
                return;
            }
            connections_.push_back(std::make_shared<HttpConnection>(std::move(socket), *this));
            connections_.back()->read();
            if (connections_.size() <= limits_.connections) {
                accept(acceptor);
            } else {
                waiting_.push_back(&acceptor);
                close_idle();
            }
        });
    }

    // Lets the waiting acceptors accept again, unless there are too many connections.
    void accept_again() {
        while (!waiting_.empty() && connections_.size() <= limits_.connections) {
            Acceptor* const acceptor = waiting_.back();
            waiting_.pop_back();
            accept(*acceptor);
        }
    }

    // Closes the connection that has waited longest for a request, but never the newest one.
    void close_idle() {
        const auto newest = std::prev(connections_.end());
        const auto idle = std::find_if(
            connections_.begin(), newest, [](const auto& one) { return one->is_idle(); });
        if (idle != newest) {
            (*idle)->close();
        }
    }

    void tick(const std::function<void()>& on_tick) {
        timer_.expires_after(kTick);
        timer_.async_wait([this, &on_tick](const error_code&) {
            on_tick();
            accept_again();
            tick(on_tick);
        });
    }

    HttpLimits limits_;
    asio::io_context io_{1};
    std::vector<Acceptor> acceptors_;
    // Acceptors that wait for a connection to end or, after an error, for the next tick.
    std::vector<Acceptor*> waiting_;
    // The connections, in the order in which they began to wait for a request.
    std::list<std::shared_ptr<HttpConnection>> connections_;
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
