// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/io/json_tree.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace foam {

/// A value of a state file, together with its position for error messages. The root of the file is
/// an object. A member of the root has one of four kinds:
/// - a text;
/// - a number;
/// - an array of numbers that form one value, such as "torus";
/// - a list of the elements of a foam, such as "films"; each element is a number or an array of
///   numbers.
///
/// All functions except `is_text` throw FormatError if the value is not of the requested kind. The
/// message names the value: "'films'[12], value 3: ...". Elements are counted from 0 like the ids
/// of a foam, and numbers in an array from 1. The tree and the name of the file must outlive the
/// item.
class JsonItem {
  public:
    /// Creates the item of the root. `file` is the name of the file in error messages.
    JsonItem(const JsonTree& root, const std::string& file) : tree_(&root), file_(&file) {}

    /// Returns the member with the given name. Precondition: this item is the root.
    JsonItem member(const char* name) const;
    /// Returns the number of elements of a list, or the number of numbers in an array.
    std::size_t size() const { return array().size(); }
    /// Returns an element of a list. Precondition: k < size().
    JsonItem element(std::size_t k) const;
    /// Returns the number with the index k of an array; the first index is 0.
    /// Precondition: k < size().
    JsonItem value(std::size_t k) const;
    /// Throws FormatError unless this is an array of the given size.
    void expect_size(std::size_t size) const;

    /// Returns a finite number.
    double number() const;
    /// Returns a finite number above 0.
    double positive() const;
    /// Returns an integer from `min` to `max`.
    double integer(double min, double max) const;
    /// Returns an index from 0 to `count` - 1, which refers to another element. `kind` is the kind
    /// of the other element, such as "film". If `count` is 0, the message says that the file has no
    /// element of this kind.
    std::uint32_t index(std::size_t count, const char* kind) const;
    /// Returns true if this is the given text.
    bool is_text(const char* text) const;

    /// Throws FormatError with a message that begins with the name of this value.
    [[noreturn]] void fail(const std::string& message) const;

  private:
    const JsonTree::Array& array() const;
    std::string name() const;

    const JsonTree* tree_;
    const std::string* file_;
    const char* member_ = nullptr;        // nullptr for the root
    std::optional<std::size_t> element_;  // index in the list; nothing for a whole member
    std::optional<std::size_t> value_;    // index in the array; nothing for a whole array
};

}  // namespace foam
