// SPDX-License-Identifier: Apache-2.0

#include "core/io/foam_file.h"

#include "core/files/file_io.h"
#include "core/foam/honeycomb.h"
#include "core/io/format_error.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <span>
#include <stdexcept>
#include <string>

namespace foam {
namespace {

TEST(FoamFile, TheNameSelectsTheFormat) {
    for (const char* const name : {"a.fe", "b.dmp", "folder.x/c.json"}) {
        EXPECT_NO_THROW(check_foam_name(name)) << name;
    }
    for (const char* const name : {"a.png", "json", ".fe"}) {
        EXPECT_THROW(check_foam_name(name), std::invalid_argument) << name;
    }
}

TEST(FoamFile, ErrorsAreThoseOfTheFileAndOfItsContent) {
    const TemporaryFolder folder;
    EXPECT_THROW(load_foam(folder.path() / "none.fe"), InputError);
    const std::string text = "egg";
    write_file(folder.path() / "egg.json", std::as_bytes(std::span(text)));
    EXPECT_THROW(load_foam(folder.path() / "egg.json"), FormatError);
}

// Surface Evolver's format stores offsets of up to 15 periods.
TEST(FoamFile, AFoamThatTheFormatCannotStoreIsAnOutputError) {
    const TemporaryFolder folder;
    Foam foam = honeycomb(2, 2);
    foam.network.rebase(JunctionId{0}, {20, 0});
    EXPECT_THROW(save_foam(folder.path() / "a.fe", foam), OutputError);
}

}  // namespace
}  // namespace foam
