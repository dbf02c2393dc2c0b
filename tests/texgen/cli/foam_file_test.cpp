// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/foam_file.h"

#include "core/io/format_error.h"
#include "tests/texgen/temporary_folder.h"
#include "texgen/image/file_io.h"

#include <gtest/gtest.h>

#include <span>
#include <stdexcept>
#include <string>

namespace foam::texgen {
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

}  // namespace
}  // namespace foam::texgen
