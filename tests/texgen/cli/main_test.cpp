#include "tests/support/places.h"
#include "tests/texgen/cli/run_program.h"
#include "texgen/maps/map.h"
#include "texgen/preset/schema.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

/// In an empty folder.
Outcome run(const std::string& arguments) {
    return run_program(arguments);
}

/// One line on stderr, nothing on stdout, no file.
void expect_refused(const std::string& arguments, const std::string& line) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, static_cast<int>(ExitCode::BadRequest)) << arguments;
    EXPECT_EQ(outcome.err, "foamtex: " + line + "\n");
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_TRUE(outcome.written.empty()) << arguments;
}

TEST(Main, HelpFitsOneScreenAndNamesTheExitCodes) {
    for (const char* arguments : {"--help", "bake --help", "stats --help"}) {
        const Outcome help = run(arguments);
        EXPECT_EQ(help.code, 0);
        EXPECT_LE(std::count(help.out.begin(), help.out.end(), '\n'), 30) << arguments;
        EXPECT_NE(help.out.find("Examples:"), std::string::npos) << arguments;
    }
    EXPECT_NE(run("--help").out.find("3 the foam could not be brought to equilibrium"),
              std::string::npos);
}

TEST(Main, SaysItsVersion) {
    EXPECT_EQ(run("--version").out, "foamtex " FOAMTEX_VERSION "\n");
}

TEST(Main, ABadCommandLineIsOneLineAndCode2) {
    expect_refused("", "A subcommand is required (see foamtex --help)");
    expect_refused("bake", "PRESET is required (see foamtex --help)");
    expect_refused("bake sea_foam --bogus",
                   "The following argument was not expected: --bogus (see foamtex --help)");
    expect_refused("bake sea_foam --threads -1",
                   "--threads: Value -1 not in range 0 to 1024 (see foamtex --help)");
    expect_refused("bake sea_foam -q -v", "--quiet excludes --verbose (see foamtex --help)");
}

TEST(Main, ListsEveryMap) {
    const Outcome list = run("maps");
    EXPECT_EQ(list.code, 0);
    EXPECT_EQ(static_cast<std::size_t>(std::count(list.out.begin(), list.out.end(), '\n')),
              all_maps().size());
    for (const Map& map : all_maps()) {
        EXPECT_NE(list.out.find(std::string(map.name) + " "), std::string::npos);
        EXPECT_NE(list.out.find(map.meaning), std::string::npos);
    }
    EXPECT_EQ(run("maps --markdown").out, describe_maps_in_markdown());
}

TEST(Main, ABadPresetIsOneLineAndCode2) {
    expect_refused("bake none.toml", "cannot read 'none.toml': No such file or directory");
    expect_refused("bake marzipan",
                   "preset 'marzipan': must be a .toml file or a name; 'foamtex presets' lists all "
                   "there are");
    expect_refused("bake sea_foam --set foam.bubbles=-3",
                   "--set foam.bubbles=-3: key 'foam.bubbles' = -3: "
                   "must be an integer from 4 to 1000000");
    expect_refused("bake sea_foam --set foam.bubbles",
                   "--set foam.bubbles: must be KEY=VALUE, as in --set foam.bubbles=500");
}

TEST(Main, ABadOptionIsOneLineAndCode2) {
    expect_refused("bake sea_foam --size 0x4",
                   "--size 0x4: key 'image.size' = [0, 4]: "
                   "must be [width, height], each an integer from 1 to 16384");
    expect_refused("bake sea_foam --seed -1",
                   "--seed -1: key 'foam.seed' = -1: "
                   "must be an integer from 0 to 9223372036854775807");
    expect_refused("bake sea_foam --maps albedo,beer",
                   "--maps albedo,beer: key 'image.maps' = [\"albedo\", \"beer\"]: must be " +
                       find_key("image.maps")->allowed);
    expect_refused("bake sea_foam --frames 3-",
                   "frame range '3-': must be written as 5, 1-10, 1-10x2 or 1-10y3, "
                   "with commas between");
    expect_refused("bake sea_foam --out a.png",
                   "output pattern 'a.png': must contain ####, @@@@ or %04d, "
                   "to tell 48 frames apart");
}

TEST(Main, BakesTheFramesAskedFor) {
    const Outcome outcome =
        run("bake sea_foam --set foam.bubbles=16 --frames 3-1x2 --size 16x8 --threads 1");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");  // no bar: stderr is no terminal
    EXPECT_EQ(outcome.out, "out/sea_foam_albedo.####.png 3,1\n");
    EXPECT_EQ(
        outcome.written,
        (std::vector<std::string>{
            "out/manifest.json", "out/sea_foam_albedo.0001.png", "out/sea_foam_albedo.0003.png"}));
}

