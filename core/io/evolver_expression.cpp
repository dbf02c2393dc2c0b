// SPDX-License-Identifier: Apache-2.0

#include "core/io/evolver_expression.h"

#include "core/geometry/elementary.h"

#include <fmt/core.h>

#include <cmath>
#include <numbers>

namespace foam::evolver {

namespace {

// Largest number of nested levels of an expression, far below the depth at which the stack would
// overflow.
constexpr int kMaxNesting = 100;

using Function = double (*)(double);

Function find_function(const std::string& name) {
    static const std::map<std::string, Function> functions{
        {"sqrt", [](double x) { return std::sqrt(x); }},
        {"sqr", [](double x) { return x * x; }},
        {"abs", [](double x) { return std::abs(x); }},
        {"exp", [](double x) { return ieee::exp(x); }},
        {"log", [](double x) { return ieee::log(x); }},
        {"sin", [](double x) { return ieee::sin(x); }},
        {"cos", [](double x) { return ieee::cos(x); }},
        {"tan", [](double x) { return ieee::tan(x); }},
        {"asin", [](double x) { return ieee::asin(x); }},
        {"acos", [](double x) { return ieee::acos(x); }},
        {"atan", [](double x) { return ieee::atan(x); }},
    };
    const auto found = functions.find(name);
    return found == functions.end() ? nullptr : found->second;
}

// A recursive descent parser. A sum consists of products, a product of powers, and a power of
// primaries.
class Parser {
  public:
    Parser(TokenReader& tokens, const Parameters& parameters)
        : tokens_(tokens), parameters_(parameters) {}

    double sum() {
        double value = product();
        while (at_operator('+') || at_operator('-')) {
            const bool minus = tokens_.take().is_symbol('-');
            const double term = product();
            value += minus ? -term : term;
        }
        return value;
    }

  private:
    // Returns true if the next token is the given operator and continues the expression. Outside
    // parentheses, an operator that begins a line ends the expression, and so does a sign with
    // white space before it and none after it. In exponents and operands of signs, neither does.
    bool at_operator(char symbol) const {
        const Token& token = tokens_.peek();
        const bool is_sign =
            (symbol == '+' || symbol == '-') && token.follows_space && !token.precedes_space;
        return token.is_symbol(symbol) && (depth_ > 0 || !(token.starts_line || is_sign));
    }

    double product() {
        double value = power();
        while (at_operator('*') || at_operator('/')) {
            const bool divides = tokens_.take().is_symbol('/');
            const double factor = power();
            value = divides ? value / factor : value * factor;
        }
        return value;
    }

    // A sign has a lower precedence than a power: -2^2 is -4.
    double power() {
        if (tokens_.at_symbol('-') || tokens_.at_symbol('+')) {
            const bool minus = tokens_.take().is_symbol('-');
            const double value = nested([this] { return power(); });
            return minus ? -value : value;
        }
        const double base = primary();
        if (!at_operator('^')) {
            return base;
        }
        tokens_.take();
        return ieee::pow(base, nested([this] { return power(); }));
    }

    double primary() {
        if (tokens_.peek().kind == TokenKind::Number) {
            return tokens_.take().number;
        }
        if (tokens_.peek().kind == TokenKind::Word) {
            return named_value();
        }
        if (!tokens_.at_symbol('(')) {
            tokens_.fail_expecting("a number");
        }
        return parenthesized();
    }

    double parenthesized() {
        tokens_.take();
        const double value = nested([this] { return sum(); });
        if (!tokens_.at_symbol(')')) {
            tokens_.fail_expecting("')'");
        }
        tokens_.take();
        return value;
    }

    // Returns the value of a parameter, a constant or a function call.
    double named_value() {
        const std::string name = lower(tokens_.peek().text);
        const auto parameter = parameters_.find(name);
        const Function function = find_function(name);
        if (parameter == parameters_.end() && name != "pi" && name != "e" && function == nullptr) {
            tokens_.fail_expecting("a number, a parameter or a function");
        }
        tokens_.take();
        if (parameter != parameters_.end()) {
            return parameter->second;
        }
        if (function == nullptr) {
            return name == "pi" ? std::numbers::pi : std::numbers::e;
        }
        if (!tokens_.at_symbol('(')) {
            tokens_.fail_expecting("'('");
        }
        return function(parenthesized());
    }

    // Returns inner(). Throws FormatError if the nesting is too deep.
    template <class Inner>
    double nested(Inner inner) {
        if (++depth_ > kMaxNesting) {
            tokens_.fail(
                tokens_.peek().line,
                fmt::format("the expression is nested more than {} levels deep", kMaxNesting));
        }
        const double value = inner();
        --depth_;
        return value;
    }

    TokenReader& tokens_;
    const Parameters& parameters_;
    int depth_ = 0;
};

}  // namespace

double take_expression(TokenReader& tokens, const Parameters& parameters) {
    const int line = tokens.peek().line;
    const double value = Parser(tokens, parameters).sum();
    if (!std::isfinite(value)) {
        tokens.fail(line, "expected a finite number");
    }
    return value;
}

}  // namespace foam::evolver
