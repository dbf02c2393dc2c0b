// SPDX-License-Identifier: Apache-2.0

#include "core/files/file_io.h"
#include "tests/texgen/manifest/small_set.h"
#include "texgen/manifest/manifest_json.h"

#include <gtest/gtest.h>

#include <string>

namespace foam::texgen {
namespace {

/// Replaces a part of the text of a manifest. Returns the message of the InputError that parsing it
/// throws, or an empty string.
std::string error_of(const std::string& part, const std::string& by) {
    std::string text = to_json(small_manifest());
    const std::size_t position = text.find(part);
    EXPECT_NE(position, std::string::npos) << part;
    text.replace(position, part.size(), by);
    try {
        parse_manifest(text, "m.json");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(ManifestReader, ErrorNamesFilePathAndAllowedValues) {
    EXPECT_EQ(error_of("\"frame\":3", "\"frame\":\"three\""),
              "cannot read 'm.json': sets[0].files[1].frame = \"three\": "
              "must be an integer from 0 to 2147483647");
    EXPECT_EQ(error_of("\"version\": 1", "\"version\": 2"),
              "cannot read 'm.json': version = 2: must be an integer from 1 to 1");
    EXPECT_EQ(error_of("\"kind\":\"number\"", "\"kind\":\"egg\""),
              "cannot read 'm.json': sets[0].maps[0].kind = \"egg\": "
              "must be one of \"color\", \"number\", \"id\"");
    EXPECT_EQ(error_of("\"frames\":\"1-3,5\"", "\"frames\":\"x\""),
              "cannot read 'm.json': sets[0].maps[0].frames = \"x\": "
              "must be a frame range such as 1-10 or 1-10x2");
    EXPECT_EQ(error_of("[\"height\"]", "[\"egg\"]"),
              "cannot read 'm.json': sets[0].files[0].maps = [\"egg\"]: "
              "must be names of maps that are listed in 'maps'");
    EXPECT_EQ(error_of("\"seed\": 12", "\"seed\": 18446744073709551615"),
              "cannot read 'm.json': sets[0].seed = 18446744073709551615: "
              "must be an integer from 0 to 9223372036854775807");
    EXPECT_EQ(error_of("[64,32]", "[64]"),
              "cannot read 'm.json': sets[0].size = [64]: must be [width, height]");
    EXPECT_EQ(error_of("[1.0,-0.125,0.75]", "[1.0,0.75]"),
              "cannot read 'm.json': sets[0].foam[0].stress = [1.0,0.75]: must be [xx, xy, yy]");
}

// A manifest of another person must not make a program read files outside of its folder.
TEST(ManifestReader, FilesAreInsideTheFolder) {
    const std::string path = "\"a_height.1.png\"";
    EXPECT_EQ(error_of(path, "\"../a.png\""),
              "cannot read 'm.json': sets[0].files[0].path = \"../a.png\": "
              "must be a path inside the folder of the manifest: relative and without '..'");
    for (const char* outside : {"\"/a.png\"", "\"b/../../a.png\"", "\"b/..\"", "\"\""}) {
        EXPECT_NE(error_of(path, outside), "") << outside;
    }
    for (const char* inside : {"\"b/a.png\"", "\"..a.png\"", "\"./a..png\""}) {
        EXPECT_EQ(error_of(path, inside), "") << inside;
    }
}

TEST(ManifestReader, SceneFilesAreInsideTheFolder) {
    EXPECT_EQ(error_of("\"a.usda\"", "\"../a.usda\""),
              "cannot read 'm.json': sets[0].scenes[0].path = \"../a.usda\": "
              "must be a path inside the folder of the manifest: relative and without '..'");
}

// The names become parts of the names of sheets and previews.
TEST(ManifestReader, NamesArePlain) {
    EXPECT_EQ(
        error_of("\"preset\": \"a\"", "\"preset\": \"../../evil\""),
        "cannot read 'm.json': sets[0].preset = \"../../evil\": must be a plain name, without "
        "'/' and control characters and not beginning with '.'");
    for (const char* name : {"..", ".", "", "/tmp/a", "a/b", "a\\u001b[31m", "a\\u202e"}) {
        EXPECT_NE(error_of("\"preset\": \"a\"", std::string("\"preset\": \"") + name + "\""), "")
            << name;
        EXPECT_NE(error_of("\"name\":\"height\"", std::string("\"name\":\"") + name + "\""), "")
            << name;
    }
}

TEST(ManifestReader, RejectsFilesThatAreNoManifest) {
    EXPECT_NE(error_of("\"pixels\":", "\"pixel\":").find("an object with the key 'pixels'"),
              std::string::npos);
    EXPECT_THROW(parse_manifest("", "m.json"), InputError);
    EXPECT_THROW(parse_manifest("{", "m.json"), InputError);
    EXPECT_THROW(parse_manifest("[]", "m.json"), InputError);
    EXPECT_THROW(parse_manifest("{\"format\": 3}", "m.json"), InputError);
    EXPECT_THROW(parse_manifest("{\"name\": \"a web app\"}", "m.json"), InputError);
}

}  // namespace
}  // namespace foam::texgen
