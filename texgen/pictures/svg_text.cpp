// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/svg_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace foam::texgen {

namespace {

constexpr double kMaxNumber = 1e9;

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

}  // namespace

void SvgText::skip_spaces() {
    index_ = std::min(text_.find_first_not_of(" \t\r\n\f,", index_), text_.size());
}

bool SvgText::is_at_end() {
    skip_spaces();
    return index_ == text_.size();
}

std::optional<char> SvgText::letter() {
    if (is_at_end() || !is_letter(text_[index_])) {
        return std::nullopt;
    }
    return text_[index_++];
}

std::string_view SvgText::word() {
    skip_spaces();
    const std::size_t begin = index_;
    while (index_ < text_.size() && is_letter(text_[index_])) {
        ++index_;
    }
    return text_.substr(begin, index_ - begin);
}

bool SvgText::skip(char c) {
    const bool is_next = !is_at_end() && text_[index_] == c;
    index_ += is_next ? 1U : 0U;
    return is_next;
}

std::optional<double> SvgText::number() {
    skip_spaces();
    const bool has_plus = index_ < text_.size() && text_[index_] == '+';
    const std::string_view digits = text_.substr(index_ + (has_plus ? 1U : 0U));
    // from_chars would also read words such as "inf", and a minus after the plus.
    const std::size_t first = digits.find_first_not_of(has_plus ? "" : "-");
    if (first > 1 || digits.find_first_of("0123456789.", first) != first) {
        return std::nullopt;
    }
    double number = 0.0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error != std::errc{} || !(std::abs(number) <= kMaxNumber)) {
        return std::nullopt;
    }
    index_ = static_cast<std::size_t>(end - text_.data());
    return number;
}

std::optional<bool> SvgText::flag() {
    skip_spaces();
    if (index_ == text_.size() || (text_[index_] != '0' && text_[index_] != '1')) {
        return std::nullopt;
    }
    return text_[index_++] == '1';
}

}  // namespace foam::texgen
