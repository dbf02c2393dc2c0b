// SPDX-License-Identifier: Apache-2.0

// Tests files with errors of every kind. Each is read as a valid foam, or rejected with a message
// of one line.
#include "core/foam/random.h"
#include "core/io/evolver_file.h"
#include "core/io/foam_json.h"
#include "core/io/format_error.h"
#include "tests/core/foams.h"
#include "tests/core/io/data_file.h"
#include "tests/core/io/small_torus.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>

namespace foam {
namespace {

using Read = std::function<Foam(const std::string&)>;

Foam read_fe(const std::string& text) {
    return read_evolver(text, "a").foam;
}

Foam read_json(const std::string& text) {
    return read_foam_json(text, "a");
}

// Returns true if the text was read, and expects that the foam is valid. Otherwise expects a
// FormatError whose message is one line.
bool survives(const Read& read, const std::string& text) {
    try {
        EXPECT_TRUE(test::is_valid(read(text).network));
        return true;
    } catch (const FormatError& error) {
        const std::string what = error.what();
        EXPECT_EQ(what.rfind("a:" + std::to_string(error.line()) + ": ", 0), 0U) << what;
        EXPECT_EQ(what.find('\n'), std::string::npos) << what;
        EXPECT_GE(error.line(), 1);
        return false;
    }
}

// Replaces, erases, inserts or repeats characters at a random position of the text.
void damage(std::string& text, Random& random) {
    static constexpr std::array<const char*, 12> kInsertions{" -1e308 ",
                                                             " 1e999 ",
                                                             "*",
                                                             " 9999999999 ",
                                                             "/*",
                                                             "-",
                                                             "0",
                                                             "[",
                                                             "\"",
                                                             "\\\n",
                                                             "\nread ",
                                                             "."};
    const std::size_t at = random.below(text.size());
    switch (random.below(4)) {
        case 0:
            text[at] = static_cast<char>(random.below(256));
            break;
        case 1:
            text.erase(at, 1 + random.below(20));
            break;
        case 2:
            text.insert(at, kInsertions[random.below(kInsertions.size())]);
            break;
        default:
            text.insert(at, text.substr(random.below(text.size()), random.below(100)));
    }
}

void try_damages(const Read& read, const std::string& text, int tries) {
    Random random(7);
    ASSERT_TRUE(survives(read, text));
    for (int k = 0; k < tries; ++k) {
        std::string damaged = text;
        for (std::size_t n = 0; n <= random.below(3); ++n) {
            damage(damaged, random);
        }
        survives(read, damaged);
    }
}

TEST(DamagedFile, EveryTruncationIsAnError) {
    const std::string fe = test::data_file("evolver/torus64.dmp");
    // A file in which only the last volume is missing is not an error.
    const std::size_t last_body_but_one = fe.find("\n 63       63  volume");
    for (std::size_t size = 0; size < last_body_but_one; size += 97) {
        EXPECT_FALSE(survives(read_fe, fe.substr(0, size))) << size;
    }
    const std::string json = write_foam_json(read_fe(fe));
    for (std::size_t size = 0; size + 2 < json.size(); size += 97) {
        EXPECT_FALSE(survives(read_json, json.substr(0, size))) << size;
    }
}

TEST(DamagedFile, EvolverFilesAreReadOrRejected) {
    try_damages(read_fe, test::data_file("evolver/torus64.fe"), 1000);
    try_damages(read_fe, test::data_file("evolver/torus64.dmp"), 1000);
    try_damages(read_fe, test::kSmallTorus, 5000);
}

TEST(DamagedFile, StatesAreReadOrRejected) {
    try_damages(read_json, write_foam_json(read_fe(test::kSmallTorus)), 5000);
    try_damages(read_json, write_foam_json(test::raw_foam(12, 1)), 3000);
}

}  // namespace
}  // namespace foam
