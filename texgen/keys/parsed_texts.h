// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/value_kinds.h"

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace foam::texgen {

/// A kind of values: lists of non-empty texts. A single text may be written without brackets. The
/// function `parse` checks each text of a list: it throws std::invalid_argument for a text that is
/// not allowed. fault() returns the message of this exception. `description` describes the allowed
/// values in words.
template <auto parse>
struct ParsedTexts {
    std::string_view description;

    std::string allowed() const { return std::string(description); }
    std::string schema() const {
        return any_of_schema(Text{}.schema(), list_schema(Text{}.schema(), 0, 0));
    }
    bool read(const Value& value, std::vector<std::string>& member) const {
        const auto* const list = std::get_if<Value::List>(&value.data);
        std::vector<std::string> found;
        for (const Value& item : list != nullptr ? *list : Value::List{value}) {
            if (!Text{}.read(item, found.emplace_back()) || !fault_of(found.back()).empty()) {
                return false;
            }
        }
        member = std::move(found);
        return true;
    }
    Value write(const std::vector<std::string>& member) const {
        Value::List list;
        for (const std::string& text : member) {
            list.push_back({text});
        }
        return {std::move(list)};
    }
    std::string fault(const Value& value) const {
        const auto* const list = std::get_if<Value::List>(&value.data);
        for (const Value& item : list != nullptr ? *list : Value::List{value}) {
            const auto* const text = std::get_if<std::string>(&item.data);
            if (text != nullptr && !fault_of(*text).empty()) {
                return fault_of(*text);
            }
        }
        return {};
    }

  private:
    static std::string fault_of(const std::string& text) {
        try {
            static_cast<void>(parse(text));
            return {};
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
    }
};

}  // namespace foam::texgen
