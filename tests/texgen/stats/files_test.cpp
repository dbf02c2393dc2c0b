// SPDX-License-Identifier: Apache-2.0

#include "texgen/stats/files.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"
#include "tests/texgen/stats/runs.h"
#include "texgen/image/external_program.h"
#include "texgen/stats/csv.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>

namespace foam::texgen {
namespace {

std::string text_of(const std::filesystem::path& path) {
    const Bytes bytes = read_file(path, kImageInput);
    std::string text(bytes.size(), '\0');
    std::memcpy(text.data(), bytes.data(), bytes.size());
    return text;
}

TEST(StatisticsFiles, AreWrittenIntoAFolderOfTheirOwn) {
    const TemporaryFolder folder;
    const RunRecord run = test::run_of({{0.0, 12}, {1.0, 11}});
    const std::filesystem::path to = folder.path() / "deep" / "stats";
    const StatisticsFiles files = write_statistics(run, to);
    ASSERT_GE(files.paths.size(), 6U);
    EXPECT_EQ(files.paths[0], to / "stats.csv");
    EXPECT_EQ(text_of(files.paths[0]), frames_csv(run));
    EXPECT_EQ(files.paths[1], to / "sides.csv");
    EXPECT_EQ(text_of(files.paths[1]), sides_csv(run));
    EXPECT_EQ(files.paths[2], to / "stress.csv");
    EXPECT_EQ(text_of(files.paths[2]), stress_csv(run));
    EXPECT_EQ(files.paths[3], to / "bubbles.csv");
    EXPECT_EQ(text_of(files.paths[3]), bubbles_csv(run));
    EXPECT_EQ(files.paths[4], to / "events.csv");
    EXPECT_EQ(text_of(files.paths[4]), events_csv(run));
    EXPECT_EQ(files.paths[5], to / "charts.gp");
    EXPECT_EQ(text_of(files.paths[5]), charts_script(run));
    EXPECT_EQ(files.charts == ChartStatus::NoGnuplot, !run_external({"gnuplot", "--version"}));
    EXPECT_EQ(folder.files().size(), files.paths.size());
}

TEST(StatisticsFiles, ATableOfMazesExistsOnlyIfThereIsAMaze) {
    const TemporaryFolder folder;
    RunRecord run = test::run_of({{0.0, 12}});
    run.frames[0].maze = {3, 2, 1};
    write_statistics(run, folder.path());
    EXPECT_EQ(text_of(folder.path() / "maze.csv"), maze_csv(run));
    run.frames[0].maze.reset();
    write_statistics(run, folder.path());
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "maze.csv"));
}

TEST(StatisticsFiles, ChartsOfAnEarlierRunAreRemoved) {
    const TemporaryFolder folder;
    write_file(folder.path() / "sides.svg", {});
    write_statistics({}, folder.path());
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "sides.svg"));
}

TEST(StatisticsFiles, AFolderThatCannotBeMadeIsAnOutputError) {
    EXPECT_THROW(write_statistics({}, "/proc/self/none"), OutputError);
}

// A folder that is not empty cannot be removed as a file is.
TEST(StatisticsFiles, AChartThatCannotBeRemovedIsAnOutputError) {
    const TemporaryFolder folder;
    make_folders(folder.path() / "sides.svg" / "deep");
    EXPECT_THROW(write_statistics({}, folder.path()), OutputError);
}

}  // namespace
}  // namespace foam::texgen
