// SPDX-License-Identifier: Apache-2.0

#include "texgen/studio/http_server.h"

#include "core/files/file_io.h"

#include <arpa/inet.h>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace foam::texgen {
namespace {

using std::chrono::milliseconds;

// Ends the server of a test.
class Ended : public std::exception {};

// Runs a server in a thread until the object is destroyed.
class RunningServer {
  public:
    explicit RunningServer(HttpHandler handler, const HttpLimits& limits = {})
        : server_(0, limits), handler_(std::move(handler)), thread_([this] { run(); }) {}

    ~RunningServer() {
        end_ = true;
        thread_.join();
    }

    RunningServer(const RunningServer&) = delete;
    RunningServer& operator=(const RunningServer&) = delete;

    int port() const { return server_.port(); }

  private:
    void run() {
        const auto tick = [this] {
            if (end_) {
                throw Ended();
            }
        };
        EXPECT_THROW(server_.run(handler_, tick, [] {}), Ended);
    }

    HttpServer server_;
    HttpHandler handler_;
    std::atomic<bool> end_ = false;
    std::thread thread_;
};

// A client that sends and receives bytes.
class Client {
  public:
    explicit Client(int port, const char* address = "127.0.0.1")
        : socket_(connected(port, address)) {
        const timeval limit{.tv_sec = 10, .tv_usec = 0};
        setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
    }
    ~Client() { close(socket_); }
    Client(const Client&) = delete;
    Client& operator=(const Client&) = delete;

    bool is_connected() const { return socket_ >= 0; }

    void send_text(const std::string& text) const {
        std::size_t sent = 0;
        while (sent < text.size()) {
            const ssize_t count =
                send(socket_, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
            if (count <= 0) {
                return;
            }
            sent += static_cast<std::size_t>(count);
        }
    }

    // Returns what the server sends until it ends with `end`, or until it closes the connection.
    std::string receive_until(const std::string& end) const {
        std::string text;
        char byte = 0;
        while (!text.ends_with(end) && recv(socket_, &byte, 1, 0) == 1) {
            text += byte;
        }
        return text;
    }

    // Returns what the server sends until it closes the connection.
    std::string receive_all() const {
        std::string text;
        std::vector<char> bytes(1 << 16);
        ssize_t count = 0;
        while ((count = recv(socket_, bytes.data(), bytes.size(), 0)) > 0) {
            text.append(bytes.data(), static_cast<std::size_t>(count));
        }
        return text;
    }

  private:
    static int connected(int port, const char* address) {
        const int socket_number = socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in to{};
        to.sin_family = AF_INET;
        to.sin_port = htons(static_cast<std::uint16_t>(port));
        inet_pton(AF_INET, address, &to.sin_addr);
        if (connect(socket_number, reinterpret_cast<const sockaddr*>(&to), sizeof to) != 0) {
            close(socket_number);
            return -1;
        }
        return socket_number;
    }

    int socket_;
};

HttpResponse echo(const HttpRequest& request) {
    return {.content_type = "text/plain",
            .body = fmt::format(
                "{} {} [{}] {}", request.method, request.target, request.host, request.body)};
}

std::string get(const std::string& target, const std::string& fields = "Host: h\r\n") {
    return "GET " + target + " HTTP/1.1\r\n" + fields + "\r\n";
}

std::string post(const std::string& body) {
    return fmt::format(
        "POST /p HTTP/1.1\r\nHost: h\r\nContent-Length: {}\r\n\r\n{}", body.size(), body);
}

TEST(HttpServer, AnswersSeveralRequestsOnOneConnection) {
    const RunningServer server(echo);
    const Client client(server.port());
    client.send_text(get("/one"));
    EXPECT_NE(client.receive_until("GET /one [h] ").find("200 OK"), std::string::npos);
    client.send_text(post("hello"));
    EXPECT_NE(client.receive_until("POST /p [h] hello").find("Content-Length: 17"),
              std::string::npos);
}

TEST(HttpServer, ListensOnTheLoopbackInterfaceOnly) {
    const RunningServer server(echo);
    // 127.0.0.2 is an address of the loopback interface, but not the one of the server. If the
    // server listened on all addresses, it would answer here.
    EXPECT_FALSE(Client(server.port(), "127.0.0.2").is_connected());
    EXPECT_TRUE(Client(server.port()).is_connected());
}

TEST(HttpServer, AFieldThatOccursTwiceIsEmpty) {
    const RunningServer server(echo);
    const Client client(server.port());
    client.send_text(get("/", "Host: a\r\nHost: b\r\n"));
    EXPECT_NE(client.receive_until("GET / [] ").find("GET / [] "), std::string::npos);
}

TEST(HttpServer, RejectsALargeHeader) {
    const RunningServer server(echo);
    const Client client(server.port());
    client.send_text(get("/", "X: " + std::string(9000, 'x') + "\r\n"));
    const std::string response = client.receive_all();
    EXPECT_NE(response.find("431"), std::string::npos);
    EXPECT_NE(response.find("Content-Security-Policy: default-src 'self';"), std::string::npos);
}

TEST(HttpServer, RejectsALargeBody) {
    const RunningServer server(echo);
    const Client client(server.port());
    client.send_text(post(std::string(2 * 1024 * 1024, 'x')));
    EXPECT_NE(client.receive_all().find("413"), std::string::npos);
}

TEST(HttpServer, AcceptsABodyOfTheLargestSize) {
    const RunningServer server(echo);
    const Client client(server.port());
    client.send_text(post(std::string(1024 * 1024, 'x')));
    EXPECT_NE(client.receive_until("xxx").find("200 OK"), std::string::npos);
}

TEST(HttpServer, RejectsWhatIsNotHttp) {
    const RunningServer server(echo);
    const Client client(server.port());
    client.send_text("this is not a request\r\n\r\n");
    EXPECT_NE(client.receive_all().find("400"), std::string::npos);
}

TEST(HttpServer, ClosesAConnectionThatSendsTooSlowly) {
    const RunningServer server(echo, {.transfer = milliseconds(200)});
    const Client client(server.port());
    client.send_text("GET / HT");
    EXPECT_EQ(client.receive_all(), "");
}

TEST(HttpServer, ClosesAConnectionThatReadsTooSlowly) {
    // The text is larger than the buffers of the sockets.
    const std::string large(64 * 1024 * 1024, 'x');
    const RunningServer server([&](const HttpRequest&) { return HttpResponse{.body = large}; },
                               {.transfer = milliseconds(200)});
    const Client client(server.port());
    client.send_text(get("/"));
    std::this_thread::sleep_for(milliseconds(600));
    EXPECT_LT(client.receive_all().size(), large.size());
}

TEST(HttpServer, ANewConnectionReplacesTheOneThatIsIdleLongest) {
    const RunningServer server(echo, {.connections = 2});
    const Client first(server.port());
    first.send_text(get("/1"));
    first.receive_until("GET /1 [h] ");
    const Client second(server.port());
    second.send_text(get("/2"));
    second.receive_until("GET /2 [h] ");
    const Client third(server.port());
    third.send_text(get("/3"));
    EXPECT_NE(third.receive_until("GET /3 [h] ").find("200 OK"), std::string::npos);
    EXPECT_EQ(first.receive_all(), "");
    second.send_text(get("/4"));
    EXPECT_NE(second.receive_until("GET /4 [h] ").find("200 OK"), std::string::npos);
}

TEST(HttpServer, ServesTwoHundredConnectionsAtOnce) {
    std::atomic<int> busy = 0;
    std::atomic<int> most = 0;
    const RunningServer server([&](const HttpRequest& request) {
        most = std::max<int>(most, ++busy);
        std::this_thread::sleep_for(milliseconds(5));
        --busy;
        return echo(request);
    });
    std::vector<std::unique_ptr<Client>> clients;
    for (int k = 0; k < 200; ++k) {
        clients.push_back(std::make_unique<Client>(server.port()));
        clients.back()->send_text(get("/", "Host: h\r\nConnection: close\r\n"));
    }
    int answered = 0;
    for (const auto& client : clients) {
        answered += client->receive_all().find("200 OK") != std::string::npos ? 1 : 0;
    }
    // A connection may be closed as idle before its request has arrived, but not many are.
    EXPECT_GE(answered, 150);
    EXPECT_LE(most, 18);
}

TEST(HttpServer, ServesTenThousandRequests) {
    const RunningServer server(echo);
    const Client client(server.port());
    for (int k = 0; k < 10'000; ++k) {
        client.send_text(get("/"));
        ASSERT_NE(client.receive_until("GET / [h] ").find("200 OK"), std::string::npos) << k;
    }
}

// Forbids new file descriptors, except for one, until the object is destroyed.
class OneFreeDescriptor {
  public:
    OneFreeDescriptor() {
        const int lowest_free = dup(0);
        close(lowest_free);
        getrlimit(RLIMIT_NOFILE, &before_);
        rlimit lower = before_;
        lower.rlim_cur = static_cast<rlim_t>(lowest_free) + 1;
        setrlimit(RLIMIT_NOFILE, &lower);
    }
    ~OneFreeDescriptor() { setrlimit(RLIMIT_NOFILE, &before_); }
    OneFreeDescriptor(const OneFreeDescriptor&) = delete;
    OneFreeDescriptor& operator=(const OneFreeDescriptor&) = delete;

