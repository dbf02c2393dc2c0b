// SPDX-License-Identifier: Apache-2.0

#include "core/io/json_item.h"

#include "core/io/format_error.h"

#include <fmt/core.h>

#include <cmath>
#include <variant>

namespace foam {

JsonItem JsonItem::member(const char* name) const {
    const JsonTree* found = tree_->find(name);
    if (found == nullptr) {
        fail(fmt::format("'{}' is missing", name));
    }
    JsonItem item(*found, *file_);
    item.member_ = name;
    return item;
}

JsonItem JsonItem::element(std::size_t k) const {
    JsonItem item = *this;
    item.tree_ = &array()[k];
    item.element_ = k;
    return item;
}

JsonItem JsonItem::value(std::size_t k) const {
    JsonItem item = *this;
    item.tree_ = &array()[k];
    item.value_ = k;
    return item;
}

void JsonItem::expect_size(std::size_t size) const {
    if (array().size() != size) {
        fail(fmt::format("expected an array of {} numbers, found {}", size, array().size()));
    }
}

double JsonItem::number() const {
    const double* found = std::get_if<double>(&tree_->data);
    if (found == nullptr || !std::isfinite(*found)) {
        fail("expected a finite number");
    }
    return *found;
}

double JsonItem::positive() const {
    const double found = number();
    if (!(found > 0.0)) {
        fail(fmt::format("expected a positive number, found {}", found));
    }
    return found;
}

double JsonItem::integer(double min, double max) const {
    const double found = number();
    if (found != std::floor(found) || found < min || found > max) {
        fail(fmt::format("expected an integer from {} to {}, found {}", min, max, found));
    }
    return found;
}

std::uint32_t JsonItem::index(std::size_t count, const char* kind) const {
    if (count == 0) {
        fail(fmt::format("refers to {} {}, but the file has no {}", kind, number(), kind));
    }
    return static_cast<std::uint32_t>(integer(0.0, static_cast<double>(count) - 1.0));
}

bool JsonItem::is_text(const char* text) const {
    const auto* found = std::get_if<std::string>(&tree_->data);
    return found != nullptr && *found == text;
}

void JsonItem::fail(const std::string& message) const {
    throw FormatError(*file_, tree_->line, name() + message);
}

const JsonTree::Array& JsonItem::array() const {
    const auto* items = std::get_if<JsonTree::Array>(&tree_->data);
    if (items == nullptr) {
        fail("expected an array");
    }
    return *items;
}

// Returns the name of the value, followed by a colon and a space; empty for the root.
std::string JsonItem::name() const {
    if (member_ == nullptr) {
        return "";
    }
    std::string name = fmt::format("'{}'", member_);
    name += element_ ? fmt::format("[{}]", *element_) : "";
    name += value_ ? fmt::format(", value {}", *value_ + 1) : "";
    return name + ": ";
}

}  // namespace foam
