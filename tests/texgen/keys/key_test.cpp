// SPDX-License-Identifier: Apache-2.0

#include "texgen/keys/key.h"

#include "texgen/keys/value_kinds.h"

#include <gtest/gtest.h>

#include <functional>
#include <span>
#include <string>

namespace foam::texgen {
namespace {

struct Lamp {
    int power = 40;
    std::string color = "red";
    std::vector<int> hours{};
};

struct Room {
    double height = 2.5;
    Lamp lamp;
};

Keys<Lamp> lamp_keys() {
    return {
        key("power", Integers{1, 100}, "of the lamp, watts", &Lamp::power).in("watts"),
        key("color", Text{}, "of its light", &Lamp::color).only_for("room.kind", {"bar", "club"}),
        key("hours", IntegerLists{{0, 23}}, "in which it is on", &Lamp::hours)};
}

TEST(Key, ReadsAndWritesItsMember) {
    const Key<Lamp> power = lamp_keys()[0];
    Lamp lamp;
    EXPECT_TRUE(power.read({std::int64_t{60}}, lamp));
    EXPECT_EQ(lamp.power, 60);
    EXPECT_FALSE(power.read({std::int64_t{101}}, lamp));
    EXPECT_EQ(lamp.power, 60);
    EXPECT_EQ(power.write(lamp), Value{std::int64_t{60}});
}

TEST(Key, HasADefault) {
    const Keys<Lamp> keys = lamp_keys();
    EXPECT_EQ(keys[0].default_value, Value{std::int64_t{40}});
    EXPECT_FALSE(keys[2].default_value.has_value());
    EXPECT_TRUE(keys[0].is_default({}));
    EXPECT_FALSE(keys[0].is_default({.power = 41}));
    EXPECT_TRUE(keys[2].is_default({}));
    EXPECT_FALSE(keys[2].is_default({.hours = {7}}));
}

TEST(Key, AConditionListsTheValuesOfAnotherKey) {
    const Key<Lamp> color = lamp_keys()[1];
    ASSERT_TRUE(color.condition.has_value());
    EXPECT_EQ(color.condition->key, "room.kind");
    EXPECT_TRUE(color.condition->allows("club"));
    EXPECT_FALSE(color.condition->allows("office"));
    const Condition files{"room.plan", {"*.png"}};
    EXPECT_TRUE(files.allows("plan.png"));
    EXPECT_FALSE(files.allows("plan.exr"));
}

TEST(Key, AConditionMayExcludeValues) {
    const Key<Lamp> used = lamp_keys()[0].used_with("room.kind", {"club", "bar"});
    EXPECT_TRUE(used.use->allows("bar"));
    EXPECT_FALSE(used.use->allows("office"));
    EXPECT_EQ(text_of(*used.use), "room.kind = \"club\" or \"bar\"");
    const Key<Lamp> unused = lamp_keys()[0].unused_with("room.windows", {"0", "1"});
    EXPECT_TRUE(unused.use->allows("2"));
    EXPECT_FALSE(unused.use->allows("1"));
    EXPECT_EQ(text_of(*unused.use), "room.windows = 0 or 1");
}

TEST(Key, HasAUnitOnlyIfItIsGiven) {
    EXPECT_EQ(lamp_keys()[0].unit, "watts");
    EXPECT_EQ(lamp_keys()[2].unit, "");
    EXPECT_EQ(lamp_keys()[0].below("largest").only_for("kind", {"bar"}).unit, "watts");
}

TEST(Key, OfAMemberHasAPathInItsTable) {
    Keys<Lamp> keys = lamp_keys();
    keys[0] = keys[0].below("largest");
    const Keys<Room> of_room = nested_keys("lamp", &Room::lamp, keys);
    EXPECT_EQ(of_room[0].path, "lamp.power");
    EXPECT_EQ(of_room[0].table(), "lamp");
    EXPECT_EQ(of_room[0].name(), "power");
    EXPECT_EQ(of_room[0].upper_limit, "lamp.largest");
    EXPECT_EQ(of_room[0].unit, "watts");
    EXPECT_EQ(of_room[1].condition->key, "room.kind");
    Room room;
    EXPECT_TRUE(of_room[0].read({std::int64_t{7}}, room));
    EXPECT_EQ(room.lamp.power, 7);
    EXPECT_EQ(of_room[0].write(room), Value{std::int64_t{7}});
    EXPECT_EQ(nested_keys("", &Room::lamp, keys)[0].path, "power");
}

TEST(Key, OfABaseIsAKeyOfTheDerivedType) {
    struct Lantern : Lamp {};
    const Keys<Lantern> keys = make_nested_keys<Lantern>("", std::identity(), lamp_keys());
    Lantern lantern;
    EXPECT_TRUE(keys[0].read({std::int64_t{5}}, lantern));
    EXPECT_EQ(lantern.power, 5);
}

TEST(Key, MayBeOfAWholeObject) {
    const Key<Lamp> power = make_key<Lamp>(
        "power", Integers{1, 9}, "", [](auto& lamp) -> auto& { return lamp.power; });
    Lamp lamp;
    EXPECT_TRUE(power.read({std::int64_t{5}}, lamp));
    EXPECT_EQ(lamp.power, 5);
}

TEST(Key, IsDescribedByDefaultMeaningAndAllowedValues) {
    const Keys<Lamp> keys = lamp_keys();
    EXPECT_EQ(describe(keys[0]),
              "power = 40\n    of the lamp, watts\n    an integer from 1 to 100\n");
    EXPECT_EQ(
        describe(keys[2]),
        "hours\n    in which it is on\n    an integer from 0 to 23, or a list of such values\n");
}

TEST(Key, IsFoundByItsPath) {
    const Keys<Room> keys = joined({Keys<Room>{key("height", Reals{0.0, 9.0}, "", &Room::height)},
                                    nested_keys("lamp", &Room::lamp, lamp_keys())});
    const std::span<const Key<Room>> all = keys;
    EXPECT_EQ(find_key(all, "lamp.color"), &keys[2]);
    EXPECT_EQ(find_key(all, "color"), nullptr);
}

}  // namespace
}  // namespace foam::texgen
