// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/preset_schema.h"

#include "texgen/events/all_events.h"
#include "texgen/json/json_writer.h"
#include "texgen/preset/preset_keys.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

namespace foam::texgen {

namespace {

constexpr std::string_view kDraft = "https://json-schema.org/draft/2020-12/schema";

// Returns the schema of an object that allows no properties yet.
Json object_schema() {
    return {{"type", "object"}, {"additionalProperties", false}, {"properties", Json::object()}};
}

Json key_schema(const KeyInfo& key) {
    Json schema = Json::parse(key.schema);
    schema["description"] = key.meaning;
    if (key.default_value) {
        schema["default"] = to_json(*key.default_value);
    }
    if (!key.unit.empty()) {
        schema["x-unit"] = key.unit;
    }
    if (key.condition) {
        schema["x-only-for"] = {{"key", key.condition->key}, {"values", key.condition->values}};
    }
    if (key.use) {
        schema[key.use->excludes ? "x-unused-with" : "x-used-with"] = {{"key", key.use->key},
                                                                       {"values", key.use->values}};
    }
    if (key.upper_limit) {
        schema["x-below"] = *key.upper_limit;
    }
    return schema;
}

// Adds the schema of a key to the properties of its table. A key such as albedo.colors.from is a
// property of an object that is allowed as the value of albedo.colors.
void add_key(Json& properties, const KeyInfo& key) {
    const std::string name(key.name());
    const std::size_t dot = name.find('.');
    if (dot == std::string::npos) {
        properties[name] = key_schema(key);
        return;
    }
    Json& alternatives = properties[name.substr(0, dot)]["anyOf"];
    if (alternatives.back().value("type", "") != "object") {
        alternatives.push_back(object_schema());
    }
    alternatives.back()["properties"][name.substr(dot + 1)] = key_schema(key);
}

// Returns the schema of one kind of event. It rejects keys that only other kinds accept.
Json event_schema(const EventKind& kind) {
    Json schema = object_schema();
    schema["description"] = kind.meaning;
    for (const KeyInfo& key : event_keys()) {
        if (!key.condition || key.condition->allows(kind.name)) {
            schema["properties"][std::string(key.name())] = key_schema(key);
        }
    }
    schema["properties"]["kind"]["enum"] = {kind.name};
    schema["required"] = {"kind"};
    return schema;
}

Json events_schema() {
    Json kinds = Json::array();
    for (const EventKind& kind : kEventKinds) {
        kinds.push_back(event_schema(kind));
    }
    return {{"type", "array"},
            {"description", "events that change the foam, in any order"},
            {"items", {{"anyOf", kinds}}}};
}

}  // namespace

Json to_json(const Value& value) {
    return std::visit(
        [](const auto& data) -> Json {
            using Data = std::decay_t<decltype(data)>;
            if constexpr (std::is_same_v<Data, Value::List>) {
                Json list = Json::array();
                for (const Value& item : data) {
                    list.push_back(to_json(item));
                }
                return list;
            } else if constexpr (std::is_same_v<Data, Value::Table>) {
                return Json::object();
            } else if constexpr (std::is_same_v<Data, Value::Opaque>) {
                return data.text;
            } else {
                return data;
            }
        },
        value.data);
}

std::string preset_schema() {
    Json schema{{"$schema", kDraft}, {"title", "A preset of foamtex " FOAMTEX_VERSION}};
    schema.update(object_schema());
    Json& tables = schema["properties"];
    tables["extends"] = {{"type", "string"},
                         {"minLength", 1},
                         {"description",
                          "the preset that this one extends: the name of a shipped preset, or a "
                          "path relative to the folder of this file"}};
    for (const KeyInfo& key : preset_keys()) {
        const std::string table(key.table());
        if (!tables.contains(table)) {
            tables[table] = object_schema();
        }
        add_key(tables[table]["properties"], key);
    }
    tables["event"] = events_schema();
    return indented(schema);
}

}  // namespace foam::texgen
