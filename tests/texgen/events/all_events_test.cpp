// SPDX-License-Identifier: Apache-2.0

#include "texgen/events/all_events.h"

#include "tests/support/readme_table.h"
#include "texgen/preset/assignment.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace foam::texgen {
namespace {

TEST(AllEvents, AKindIsFoundByItsName) {
    for (const EventKind& kind : kEventKinds) {
        EXPECT_EQ(&find_event_kind(kind.name), &kind);
    }
}

TEST(AllEvents, EveryKeyIsListedOnceWithItsTexts) {
    std::set<std::string> names;
    for (const Key<Event>& key : event_keys()) {
        EXPECT_TRUE(names.insert(key.path).second) << key.path;
        EXPECT_FALSE(key.meaning.empty()) << key.path;
        EXPECT_FALSE(key.allowed.empty()) << key.path;
        EXPECT_TRUE(key.is_default(Event{})) << key.path;
        EXPECT_FALSE(kinds_of(key).empty()) << key.path;
    }
}

TEST(AllEvents, AKindTakesItsOwnKeysAndThoseItShares) {
    EXPECT_EQ(keys_of("collapse"), "kind, frame, frames, time, bubble, at, sides, count, order");
    EXPECT_EQ(keys_of("shear"), "kind, frame, frames, time, strain");
    EXPECT_EQ(kinds_of(*find_key(event_keys(), "strain")), "shear");
    EXPECT_EQ(kinds_of(*find_key(event_keys(), "order")), "collapse");
}

TEST(AllEvents, AKindIsOneOfTheNames) {
    const Key<Event>* kind = find_key(event_keys(), "kind");
    Event event;
    EXPECT_FALSE(kind->write(event).has_value());
    EXPECT_FALSE(kind->read(read_value("explode"), event));
    EXPECT_TRUE(event.kind.empty());
    EXPECT_TRUE(kind->read(read_value("force"), event));
    EXPECT_EQ(event.kind, "force");
}

TEST(AllEvents, TheReadmeHasTheTableOfKinds) {
    foam::test::expect_in_readme("texgen/events", describe_event_kinds_in_markdown());
}

}  // namespace
}  // namespace foam::texgen
