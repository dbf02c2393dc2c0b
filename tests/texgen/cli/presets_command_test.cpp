#include "tests/support/places.h"
#include "tests/texgen/cli/run_program.h"
#include "texgen/image/external_program.h"
#include "texgen/maps/map.h"
#include "texgen/preset/preset_keys.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

TEST(PresetsCommand, APresetThatIsShownCanBeBaked) {
    const Outcome outcome =
        run_program("presets show labyrinth > mine.toml && '" + foam::test::executable().string() +
                    "' bake mine.toml --set foam.bubbles=16 --frames 1 --size 8 --out a.png");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.written, (std::vector<std::string>{"a.png", "manifest.json", "mine.toml"}));
}

TEST(PresetsCommand, ListsPresetsAndKeys) {
    const std::string list = run_program("presets").out;
    EXPECT_EQ(list.find("sea_foam    "), 0U);
    EXPECT_EQ(run_program("presets list").out, list);
    EXPECT_NE(run_program("presets keys").out.find("\nbubbles = 1000\n"), std::string::npos);
}

}  // namespace
}  // namespace foam::texgen
