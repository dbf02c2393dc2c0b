// SPDX-License-Identifier: Apache-2.0

#include "texgen/studio/handler.h"

#include "core/files/file_io.h"
#include "core/files/scratch_folder.h"
#include "core/files/shown_text.h"
#include "texgen/image/png.h"
#include "texgen/studio/page_files.h"
#include "texgen/studio/samples.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

namespace foam::texgen {
namespace {

namespace fs = std::filesystem;

// A studio in a folder of its own, and a page that has access to it.
class StudioTest : public testing::Test {
  protected:
    StudioTest() : studio_(scratch_.path(), 8080) {
        const HttpResponse response = post("/api/session", {{"token", studio_.token()}});
        for (const auto& [name, value] : response.headers) {
            if (name == "Set-Cookie") {
                cookie_ = value.substr(0, value.find(';'));
            }
        }
    }

    ~StudioTest() override { studio_.stop(); }

    HttpRequest request(const std::string& target, const std::string& body) const {
        return {.method = "POST",
                .target = target,
                .host = "localhost:8080",
                .origin = "http://localhost:8080",
                .fetch_site = "same-origin",
                .content_type = "application/json",
                .cookie = cookie_,
                .body = body};
    }

    HttpResponse post(const std::string& target, const Json& body) {
        return studio_.handle(request(target, json_text(body)));
    }

    // Posts a body that need not be JSON.
    HttpResponse raw(const std::string& target, const std::string& body) {
        return studio_.handle(request(target, body));
    }

    HttpResponse get(const std::string& target) {
        HttpRequest read = request(target, "");
        read.method = "GET";
        return studio_.handle(read);
    }

    // Posts a request that succeeds, and returns the JSON of its response.
    Json answer(const std::string& target, const Json& body) {
        const HttpResponse response = post(target, body);
        EXPECT_EQ(response.status, HttpStatus::Ok) << target << " " << response.body;
        return Json::parse(response.body);
    }

    static std::string message_of(const HttpResponse& response) {
        return Json::parse(response.body)["error"]["message"];
    }

    // Waits until a bake has ended, and returns its last status.
    Json ended_bake(const Json& bake) {
        Json status;
        do {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            status = answer("/api/bake/status", {{"bake", bake}});
        } while (status["status"] == "running");
        return status;
    }

    // Bakes into a folder, and waits until the bake is complete.
    void bake(const Json& request) {
        const Json status = ended_bake(answer("/api/bake", request)["bake"]);
        EXPECT_EQ(status["status"], "complete") << status;
    }

    // Returns the set of a folder with one baked set.
    Json set_in(const std::string& folder) {
        const Json bakes = answer("/api/bakes", Json::object())["bakes"];
        for (const Json& bake : bakes) {
            if (bake["folder"] == folder) {
                return bake["set"];
            }
        }
        return nullptr;
    }

    const fs::path& folder() const { return scratch_.path(); }

    // Settings of a small foam of three frames.
    static Json settings(std::vector<std::string> more = {}) {
        std::vector<std::string> set{"foam.bubbles=40", "frames.count=3", "image.size=[64, 32]"};
        set.insert(set.end(), more.begin(), more.end());
        return {{"preset", "sea_foam"}, {"set", set}, {"events", nullptr}};
    }

    static Json picture(const std::string& map, std::vector<std::string> more = {}) {
        return {{"settings", settings(std::move(more))},
                {"page", "test"},
                {"frame", 2},
                {"map", map},
                {"width", 64},
                {"quality", "full"},
                {"samples", "rgba"}};
    }

    static Json picture_header(const HttpResponse& response) {
        for (const auto& [name, value] : response.headers) {
            if (name == "X-Foamtex-Picture") {
                return Json::parse(value);
            }
        }
        return {};
    }