  private:
    rlimit before_{};
};

// The client takes the only free descriptor, so that the server has none for the connection. Before
// that, requests on another connection run all code of the server: UndefinedBehaviorSanitizer opens
// a pipe when it meets a virtual table for the first time. When a request is answered, the server
// may not yet have completed its response, but it has completed that of the request before.
TEST(HttpServer, WaitsForAFreeDescriptorWithoutSpinning) {
    const RunningServer server(echo);
    const Client first(server.port());
    for (int request = 0; request < 3; ++request) {
        first.send_text(get("/"));
        ASSERT_NE(first.receive_until("GET / [h] ").find("200 OK"), std::string::npos);
    }
    std::unique_ptr<Client> client;
    {
        const OneFreeDescriptor limit;
        client = std::make_unique<Client>(server.port());
        ASSERT_TRUE(client->is_connected());
        client->send_text(get("/"));
        const std::clock_t begin = std::clock();  // processor time of all threads
        std::this_thread::sleep_for(milliseconds(1000));
        EXPECT_LT(std::clock() - begin, CLOCKS_PER_SEC / 10);
    }
    EXPECT_NE(client->receive_until("GET / [h] ").find("200 OK"), std::string::npos);
}

TEST(HttpServer, WaitsForItsHandlersAtTheEnd) {
    std::atomic<bool> is_done = false;
    {
        const RunningServer server([&](const HttpRequest&) {
            std::this_thread::sleep_for(milliseconds(300));
            is_done = true;
            return HttpResponse{};
        });
        const Client client(server.port());
        client.send_text(get("/"));
        std::this_thread::sleep_for(milliseconds(100));
    }
    EXPECT_TRUE(is_done);
}

TEST(HttpServer, APortThatIsInUseIsAnError) {
    const RunningServer server(echo);
    EXPECT_THROW(HttpServer second(server.port()), OutputError);
}

}  // namespace
}  // namespace foam::texgen
