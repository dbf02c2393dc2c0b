// SPDX-License-Identifier: Apache-2.0

#include "texgen/events/chosen_bubbles.h"

#include "core/foam/locate.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

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

// Returns up to `count` bubbles with the given numbers of sides, no bubble twice. The numbers take
// turns, starting with the number at the index `first_index`, modulo the length of the list. In
// each turn, the remaining bubble with the smallest target area is chosen among the bubbles with
// this number of sides. A number that is listed several times has several turns. A number without
// remaining bubbles is skipped.
std::vector<ChosenBubble> choose_by_sides(const std::vector<int>& numbers,
                                          const Foam& foam,
                                          std::size_t first_index,
                                          std::size_t count) {
    std::map<int, std::vector<BubbleId>> candidates;  // by sides; the smallest bubble is last
    for (const int number : numbers) {
        std::vector<BubbleId> bubbles = bubbles_of_sides(foam, number);
        std::ranges::reverse(bubbles);
        candidates[number] = std::move(bubbles);
    }
    std::size_t available = 0;
    for (const auto& [number, bubbles] : candidates) {
        available += bubbles.size();
    }
    std::vector<ChosenBubble> all;
    for (std::size_t k = first_index; all.size() < std::min(count, available); ++k) {
        std::vector<BubbleId>& bubbles = candidates.at(numbers[k % numbers.size()]);
        if (!bubbles.empty()) {
            all.push_back(chosen(foam, bubbles.back()));
            bubbles.pop_back();
        }
    }
    return all;
}

std::vector<ChosenBubble> choose_by_identity(const std::vector<BubbleIdentity>& bubbles,
                                             const Foam& foam,
                                             std::size_t first_index,
                                             std::size_t count) {
    std::vector<ChosenBubble> all;
    for (std::size_t k = first_index; k < first_index + count; ++k) {
        if (const auto one = choose_identity(foam, bubbles[k])) {
            all.push_back(*one);
        }
    }
    return all;
}

}  // namespace

std::vector<ChosenBubble> choose_bubbles(const EventBase& event,
                                         const EventContext& context,
                                         std::size_t first_index,
                                         std::size_t count) {
    const Foam& foam = context.foam;
    if (count == 0) {
        return all_bubbles(foam);
    }
    if (!event.sides.empty()) {
        return choose_by_sides(event.sides, foam, first_index, count);
    }
    if (!event.at) {
        return choose_by_identity(event.bubbles, foam, first_index, count);
    }
    const auto found = identity_at(foam, context.point_at(*event.at));
    return found ? std::vector{*choose_identity(foam, *found)} : std::vector<ChosenBubble>{};
}

void check_choice(const EventCheck& check, bool may_choose_all) {
    const EventBase& event = check.event;
    const int given_count =
        (event.bubbles.empty() ? 0 : 1) + (event.at ? 1 : 0) + (event.sides.empty() ? 0 : 1);
    check.require(given_count <= 1,
                  event.sides.empty() ? "at" : "sides",
                  "only one of the keys bubble, at and sides may be given");
    check.require(may_choose_all || given_count == 1,
                  "kind",
                  "the event must have one of the keys bubble, at and sides, which choose bubbles");
    for (const BubbleIdentity bubble : event.bubbles) {
        check.require_fit(
            static_cast<std::int64_t>(bubble) < check.setting.identity_limit,
            "bubble",
            ": ",
            fmt::format("must be below {}, the sum of foam.bubbles and the bubbles that events "
                        "create; there is no bubble {}",
                        check.setting.identity_limit,
                        bubble));
    }
    check.require(!check.is_given("count") || !event.sides.empty(),
                  "count",
                  "only allowed together with the key sides");
}

}  // namespace foam::texgen
