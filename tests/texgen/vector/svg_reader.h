// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/vector/chain.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// Reads the paths of an SVG file, independently of the code that writes them. Arcs are read by the
/// rules of SVG 1.1, appendix F.6. Coordinates are as in the file: y points down.
class SvgReader {
  public:
    explicit SvgReader(std::string_view text) : text_(text) {}

    struct Path {
        std::string element;  // the whole element <path ... />
        std::vector<Chain> chains;

        /// Returns the value of an attribute; empty if there is none.
        std::string attribute(const std::string& name) const {
            const std::size_t found = element.find(" " + name + "=\"");
            if (found == std::string::npos) {
                return {};
            }
            const std::size_t begin = found + name.size() + 3;
            return element.substr(begin, element.find('"', begin) - begin);
        }
    };

    /// Returns all paths with the given class.
    std::vector<Path> paths(const std::string& kind) const {
        std::vector<Path> found;
        for (std::size_t at = text_.find("<path"); at != std::string_view::npos;
             at = text_.find("<path", at + 1)) {
            Path path{std::string(text_.substr(at, text_.find("/>", at) - at)), {}};
            if (path.attribute("class") == kind) {
                path.chains = chains_of(path.attribute("d"));
                found.push_back(std::move(path));
            }
        }
        return found;
    }

  private:
    static double number(std::string_view& rest) {
        while (!rest.empty() && (rest.front() == ' ' || rest.front() == ',')) {
            rest.remove_prefix(1);
        }
        double value = 0.0;
        const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
        rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
        return value;
    }

    static Vec2 point(std::string_view& rest) {
        const double x = number(rest);
        const double y = number(rest);
        return {x, y};
    }

    static Chain::Step arc(std::string_view& rest, const Vec2& tail) {
        const double radius = number(rest);
        number(rest);  // the same radius
        number(rest);  // rotation
        const bool is_large = number(rest) != 0.0;
        const bool is_sweep = number(rest) != 0.0;
        const Vec2 head = point(rest);
        const double sine = std::min(1.0, 0.5 * (head - tail).norm() / radius);
        const double angle = is_large ? std::acos(-1.0) - std::asin(sine) : std::asin(sine);
        // A positive sweep turns toward positive y, which is left in coordinates of Vec2.
        return {head, is_sweep ? angle : -angle};
    }

    static std::vector<Chain> chains_of(const std::string& data) {
        std::vector<Chain> chains;
        std::string_view rest = data;
        while (!rest.empty()) {
            const char command = rest.front();
            rest.remove_prefix(1);
            if (command == 'M') {
                chains.push_back({point(rest), {}, false});
            } else if (command == 'L') {
                chains.back().steps.push_back({point(rest), 0.0});
            } else if (command == 'A') {
                chains.back().steps.push_back(arc(rest, chains.back().head()));
            } else if (command == 'Z') {
                chains.back().is_closed = true;
            }
        }
        return chains;
    }

    std::string_view text_;
};

}  // namespace foam::texgen
