// SPDX-License-Identifier: Apache-2.0

#include "core/io/json_tree.h"

#include "core/io/format_error.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <iterator>

// nlohmann's own JSON tree does not keep the lines of its values. This tree is built from the
// events of nlohmann's SAX parser. An input iterator counts the lines that the parser has read. The
// line of a value is the line that the parser has reached when it reports the value.

namespace foam {

namespace {

using Json = nlohmann::json;

// Largest number of nested objects and arrays. A state of a foam has three levels.
constexpr std::size_t kMaxDepth = 16;

// The position up to which the parser has read. After a number, this is one character beyond the
// end of the number. This character may be a line feed, which token_line() does not count.
struct Progress {
    int line = 1;
    bool at_line_end = false;  // true if the last character read was a line feed

    int token_line() const { return line - (at_line_end ? 1 : 0); }
};

// An input iterator over the characters of a text. All copies update one shared Progress.
class Characters {
  public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    Characters(const char* at, Progress& progress) : at_(at), progress_(&progress) {}

    const char& operator*() const { return *at_; }
    Characters& operator++() {
        progress_->at_line_end = *at_ == '\n';
        progress_->line += progress_->at_line_end ? 1 : 0;
        ++at_;
        return *this;
    }
    friend bool operator==(const Characters& a, const Characters& b) { return a.at_ == b.at_; }

  private:
    const char* at_;
    Progress* progress_;
};

// Returns the parser's message without its prefix, which contains the parser's own error code and
// position.
std::string reason(const std::string& what) {
    const std::size_t column = what.find(", column ");
    const std::size_t end = column == std::string::npos ? what.find("] ") : what.find(": ", column);
    return end == std::string::npos ? what : what.substr(end + 2);
}

class TreeBuilder : public Json::json_sax_t {
  public:
    TreeBuilder(const Progress& progress, const std::string& file)
        : progress_(progress), file_(file) {}

    JsonTree take() { return std::move(root_); }

    bool null() override { return add(nullptr); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(std::int64_t value) override { return add(static_cast<double>(value)); }
    bool number_unsigned(std::uint64_t value) override { return add(static_cast<double>(value)); }
    bool number_float(double value, const std::string&) override { return add(value); }
    bool string(std::string& value) override { return add(std::move(value)); }
    bool binary(Json::binary_t&) override { return false; }  // does not occur in text

    bool start_object(std::size_t) override { return open(JsonTree::Object()); }
    bool end_object() override { return close(); }
    bool start_array(std::size_t) override { return open(JsonTree::Array()); }
    bool end_array() override { return close(); }

    bool key(std::string& name) override {
        auto& members = std::get<JsonTree::Object>(open_.back()->data);
        if (open_.back()->find(name) != nullptr) {
            fail(fmt::format("duplicate key '{}'", name));
        }
        members.emplace_back(name, JsonTree());
        return true;
    }

    bool parse_error(std::size_t, const std::string&, const Json::exception& error) override {
        fail(reason(error.what()));
    }

  private:
    [[noreturn]] void fail(const std::string& message) const {
        throw FormatError(file_, progress_.token_line(), message);
    }

    // Returns the node for the next value; appends it if the value is in an array. Pointers in
    // open_ stay valid: nothing is appended to the container that contains an open node until this
    // node is closed.
    JsonTree& next_node() {
        if (open_.empty()) {
            return root_;
        }
        if (auto* array = std::get_if<JsonTree::Array>(&open_.back()->data)) {
            return array->emplace_back();
        }
        return std::get<JsonTree::Object>(open_.back()->data).back().second;
    }

    template <class Value>
    bool add(Value value) {
        JsonTree& node = next_node();
        node.data = std::move(value);
        node.line = progress_.token_line();
        return true;
    }

    template <class Container>
    bool open(Container container) {
        if (open_.size() == kMaxDepth) {
            fail(fmt::format("nested more than {} levels deep", kMaxDepth));
        }
        JsonTree& node = next_node();
        node.data = std::move(container);
        node.line = progress_.token_line();
        open_.push_back(&node);
        return true;
    }

    bool close() {
        open_.pop_back();
        return true;
    }

    const Progress& progress_;
    const std::string& file_;
    JsonTree root_;
    std::vector<JsonTree*> open_;
};

}  // namespace

const JsonTree* JsonTree::find(std::string_view key) const {
    if (const auto* members = std::get_if<Object>(&data)) {
        for (const auto& [name, value] : *members) {
            if (name == key) {
                return &value;
            }
        }
    }
    return nullptr;
}

JsonTree parse_json(std::string_view text, const std::string& file) {
    Progress progress;
    TreeBuilder builder(progress, file);
    Json::sax_parse(Characters(text.data(), progress),
                    Characters(text.data() + text.size(), progress),
                    &builder);
    return builder.take();
}

}  // namespace foam
