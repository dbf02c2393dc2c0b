// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/earlier_sheets.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

using Names = std::vector<std::string>;

class EarlierSheetsTest : public testing::Test {
  protected:
    /// Returns a description of sheets of these maps.
    static Json description(const Names& maps) {
        Json json{{"format", "foamtex-flipbook"}, {"frames", 4}, {"images", Json::array()}};
        for (const std::string& map : maps) {
            json["images"].push_back({{"file", map + ".png"}, {"map", map}});
        }
        return json;
    }

    static Names maps_of(const Json& flipbook) {
        Names maps;
        for (const Json& image : flipbook["images"]) {
            maps.push_back(image["map"]);
        }
        return maps;
    }

    void write(const std::string& name, const std::string& text = "") const {
        write_file(folder_.path() / name, std::as_bytes(std::span(text)));
    }

    Names keep(Json& flipbook, const std::string& earlier) const {
        return keep_earlier_sheets(flipbook, earlier, folder_.path()).unlisted;
    }

    TemporaryFolder folder_;
};

TEST_F(EarlierSheetsTest, SheetsOfOtherMapsAreKeptIfTheyExist) {
    write("albedo.png");
    write("height.png");
    Json flipbook = description({"height", "film"});
    EXPECT_EQ(keep(flipbook, description({"albedo", "height", "normal"}).dump()), Names{});
    EXPECT_EQ(maps_of(flipbook), (Names{"height", "film", "albedo"}));
}

TEST_F(EarlierSheetsTest, SheetsOfOtherFramesAreReported) {
    write("albedo.png");
    write("height.png");
    Json flipbook = description({"height"});
    flipbook["frames"] = 8;
    EXPECT_EQ(keep(flipbook, description({"albedo", "height", "normal"}).dump()),
              Names{"albedo.png"});
    EXPECT_EQ(maps_of(flipbook), Names{"height"});
}

TEST_F(EarlierSheetsTest, ReplacedSheetsOfAnotherBakeAreReported) {
    write("height.png");
    Json flipbook = description({"height", "film"});
    Json earlier = description({"height", "film"});
    const auto replaced = [&] {
        return keep_earlier_sheets(flipbook, earlier.dump(), folder_.path()).replaced;
    };
    EXPECT_EQ(replaced(), Names{});
    earlier["parameters"] = "0123";
    EXPECT_EQ(replaced(), Names{"height.png"});
}

TEST_F(EarlierSheetsTest, OtherTextsAreIgnored) {
    Json flipbook = description({"height"});
    for (const char* const text : {"", "{", "[1]", "{}", R"({"images": [7, {"file": 1}]})"}) {
        EXPECT_EQ(keep(flipbook, text), Names{}) << text;
    }
    EXPECT_EQ(flipbook, description({"height"}));
}

TEST_F(EarlierSheetsTest, DeeplyNestedTextsAreIgnored) {
    constexpr std::size_t kLevels = 500'000;
    const std::string nested = std::string(kLevels, '[') + std::string(kLevels, ']');
    Json flipbook = description({"height"});
    EXPECT_EQ(keep(flipbook, R"({"images": [], "more": )" + nested + "}"), Names{});
    EXPECT_EQ(keep(flipbook, R"({"images": [{"file": "a.png", "more": )" + nested + "}]}"),
              Names{});
    EXPECT_EQ(flipbook, description({"height"}));
}

TEST_F(EarlierSheetsTest, NamesThatAreNoFileNamesAreIgnored) {
    std::filesystem::create_directory(folder_.path() / "sheets");
    write("stranger.png");
    Json flipbook = description({"height"});
    for (const std::string& name :
         {std::string("../stranger.png"), std::string("/"), std::string(400, 'a')}) {
        Json earlier = description({"albedo"});
        earlier["images"][0]["file"] = name;
        const EarlierSheets result =
            keep_earlier_sheets(flipbook, earlier.dump(), folder_.path() / "sheets");
        EXPECT_EQ(result.unlisted, Names{}) << name;
        EXPECT_EQ(result.replaced, Names{}) << name;
    }
    EXPECT_EQ(flipbook, description({"height"}));
}

}  // namespace
}  // namespace foam::texgen