  private:
    ScratchFolder scratch_;
    Studio studio_;
    std::string cookie_;
};

TEST_F(StudioTest, ServesThePageWithoutACookie) {
    HttpRequest read{.method = "GET", .target = "/", .host = "localhost:8081"};
    Studio fresh(folder(), 8081);
    const HttpResponse page = fresh.handle(read);
    EXPECT_EQ(page.status, HttpStatus::Ok);
    EXPECT_EQ(page.content_type, "text/html; charset=utf-8");
    for (const PageFile& file : page_files()) {
        read.target = "/" + std::string(file.name);
        EXPECT_EQ(fresh.handle(read).body, file.content) << file.name;
    }
    fresh.stop();
}

TEST_F(StudioTest, EveryResponseHasTheFieldsThatProtectThePage) {
    for (const HttpResponse& response : {get("/"), get("/missing"), post("/api/settings", {})}) {
        std::string fields;
        for (const auto& [name, value] : response.headers) {
            fields += name + ": " + value + "\n";
        }
        for (const char* field : {"Content-Security-Policy: default-src 'self';",
                                  "frame-ancestors 'none'",
                                  "X-Content-Type-Options: nosniff",
                                  "Referrer-Policy: no-referrer",
                                  "Cache-Control: no-store"}) {
            EXPECT_NE(fields.find(field), std::string::npos) << field;
        }
        EXPECT_EQ(fields.find("Access-Control"), std::string::npos);
    }
}

TEST_F(StudioTest, RejectsRequestsWithoutTheCookie) {
    HttpRequest forged = request("/api/settings", R"({"settings":{}})");
    forged.cookie = "foamtex_8080=0123456789abcdef0123456789abcdef";
    Studio studio(folder(), 8080);
    EXPECT_EQ(studio.handle(forged).status, HttpStatus::Forbidden);
    forged.method = "GET";
    forged.target = "/api/program";
    EXPECT_EQ(studio.handle(forged).status, HttpStatus::Forbidden);
    studio.stop();
}

TEST_F(StudioTest, AGetChangesNothing) {
    for (const char* target : {"/api/settings", "/api/bake", "/api/save", "/api/session"}) {
        EXPECT_EQ(get(target).status, HttpStatus::MethodNotAllowed) << target;
    }
}

TEST_F(StudioTest, DoesNotServeOtherFiles) {
    std::ofstream(folder() / "secret.txt") << "secret";
    for (const char* target : {"/secret.txt",
                               "/../secret.txt",
                               "/..%2fsecret.txt",
                               "/page/../index.html",
                               "//index.html",
                               "/index.html?x",
                               "",
                               "index.html",
                               "/api/../index.html"}) {
        EXPECT_NE(get(target).status, HttpStatus::Ok) << target;
    }
}

TEST_F(StudioTest, DescribesTheProgram) {
    const HttpResponse response = get("/api/program");
    ASSERT_EQ(response.status, HttpStatus::Ok);
    const Json program = Json::parse(response.body);
    EXPECT_EQ(program["presets"][0]["name"], "sea_foam");
    EXPECT_EQ(program["folder"], fs::canonical(folder()).string());
    EXPECT_TRUE(program["schema"]["properties"].contains("foam"));
    EXPECT_EQ(program["maps"][0]["kind"], "color");
}

TEST_F(StudioTest, MalformedRequestsAreNamed) {
    EXPECT_EQ(raw("/api/settings", "{").status, HttpStatus::BadRequest);
    EXPECT_EQ(raw("/api/settings", "").status, HttpStatus::BadRequest);
    HttpRequest without_cookie = request("/api/session", "{");
    without_cookie.cookie.clear();
    EXPECT_EQ(Studio(folder(), 8080).handle(without_cookie).status, HttpStatus::BadRequest);
    EXPECT_EQ(post("/api/settings", Json::array()).status, HttpStatus::Unprocessable);
    Json wrong = picture("lit");
    wrong["frame"] = "two";
    const HttpResponse response = post("/api/picture", wrong);
    EXPECT_EQ(response.status, HttpStatus::Unprocessable);
    EXPECT_NE(message_of(response).find("frame"), std::string::npos);
    EXPECT_EQ(post("/api/nothing", {}).status, HttpStatus::NotFound);
}

// As in the messages that the program prints (shown_text).
TEST_F(StudioTest, MessagesAreOneLineOfLimitedLength) {
    const auto message = [&](const std::string& set) {
        return message_of(post("/api/settings", {{"settings", settings({set})}}));
    };
    EXPECT_TRUE(message("foam.seed=3\nfoam.bubbles=5").starts_with("--set foam.seed=3 foam.bub"));
    EXPECT_LE(message("foam.seed=" + std::string(5000, 'x')).size(), kMaxMessageLength);
}

TEST_F(StudioTest, APictureHasThePixelsOfABake) {
    for (const char* map : {"lit", "albedo", "normal", "id_color"}) {
        const HttpResponse drawn = post("/api/picture", picture(map));
        ASSERT_EQ(drawn.status, HttpStatus::Ok) << drawn.body;
        EXPECT_EQ(picture_header(drawn)["exact"], true) << map;
        const HttpResponse file = post("/api/download",
                                       {{"settings", settings()},
                                        {"page", "test"},
                                        {"kind", "frame"},
                                        {"frame", 2},
                                        {"map", map}});
        ASSERT_EQ(file.status, HttpStatus::Ok) << file.body;
        const Picture png = decode_png(std::as_bytes(std::span(file.body)));
        const ChannelGroup& group = png.groups.front();
        if (group.type == SampleType::Uint8) {
            EXPECT_EQ(drawn.body, rgba_from_top(std::get<Image<std::uint8_t>>(group.samples)))
                << map;
        }
    }
}

TEST_F(StudioTest, AnExactPictureHasTheRangeOfABake) {
    const Json request = picture("height");
    EXPECT_EQ(picture_header(post("/api/picture", request))["exact"], false);
    while (answer("/api/simulation", {{"settings", settings()}, {"page", "test"}})["status"] ==
           "running") {
    }
    Json exact = request;
    exact["quality"] = "exact";
    const Json header = picture_header(post("/api/picture", exact));
    EXPECT_EQ(header["exact"], true);
    const Json bake =
        answer("/api/bake", {{"settings", settings()}, {"folder", "baked"}, {"maps", {"height"}}});
    EXPECT_EQ(ended_bake(bake["bake"])["status"], "complete");
    std::ifstream manifest(folder() / "baked/manifest.json");
    const Json baked = Json::parse(manifest);
    EXPECT_EQ(baked["sets"][0]["maps"][0]["range"][1], header["high"]) << baked.dump(1);
}

TEST_F(StudioTest, FloatsAreInTheUnitOfTheMap) {
    Json request = picture("sides");
    request["samples"] = "float";
    const HttpResponse response = post("/api/picture", request);
    const Json header = picture_header(response);
    ASSERT_EQ(header["channels"], 1);
    ASSERT_EQ(response.body.size(), 64U * 32U * sizeof(float));
    float first = 0.0F;
    std::memcpy(&first, response.body.data(), sizeof first);
    Json pick = request;
    pick["x"] = 0;
    pick["y"] = 0;
    const Json picked = answer("/api/pick", pick);
    EXPECT_EQ(picked["numbers"][0], first);
    EXPECT_EQ(picked["bubble"]["sides"], first);
}

TEST_F(StudioTest, ADraftIsNotExact) {
    Json request = picture("lit");
    request["frame"] = 1;
    request["quality"] = "draft";
    const HttpResponse response = post("/api/picture", request);
    ASSERT_EQ(response.status, HttpStatus::Ok);
    EXPECT_EQ(picture_header(response)["exact"], false);
}

TEST_F(StudioTest, BakesAFolderThatVerifies) {
    const Json bake = answer("/api/bake",
                             {{"settings", settings()},
                              {"folder", "my/out"},
                              {"frames", "1-2"},
                              {"format", "png"},
                              {"maps", {"lit", "height"}},
                              {"size", {32, 16}},
                              {"resume", false}});
    EXPECT_EQ(bake["command"],
              "foamtex bake sea_foam --set foam.bubbles=40 --set frames.count=3 --set "
              "'image.size=[64, 32]' --maps lit,height --frames 1-2 --size 32x16 --out "
              "'my/out/{preset}_{map}.####.png'");
    const Json status = ended_bake(bake["bake"]);
    EXPECT_EQ(status["status"], "complete") << status;
    EXPECT_EQ(status["files"], 4);
    EXPECT_EQ(status["first_file"], "my/out/sea_foam_lit.0001.png");
    EXPECT_TRUE(fs::exists(folder() / "my/out/sea_foam_height.0002.png"));
}

TEST_F(StudioTest, BakesChangedEvents) {
    Json changed = settings({"loop.kind=none"});
    changed["events"] = "[[event]]\nkind = \"collapse\"\nframe = 2\nsides = 5\n";
    bake({{"settings", changed}, {"folder", "plain"}});
    bake({{"settings", changed}, {"folder", "u"}, {"frames", "1"}, {"profile", "unreal"}});
}

TEST_F(StudioTest, AProfileBelongsToABake) {
    const Json bake =
        answer("/api/bake",
               {{"settings", settings()}, {"folder", "u"}, {"frames", "1"}, {"profile", "unreal"}});
    EXPECT_EQ(ended_bake(bake["bake"])["status"], "complete");
    EXPECT_TRUE(fs::exists(folder() / "u/frames/T_sea_foam_ORM.0001.png"));
    EXPECT_TRUE(fs::exists(folder() / "u/T_sea_foam_ORM.dds"));
}

TEST_F(StudioTest, BakesStayInTheFolder) {
    for (const Json& folder : {Json(".."), Json("/tmp"), Json("a/../../b")}) {
        EXPECT_EQ(post("/api/bake", {{"settings", settings()}, {"folder", folder}}).status,
                  HttpStatus::Unprocessable)
            << folder;
    }
    for (const char* set : {"output.pattern=/tmp/x.####.png",
                            "output.pattern=../../x.####.png",
                            "output.sheet_pattern=../../x"}) {
        const HttpResponse response =
            post("/api/bake", {{"settings", settings({set})}, {"folder", "out"}, {"frames", "1"}});
        EXPECT_EQ(response.status, HttpStatus::Unprocessable) << set;
    }
    EXPECT_EQ(
        post("/api/bake", {{"settings", settings()}, {"folder", "out"}, {"profile", "/etc/passwd"}})
            .status,
        HttpStatus::Unprocessable);
}

TEST_F(StudioTest, ABakeCanBeCanceled) {
    const Json large = settings({"foam.bubbles=2000", "frames.count=5000"});
    const Json bake = answer("/api/bake", {{"settings", large}, {"folder", "out"}});
    EXPECT_EQ(post("/api/bake", {{"settings", settings()}, {"folder", "out"}}).status,
              HttpStatus::Conflict);
    EXPECT_EQ(post("/api/bake/cancel", {{"bake", bake["bake"]}}).status, HttpStatus::NoContent);
    EXPECT_EQ(ended_bake(bake["bake"])["status"], "canceled");
    EXPECT_EQ(post("/api/bake/status", {{"bake", 99}}).status, HttpStatus::Unprocessable);
}

TEST_F(StudioTest, SavesAPreset) {
    const Json request = {{"settings", settings()}, {"file", "mine.toml"}, {"overwrite", false}};
    EXPECT_EQ(answer("/api/save", request)["file"], "mine.toml");
    EXPECT_EQ(post("/api/save", request).status, HttpStatus::Conflict);
    const Json own = {{"preset", "mine.toml"}, {"set", Json::array()}};
    EXPECT_EQ(answer("/api/settings", {{"settings", own}})["size"], Json({64, 32}));
    for (const char* file : {"../mine.toml", "mine.txt", ".toml", "/tmp/mine.toml"}) {
        Json wrong = request;
        wrong["file"] = file;
        EXPECT_EQ(post("/api/save", wrong).status, HttpStatus::Unprocessable) << file;
    }
}

TEST_F(StudioTest, ShowsBakedImages) {
    bake({{"settings", settings()}, {"folder", "b"}, {"maps", {"lit", "height"}}});
    const Json bakes = answer("/api/bakes", Json::object())["bakes"];
    ASSERT_EQ(bakes.size(), 1U);
    EXPECT_EQ(bakes[0]["folder"], "b");
    EXPECT_EQ(bakes[0]["frames"], Json({1, 2, 3}));
    const Json shown = {{"folder", "b"}, {"set", bakes[0]["set"]}, {"frame", 2}, {"width", 64}};
    Json lit = shown;
    lit["map"] = "lit";
    EXPECT_EQ(post("/api/baked", lit).body, post("/api/picture", picture("lit")).body);
    Json outside = lit;
    outside["folder"] = "..";
    EXPECT_EQ(post("/api/baked", outside).status, HttpStatus::Unprocessable);
}

// The name of a folder may contain any byte but '/'.
TEST_F(StudioTest, FoldersThatCannotBeReadDoNotEndTheGallery) {
    fs::create_directories(folder() / "a" / "manifest.json");
    for (const char* name : {"damaged", "two\nlines", "not UTF-8 \xff"}) {
        fs::create_directory(folder() / name);
        std::ofstream(folder() / name / "manifest.json") << "{}";
    }
    EXPECT_EQ(answer("/api/bakes", Json::object())["bakes"], Json::array());
}

TEST_F(StudioTest, ShowsEachSetOfAPreset) {
    bake({{"settings", settings()}, {"folder", "b"}, {"maps", {"lit"}}});
    bake({{"settings", settings({"image.size=[32, 16]"})}, {"folder", "b"}, {"format", "exr"}});
    const Json bakes = answer("/api/bakes", Json::object())["bakes"];
    ASSERT_EQ(bakes.size(), 2U);
    for (const Json& one : bakes) {
        Json request = {{"folder", one["folder"]},
                        {"set", one["set"]},
                        {"map", "lit"},
                        {"frame", 1},
                        {"width", 64}};
        EXPECT_EQ(picture_header(post("/api/baked", request))["width"], one["size"][0]);
        request["x"] = request["y"] = 0.5;
        EXPECT_EQ(post("/api/baked/pick", request).status, HttpStatus::Ok);
        request["set"] = "sea_foam";
        EXPECT_EQ(post("/api/baked", request).status, HttpStatus::Unprocessable);
    }
}

// A pixel of a baked image has the numbers of the live picture, up to the rounding of its codes.
TEST_F(StudioTest, ReadsNumbersOfBakedImages) {
    const Json maps = {"height", "id", "normal", "motion", "albedo"};
    for (const char* format : {"png", "exr"}) {
        bake({{"settings", settings()}, {"folder", format}, {"format", format}, {"maps", maps}});
        const Json set = set_in(format);
        for (const Json& map : maps) {
            Json live = picture(map);
            live["x"] = 20;
            live["y"] = 9;
            const Json expected = answer("/api/pick", live);
            const Json found = answer("/api/baked/pick",
                                      {{"folder", format},
                                       {"set", set},
                                       {"map", map},
                                       {"frame", live["frame"]},
                                       {"x", 20.5 / 64.0},
                                       {"y", 9.5 / 32.0}});
            EXPECT_EQ(found["color"], expected["color"]) << format << map;
            EXPECT_EQ(found["unit"], expected["unit"]) << format << map;
            if (found["color"] != nullptr) {
                continue;
            }
            ASSERT_EQ(found["numbers"].size(), expected["numbers"].size()) << format << map;
            for (std::size_t k = 0; k < found["numbers"].size(); ++k) {
                EXPECT_NEAR(found["numbers"][k], expected["numbers"][k], 0.004) << format << map;
            }
        }
    }
    const Json wrong = {{"folder", "png"},
                        {"set", set_in("png")},
                        {"map", "lit"},
                        {"frame", 1},
                        {"x", 1e300},
                        {"y", -1.0}};
    EXPECT_EQ(post("/api/baked/pick", wrong).status, HttpStatus::Unprocessable);
    Json far = wrong;
    far["map"] = "id";
    EXPECT_EQ(post("/api/baked/pick", far).status, HttpStatus::Ok);
}

TEST_F(StudioTest, DownloadsAFrameAsADrawing) {
    const HttpResponse drawing = post("/api/download",
                                      {{"settings", settings()},
                                       {"page", "test"},
                                       {"kind", "drawing"},
                                       {"frame", 2},
                                       {"map", "lit"}});
    ASSERT_EQ(drawing.status, HttpStatus::Ok) << drawing.body;
    EXPECT_EQ(drawing.content_type, "image/svg+xml");
    EXPECT_NE(drawing.body.find("<svg"), std::string::npos);
    EXPECT_NE(drawing.body.find("data-bubble"), std::string::npos);
}

TEST_F(StudioTest, ADownloadOfAnOpenLoopSaysWhyItFails) {
    for (const char* kind : {"frame", "drawing", "loop"}) {
        const HttpResponse response =
            post("/api/download",
                 {{"settings", settings({"loop.cycles=1", "loop.amplitude=0.4"})},
                  {"page", "test"},
                  {"kind", kind},
                  {"frame", 2},
                  {"map", "lit"}});
        EXPECT_EQ(response.status, HttpStatus::Unprocessable) << kind;
        EXPECT_NE(message_of(response).find("the loop does not close"), std::string::npos)
            << kind << ": " << message_of(response);
    }
}

TEST_F(StudioTest, DownloadsALoop) {
    const HttpResponse loop = post("/api/download",
                                   {{"settings", settings()},
                                    {"page", "test"},
                                    {"kind", "loop"},
                                    {"frame", 1},
                                    {"map", "lit"},
                                    {"width", 32}});
    ASSERT_EQ(loop.status, HttpStatus::Ok) << loop.body;
    const Picture first = decode_png(std::as_bytes(std::span(loop.body)));
    EXPECT_EQ(first.groups.front().width(), 32);
    EXPECT_NE(loop.body.find("acTL"), std::string::npos);
}

}  // namespace
}  // namespace foam::texgen
