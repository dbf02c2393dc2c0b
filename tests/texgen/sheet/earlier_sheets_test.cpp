// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/earlier_sheets.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <span>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

using Names = std::vector<std::string>;

class EarlierSheets : public testing::Test {
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

    Names keep(Json& flipbook) const { return keep_earlier_sheets(flipbook, file_); }

    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_.path() / "sheet.json";
};

TEST_F(EarlierSheets, SheetsOfOtherMapsAreKeptIfTheyExist) {
    write("sheet.json", description({"albedo", "height", "normal"}).dump());
    write("albedo.png");
    write("height.png");
    Json flipbook = description({"height", "film"});
    EXPECT_EQ(keep(flipbook), Names{});
    EXPECT_EQ(maps_of(flipbook), (Names{"height", "film", "albedo"}));
}

TEST_F(EarlierSheets, SheetsOfOtherFramesAreReported) {
    write("sheet.json", description({"albedo", "height", "normal"}).dump());
    write("albedo.png");
    write("height.png");
    Json flipbook = description({"height"});
    flipbook["frames"] = 8;
    EXPECT_EQ(keep(flipbook), Names{"albedo.png"});
    EXPECT_EQ(maps_of(flipbook), Names{"height"});
}

TEST_F(EarlierSheets, OtherFilesAreIgnored) {
    Json flipbook = description({"height"});
    for (const char* const text : {"", "{", "[1]", "{}", R"({"images": [7, {"file": 1}]})"}) {
        write("sheet.json", text);
        EXPECT_EQ(keep(flipbook), Names{}) << text;
    }
    std::filesystem::remove(file_);
    EXPECT_EQ(keep(flipbook), Names{});
    EXPECT_EQ(flipbook, description({"height"}));
}

}  // namespace
}  // namespace foam::texgen
