// SPDX-License-Identifier: Apache-2.0

#include "texgen/events/chosen_bubbles.h"

#include "core/foam/locate.h"

#include <optional>

namespace foam::texgen {

namespace {

ChosenBubble chosen(const Foam& foam, BubbleId bubble) {
    return {foam.identities[bubble], foam.target_areas[bubble]};
}

std::vector<ChosenBubble> all_bubbles(const Foam& foam) {
    std::vector<ChosenBubble> all;
    for (const BubbleId bubble : foam.network.bubbles()) {
        all.push_back(chosen(foam, bubble));
    }
    for (const LoneBubble& bubble : foam.lone_bubbles) {
        all.push_back({bubble.identity, bubble.target_area});
    }
    return all;
}

std::optional<ChosenBubble> choose_identity(const Foam& foam, BubbleIdentity identity) {
    if (const auto bubble = find_bubble(foam, identity)) {
        return chosen(foam, *bubble);
    }
    for (const LoneBubble& bubble : foam.lone_bubbles) {
        if (bubble.identity == identity) {
            return ChosenBubble{identity, bubble.target_area};
        }
    }
    return std::nullopt;
}

// Chooses the bubbles with the smallest target areas among those with given numbers of sides. The
// numbers take turns, beginning with the one at index `turn`; a number without further bubbles is
// skipped.
std::vector<ChosenBubble> choose_by_sides(const std::vector<int>& numbers,
                                          const Foam& foam,
                                          std::size_t turn,
                                          std::size_t count) {
    std::vector<std::vector<BubbleId>> found;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        found.push_back(bubbles_of_sides(foam, numbers[(turn + k) % numbers.size()]));
    }
    std::vector<ChosenBubble> all;
    for (std::size_t rank = 0; rank < foam.network.bubble_count(); ++rank) {
        for (const std::vector<BubbleId>& of_number : found) {
            if (rank < of_number.size() && all.size() < count) {
                all.push_back(chosen(foam, of_number[rank]));
            }
        }
    }
    return all;
}

std::vector<ChosenBubble> choose_by_identity(const std::vector<BubbleIdentity>& bubbles,
                                             const Foam& foam,
                                             std::size_t turn,
                                             std::size_t count) {
    std::vector<ChosenBubble> all;
    for (std::size_t k = turn; k < turn + count; ++k) {
        if (const auto one = choose_identity(foam, bubbles[k])) {
            all.push_back(*one);
        }
    }
    return all;
}

}  // namespace

std::vector<ChosenBubble> choose_bubbles(const EventBase& event,
                                         const EventStage& stage,
                                         std::size_t turn,
                                         std::size_t count) {
    const Foam& foam = stage.foam;
    if (count == 0) {
        return all_bubbles(foam);
    }
    if (!event.sides.empty()) {
        return choose_by_sides(event.sides, foam, turn, count);
    }
    if (!event.at) {
        return choose_by_identity(event.bubbles, foam, turn, count);
    }
    const auto found = identity_at(foam, stage.point_at(*event.at));
    return found ? std::vector{*choose_identity(foam, *found)} : std::vector<ChosenBubble>{};
}

void check_choice(const EventCheck& check, bool may_choose_all) {
    const EventBase& event = check.event;
    const int given_count =
        (event.bubbles.empty() ? 0 : 1) + (event.at ? 1 : 0) + (event.sides.empty() ? 0 : 1);
    check.require(given_count <= 1,
                  event.sides.empty() ? "at" : "sides",
                  "only one of bubble, at and sides may be given");
    check.require(may_choose_all || given_count == 1,
                  "kind",
                  "the event must have one of the keys bubble, at and sides, which choose bubbles");
    check.require(!check.is_given("count") || !event.sides.empty(),
                  "count",
                  "only allowed together with sides");
}

}  // namespace foam::texgen
