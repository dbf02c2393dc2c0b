// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/network/ids.h"

#include <cassert>
#include <utility>
#include <vector>

namespace foam {

/// A vector with one value for each slot (network.h) of one kind of elements of a network:
/// junctions, films or bubbles. The value of an element is at the index given by the id of the
/// element.
template <class Id, class T>
class Indexed {
  public:
    Indexed() = default;
    explicit Indexed(std::size_t size, const T& value = T()) : values_(size, value) {}

    T& operator[](Id id) {
        assert(index_of(id) < values_.size());
        return values_[index_of(id)];
    }
    const T& operator[](Id id) const {
        assert(index_of(id) < values_.size());
        return values_[index_of(id)];
    }

    std::size_t size() const { return values_.size(); }
    void resize(std::size_t size, const T& value = T()) { values_.resize(size, value); }
    /// Appends a value and returns its id.
    Id push_back(T value) {
        values_.push_back(std::move(value));
        return id_at<Id>(values_.size() - 1);
    }

    auto begin() { return values_.begin(); }
    auto end() { return values_.end(); }
    auto begin() const { return values_.begin(); }
    auto end() const { return values_.end(); }

    friend bool operator==(const Indexed& a, const Indexed& b) = default;

  private:
    std::vector<T> values_;
};

}  // namespace foam
