// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/svg_path.h"

#include "core/files/file_io.h"
#include "core/files/shown_text.h"
#include "core/geometry/trigonometric.h"
#include "texgen/pictures/svg_text.h"

#include <fmt/core.h>

#include <array>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

char upper(char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

// Reads the commands of a path one after another. A small letter stands for coordinates relative to
// the current point.
class PathReader {
  public:
    explicit PathReader(std::string_view data) : text_(data) {}

    BezierPath read() {
        while (!text_.is_at_end()) {
            next_command();
            run_command();
        }
        return std::move(path_);
    }

  private:
    [[noreturn]] void fail() const {
        throw InputError(
            fmt::format("the data of a path have an error at character {}", text_.position()));
    }

    // Reads the letter of the next command. A repeated command may lack it. After a move, a missing
    // letter means a line.
    void next_command() {
        if (const std::optional<char> letter = text_.letter()) {
            previous_command_ = upper(command_);
            command_ = *letter;
        } else if (upper(command_) == 'Z' || command_ == '\0') {
            fail();
        } else {
            previous_command_ = upper(command_);
            command_ = command_ == 'M' ? 'L' : command_ == 'm' ? 'l' : command_;
        }
        if (path_.empty() && upper(command_) != 'M') {
            fail();
        }
    }

    void run_command() {
        switch (upper(command_)) {
            case 'M':
                path_.push_back({point()});
                is_closed_ = false;
                break;
            case 'Z':
                current_subpath().add_line(current_subpath().start);
                is_closed_ = true;
                break;
            case 'L':
                line_to(point());
                break;
            case 'H':
                line_to(
                    {number() + (is_relative() ? current_point().x() : 0.0), current_point().y()});
                break;
            case 'V':
                line_to(
                    {current_point().x(), number() + (is_relative() ? current_point().y() : 0.0)});
                break;
            case 'A':
                arc();
                break;
            default:
                curve();
        }
    }

    void curve() {
        const Vec2 from = current_point();
        // S continues the direction of a preceding C or S, and T that of a preceding Q or T.
        const Vec2 mirrored = 2.0 * from - control_;
        switch (upper(command_)) {
            case 'C': {
                const Vec2 first = point();
                cubic(first);
                break;
            }
            case 'S':
                cubic(previous_command_ == 'C' || previous_command_ == 'S' ? mirrored : from);
                break;
            case 'Q': {
                const Vec2 control = point();
                quadratic(control);
                break;
            }
            case 'T':
                quadratic(previous_command_ == 'Q' || previous_command_ == 'T' ? mirrored : from);
                break;
            default:
                fail();
        }
    }

    void line_to(const Vec2& to) { open_subpath().add_line(to); }

    void cubic(const Vec2& first) {
        const Vec2 second = point();
        const Vec2 end = point();
        open_subpath().curves.push_back({first, second, end});
        control_ = second;
    }

    void quadratic(const Vec2& control) {
        const Vec2 end = point();
        open_subpath().add_quadratic(control, end);
        control_ = control;
    }

    void arc() {
        const double x = number();
        const double y = number();
        const double rotation = kDegree * number();
        const bool is_large = flag();
        const bool is_positive = flag();
        const Vec2 end = point();
        add_arc(open_subpath(), {Vec2(x, y).cwiseAbs(), rotation, is_large, is_positive, end});
    }

    Subpath& current_subpath() { return path_.back(); }

    // Returns the subpath to which a curve is added: after Z, a new one.
    Subpath& open_subpath() {
        if (is_closed_) {
            path_.push_back({current_point()});
            is_closed_ = false;
        }
        return current_subpath();
    }

    Vec2 current_point() const { return path_.empty() ? Vec2(0.0, 0.0) : path_.back().end(); }
    bool is_relative() const { return command_ != upper(command_); }

    Vec2 point() {
        const Vec2 origin = is_relative() ? current_point() : Vec2(0.0, 0.0);
        const double x = number();
        const double y = number();
        return origin + Vec2(x, y);
    }

    double number() {
        const std::optional<double> found = text_.number();
        return found ? *found : throw_error();
    }
    bool flag() {
        const std::optional<bool> found = text_.flag();
        return found ? *found : throw_error() > 0.0;
    }
    double throw_error() const { fail(); }

    SvgText text_;
    BezierPath path_;
    char command_ = '\0';
    char previous_command_ = '\0';  // the preceding command, as a capital letter
    Vec2 control_{0.0, 0.0};        // the last control point of the preceding curve
    bool is_closed_ = false;        // true after Z
};

// Reads up to six numbers in parentheses. Returns nullopt if they are malformed.
std::optional<std::vector<double>> arguments(SvgText& text) {
    std::vector<double> numbers;
    if (!text.skip('(')) {
        return std::nullopt;
    }
    while (!text.skip(')')) {
        const std::optional<double> number = text.number();
        if (!number || numbers.size() == 6) {
            return std::nullopt;
        }
        numbers.push_back(*number);
    }
    return numbers;
}

AffineMap rotation(double degrees) {
    const Vec2 axis = unit_vector(kDegree * degrees);
    return {{axis.x(), axis.y(), -axis.y(), axis.x(), 0.0, 0.0}};
}

// Returns one transform, or nullopt if there is none with this name and number of arguments.
std::optional<AffineMap> transform_of(std::string_view name, const std::vector<double>& n) {
    const std::size_t count = n.size();
    if (name == "matrix" && count == 6) {
        return AffineMap{{n[0], n[1], n[2], n[3], n[4], n[5]}};
    }
    if (name == "translate" && (count == 1 || count == 2)) {
        return AffineMap::translation(n[0], count == 2 ? n[1] : 0.0);
    }
    if (name == "scale" && (count == 1 || count == 2)) {
        return AffineMap{{n[0], 0.0, 0.0, n.back(), 0.0, 0.0}};
    }
    if (name == "rotate" && count == 1) {
        return rotation(n[0]);
    }
    if (name == "rotate" && count == 3) {
        return AffineMap::translation(n[1], n[2]) * rotation(n[0]) *
               AffineMap::translation(-n[1], -n[2]);
    }
    if (name == "skewX" && count == 1) {
        return AffineMap{{1.0, 0.0, ieee::tan(kDegree * n[0]), 1.0, 0.0, 0.0}};
    }
    if (name == "skewY" && count == 1) {
        return AffineMap{{1.0, ieee::tan(kDegree * n[0]), 0.0, 1.0, 0.0, 0.0}};
    }
    return std::nullopt;
}

}  // namespace

BezierPath parse_svg_path(std::string_view data) {
    return PathReader(data).read();
}

AffineMap parse_svg_transform(std::string_view attribute) {
    SvgText text(attribute);
    AffineMap map;
    while (!text.is_at_end()) {
        const std::string_view name = text.word();
        const std::optional<std::vector<double>> numbers = arguments(text);
        const std::optional<AffineMap> one = numbers ? transform_of(name, *numbers) : std::nullopt;
        if (!one) {
            throw InputError(fmt::format("transform=\"{}\" is malformed", cut_text(attribute)));
        }
        map = map * *one;
    }
    return map;
}

BezierPath parse_svg_points(std::string_view attribute) {
    SvgText text(attribute);
    BezierPath path;
    while (!text.is_at_end()) {
        const std::optional<double> x = text.number();
        const std::optional<double> y = text.number();
        if (!x || !y) {
            throw InputError(fmt::format("the points of a polygon have an error at character {}",
                                         text.position()));
        }
        if (path.empty()) {
            path.push_back({Vec2(*x, *y)});
        } else {
            path.back().add_line({*x, *y});
        }
    }
    return path;
}

}  // namespace foam::texgen
