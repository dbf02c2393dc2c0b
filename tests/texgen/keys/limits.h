// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/preset/assignment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

namespace foam::texgen::test {

/// The limits of a key. The key must accept the values `low` and `high`, and reject the values
/// `below` and `above`. All values are in TOML.
struct Limits {
    std::string key;
    std::string below;
    std::string low;
    std::string high;
    std::string above;
};

/// Returns true if the key with this name accepts a value in TOML.
template <class Owner>
bool accepts(std::span<const Key<Owner>> keys, const std::string& name, const std::string& value) {
    const Key<Owner>* key = find_key(keys, name);
    Owner owner{};
    return key != nullptr && key->read(read_value(value), owner);
}

// Expects that each key accepts and rejects the values of its limits.
template <class Owner>
void expect_limits(std::span<const Key<Owner>> keys, const std::vector<Limits>& all) {
    for (const Limits& limits : all) {
        EXPECT_FALSE(accepts(keys, limits.key, limits.below)) << limits.key;
        EXPECT_TRUE(accepts(keys, limits.key, limits.low)) << limits.key;
        EXPECT_TRUE(accepts(keys, limits.key, limits.high)) << limits.key;
        EXPECT_FALSE(accepts(keys, limits.key, limits.above)) << limits.key;
    }
}

template <class Owner>
void expect_limits(const Keys<Owner>& keys, const std::vector<Limits>& all) {
    expect_limits(std::span<const Key<Owner>>(keys), all);
}

/// Expects that the words of a key are the given ones, in any order, that the key writes each of
/// them unchanged, and that it rejects another word.
template <class Owner>
void expect_words(const Keys<Owner>& keys,
                  const std::string& name,
                  const std::vector<std::string>& words) {
    const Key<Owner>* key = find_key(std::span<const Key<Owner>>(keys), name);
    ASSERT_NE(key, nullptr) << name;
    EXPECT_TRUE(
        std::is_permutation(words.begin(), words.end(), key->words.begin(), key->words.end()))
        << name;
    Owner owner{};
    for (const std::string& word : words) {
        EXPECT_TRUE(key->read({word}, owner)) << name << " = " << word;
        EXPECT_EQ(key->write(owner), Value{word}) << name;
    }
    EXPECT_FALSE(key->read({std::string("beer")}, owner)) << name;
}

}  // namespace foam::texgen::test
