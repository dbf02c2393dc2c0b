// SPDX-License-Identifier: Apache-2.0

#include "texgen/events/all_events.h"

#include "texgen/keys/value_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace foam::texgen {

namespace {

std::span<const std::string_view> kind_names() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> all;
        all.reserve(std::size(kEventKinds));
        for (const EventKind& kind : kEventKinds) {
            all.push_back(kind.name);
        }
        return all;
    }();
    return names;
}

// Describes the values of the key `kind` (value_kinds.h): the names of the kinds of events. If the
// string in which the value is stored is empty, the key is unset.
struct KindNames {
    std::string allowed() const { return Words{kind_names()}.allowed(); }
    std::string schema() const { return Words{kind_names()}.schema(); }
    std::span<const std::string_view> words() const { return kind_names(); }
    bool read(const Value& value, std::string& member) const {
        return Words{kind_names()}.read(value, member);
    }
    std::optional<Value> write(const std::string& member) const {
        return member.empty() ? std::nullopt : std::optional(Value{member});
    }
};

Keys<EventBase> shared_keys() {
    const std::vector<EventTraits> kinds(kEventKinds.begin(), kEventKinds.end());
    return joined({{key("kind", KindNames{}, "what happens", &EventBase::kind)},
                   time_keys(),
                   choice_keys(kinds)});
}

Keys<Event> all_keys() {
    Keys<Event> all = make_nested_keys<Event>("", std::identity(), shared_keys());
    for (const EventKind& kind : kEventKinds) {
        for (const Key<Event>& key : kind.keys()) {
            all.push_back(key.only_for("kind", {std::string(kind.name)}));
        }
    }
    return all;
}

bool takes(std::string_view kind, const KeyInfo& key) {
    return !key.condition || key.condition->allows(kind);
}

}  // namespace

const EventKind& find_event_kind(std::string_view name) {
    return *std::ranges::find(kEventKinds, name, &EventKind::name);
}

std::span<const Key<Event>> event_keys() {
    static const Keys<Event> keys = all_keys();
    return keys;
}

std::string kinds_of(const KeyInfo& key) {
    std::vector<std::string_view> kinds;
    std::ranges::copy_if(kind_names(), std::back_inserter(kinds), [&](std::string_view kind) {
        return takes(kind, key);
    });
    return fmt::format("{}", fmt::join(kinds, ", "));
}

std::string keys_of(std::string_view kind) {
    std::vector<std::string_view> names;
    for (const KeyInfo& key : event_keys()) {
        if (takes(kind, key)) {
            names.push_back(key.path);
        }
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

std::string describe_event_kinds_in_markdown() {
    std::string table = "| kind | what happens |\n|---|---|\n";
    for (const EventKind& kind : kEventKinds) {
        table += fmt::format("| `{}` | {} |\n", kind.name, kind.meaning);
    }
    return table;
}

}  // namespace foam::texgen
