#include "texgen/stats/files.h"

#include "tests/texgen/stats/runs.h"
#include "tests/texgen/temporary_folder.h"
#include "texgen/image/file_io.h"
#include "texgen/stats/csv.h"

#include <gtest/gtest.h>

#include <cstring>

namespace foam::texgen {
namespace {

std::string text_of(const std::filesystem::path& path) {
    const Bytes bytes = read_file(path);
    std::string text(bytes.size(), '\0');
    std::memcpy(text.data(), bytes.data(), bytes.size());
    return text;
}

TEST(StatisticsFiles, AreWrittenIntoAFolderOfTheirOwn) {
    const TemporaryFolder folder;
    const RunRecord run = test::run_of({{0.0, 12}, {1.0, 11}});
    const auto files = write_statistics(run, folder.path() / "deep" / "stats");
    ASSERT_EQ(files.size(), 8U);
    EXPECT_EQ(files[0], folder.path() / "deep" / "stats" / "stats.csv");
    EXPECT_EQ(text_of(files[0]), frames_csv(run));
    EXPECT_EQ(text_of(files[1]), sides_csv(run));
    EXPECT_EQ(text_of(files[2]).substr(0, 4), "<svg");
    EXPECT_EQ(folder.files(),
              (std::vector<std::string>{"deep/stats/growth_rates.svg",
                                        "deep/stats/mean_area.svg",
                                        "deep/stats/pressures.svg",
                                        "deep/stats/second_moment.svg",
                                        "deep/stats/seconds.svg",
                                        "deep/stats/sides.csv",
                                        "deep/stats/sides.svg",
                                        "deep/stats/stats.csv"}));
}

TEST(StatisticsFiles, AFolderThatCannotBeMadeIsAnOutputError) {
    EXPECT_THROW(write_statistics({}, "/proc/self/none"), OutputError);
}

}  // namespace
}  // namespace foam::texgen