TEST(Main, BakesAndMeasuresAPatch) {
    const std::string patch =
        " soap_raft --set foam.bubbles=16 --set foam.outline='POLYGON((0 0, 3 0, 3 1, 0 1))'"
        " --set camera.zoom=2 --frames 1-2 --size 24x16";
    const Outcome baked = run("bake" + patch);
    EXPECT_EQ(baked.code, 0) << baked.err;
    EXPECT_EQ(baked.written.size(), 2U + 1U);
    const Outcome measured = run("stats" + patch);
    EXPECT_EQ(measured.code, 0) << measured.err;
    EXPECT_EQ(measured.written.size(), 8U);
    expect_refused("bake soap_raft --set foam.outline=egg",
                   "--set foam.outline=egg: key 'foam.outline' = \"egg\": must be \"disc\", "
                   "\"rectangle\", or a polygon that does not cross itself as WKT, "
                   "\"POLYGON((x y, ...), (x y of a hole, ...))\"");
}

TEST(Main, QuietSaysNothingAndVerboseALinePerFrame) {
    const std::string small = "bake sea_foam --set foam.bubbles=16 --frames 1 --size 8 --out a.png";
    const Outcome quiet = run(small + " -q");
    EXPECT_EQ(quiet.code, 0);
    EXPECT_EQ(quiet.out + quiet.err, "");
    const Outcome verbose = run(small + " -v");
    EXPECT_EQ(verbose.out, "a.png\n");
    EXPECT_EQ(verbose.err.find("frame 1: "), 0U);
    EXPECT_EQ(std::count(verbose.err.begin(), verbose.err.end(), '\n'), 1);
}

TEST(Main, StatsWritesTablesAndCharts) {
    const Outcome outcome = run("stats sea_foam --set foam.bubbles=16 --frames 1-3 --seed 5");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const std::string folder = "out/sea_foam_stats/";
    std::string listed;
    for (const char* name : {"stats.csv",
                             "sides.csv",
                             "mean_area.svg",
                             "second_moment.svg",
                             "sides.svg",
                             "pressures.svg",
                             "growth_rates.svg",
                             "seconds.svg"}) {
        listed += folder;
        listed += name;
        listed += '\n';
        EXPECT_EQ(std::count(outcome.written.begin(), outcome.written.end(), folder + name), 1)
            << name;
    }
    EXPECT_EQ(outcome.out, listed);
    EXPECT_EQ(outcome.written.size(), 8U);
}

TEST(Main, StatsTakesTheOptionsOfABakeAndAFolder) {
    const std::string small = "stats labyrinth --set foam.bubbles=16 --size 32x16 --frames 2,1 ";
    const Outcome verbose = run(small + "--threads 1 -v");
    EXPECT_EQ(verbose.code, 0) << verbose.err;
    EXPECT_EQ(verbose.err.find("frame 1: 16 bubbles, "), 0U);
    EXPECT_EQ(std::count(verbose.err.begin(), verbose.err.end(), '\n'), 2);
    const Outcome moved = run(small + "-q --out numbers && head -2 numbers/stats.csv");
    EXPECT_EQ(moved.out.find("frame,time,bubbles,mean_area,"), 0U);
    EXPECT_NE(moved.out.find(",seconds\n1,"), std::string::npos);
    EXPECT_EQ(run(small + "-q").out, "");
    expect_refused("stats sea_foam --maps albedo",
                   "The following arguments were not expected: albedo --maps (see foamtex --help)");
    EXPECT_EQ(run(small + "--out /proc/self/none").code, static_cast<int>(ExitCode::OutputFailed));
}

TEST(Main, ABakeWritesItsStatisticsBesideTheImages) {
    const Outcome outcome =
        run("bake sea_foam --set foam.bubbles=16 --frames 1-2 --size 8 --out a/####.png --stats");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out.find("a/####.png 1-2\na/sea_foam_stats/stats.csv\n"), 0U);
    EXPECT_EQ(outcome.written.size(), 2U + 1U + 8U);
    EXPECT_EQ(outcome.written.back(), "a/sea_foam_stats/stats.csv");
}

TEST(Main, AnOutputThatCannotBeWrittenIsCode5) {
    const Outcome outcome =
        run("bake sea_foam --set foam.bubbles=16 --frames 1 --size 8 --out /proc/self/none.png");
    EXPECT_EQ(outcome.code, static_cast<int>(ExitCode::OutputFailed));
    EXPECT_EQ(outcome.err,
              "foamtex: cannot write '/proc/self/manifest.json.lock': No such file or directory\n");
    EXPECT_EQ(run("presets list >/dev/full 2>/dev/null #").code,
              static_cast<int>(ExitCode::OutputFailed));
}

TEST(Main, APresetThatIsShownCanBeBaked) {
    const Outcome outcome =
        run("presets show labyrinth > mine.toml && '" + foam::test::executable().string() +
            "' bake mine.toml --set foam.bubbles=16 --frames 1 --size 8 --out a.png");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.written, (std::vector<std::string>{"a.png", "manifest.json", "mine.toml"}));
}

TEST(Main, ListsPresetsAndKeys) {
    const std::string list = run("presets").out;
    EXPECT_EQ(list.find("sea_foam    "), 0U);
    EXPECT_EQ(run("presets list").out, list);
    EXPECT_NE(run("presets keys").out.find("\nbubbles = 1000\n"), std::string::npos);
}

}  // namespace
}  // namespace foam::texgen
