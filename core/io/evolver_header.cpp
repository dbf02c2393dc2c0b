// SPDX-License-Identifier: Apache-2.0

#include "core/io/evolver_header.h"

#include <fmt/core.h>

#include <array>
#include <cmath>

namespace foam::evolver {

namespace {

// Largest |shear| of a torus, in widths of the torus. More would leave few digits for coordinates.
constexpr double kMaxShear = 1e6;

// Returns the rejected keywords in lower case. Each has a text, which follows the keyword in the
// error message.
const std::map<std::string, const char*>& rejected_keywords() {
    static constexpr const char* kEnergy =
        "adds an energy that is not supported; the energy of a foam is the length of its films";
    static constexpr const char* kModel =
        "selects a model that is not supported; only STRING models with the Euclidean metric are "
        "supported";
    static const std::map<std::string, const char*> rejected_words{
        {"soapfilm", kModel},
        {"simplex_representation", kModel},
        {"lagrange", "is not supported; must be LINEAR (straight edges) or QUADRATIC (arcs)"},
        {"lagrange_order", "is not supported; must be LINEAR (straight edges) or QUADRATIC (arcs)"},
        {"metric", kModel},
        {"conformal_metric", kModel},
        {"klein_metric", kModel},
        {"optimizing_parameter", "is not supported; the shape of the torus is fixed"},
        {"pressure", "makes the gas compressible, which is not supported"},
        {"phasefile", "is not supported; all films have the same tension"},
        {"wulff", "is not supported; all films have the same tension"},
        {"square_curvature", kEnergy},
        {"mean_curvature_integral", kEnergy},
        {"gauss_curvature", kEnergy},
        {"square_gauss_curvature", kEnergy},
        {"conducting_knot_energy", kEnergy},
        {"insulating_knot_energy", kEnergy},
    };
    return rejected_words;
}

// A method, in Evolver's sense: a value that is computed for each element, such as the length of an
// edge.
struct Method {
    std::string name;
    double modulus = 1.0;   // the factor of the values
    bool global = false;    // true if it applies to all elements
    bool weighted = false;  // true if each element has a factor of its own (ELEMENT_MODULUS)

    bool is_length_of_all_edges() const {
        return global && !weighted && (name == "circular_arc_length" || name == "edge_length");
    }
};

class HeaderReader {
  public:
    explicit HeaderReader(TokenReader& tokens) : tokens_(tokens) {}

    Header read() {
        while (!tokens_.at_word("vertices") && !tokens_.at_word("vertex")) {
            if (tokens_.at_end()) {
                tokens_.fail_expecting("a section 'vertices'");
            }
            read_statement();
        }
        check_model();
        if (!is_torus_) {
            header_.domain = kPlane;
        }
        return std::move(header_);
    }

  private:
    using Handler = void (HeaderReader::*)();

    void read_statement() {
        static const std::map<std::string, Handler> handlers{
            {"string", &HeaderReader::read_string},
            {"surface_dimension", &HeaderReader::read_surface_dimension},
            {"space_dimension", &HeaderReader::read_space_dimension},
            {"torus", &HeaderReader::read_torus},
            {"torus_filled", &HeaderReader::read_torus},
            {"symmetry_group", &HeaderReader::read_symmetry_group},
            {"periods", &HeaderReader::read_periods},
            {"torus_periods", &HeaderReader::read_periods},
            {"quadratic", &HeaderReader::pass},
            {"linear", &HeaderReader::pass},
            {"parameter", &HeaderReader::read_parameter},
            {"method_instance", &HeaderReader::read_method_instance},
            {"quantity", &HeaderReader::read_quantity},
        };
        line_ = tokens_.peek().line;
        keyword_ = tokens_.take_word("a keyword of the top section");
        const auto rejected = rejected_keywords().find(lower(keyword_));
        if (rejected != rejected_keywords().end()) {
            tokens_.fail(line_, fmt::format("{} {}", keyword_, rejected->second));
        }
        const auto handler = handlers.find(lower(keyword_));
        (this->*(handler == handlers.end() ? &HeaderReader::skip_statement : handler->second))();
    }

    // Handles a keyword that has no arguments and needs no action.
    void pass() {}

    // Returns true at the end of a statement: at the end of the file, or before a line that begins
    // with a word.
    bool at_statement_end() const {
        return tokens_.at_end() ||
               (tokens_.at_line_start() && tokens_.peek().kind == TokenKind::Word);
    }

    // Skips the rest of a statement. Commands in braces may extend over many lines.
    void skip_statement() {
        int braces = 0;
        while (!tokens_.at_end() && (braces > 0 || !at_statement_end())) {
            const Token token = tokens_.take();
            braces += token.is_symbol('{') ? 1 : 0;
            braces -= token.is_symbol('}') ? 1 : 0;
        }
    }

    void read_string() { is_string_ = true; }

    void read_surface_dimension() {
        is_string_ = tokens_.take_integer("the dimension of the films") == 1;
    }

    void read_space_dimension() { dimension_ = tokens_.take_integer("the dimension of space"); }

    void read_torus() { is_torus_ = true; }

    void read_symmetry_group() {
        is_torus_ = lower(tokens_.take_text("the name of a symmetry group")) == "torus";
        if (!is_torus_) {
            tokens_.fail(line_, "the only symmetry group supported is \"torus\"");
        }
    }

    void read_periods() {
        std::array<double, 4> periods{};
        for (double& period : periods) {
            period = take_expression(tokens_, header_.parameters);
        }
        if (periods[1] != 0.0) {
            tokens_.fail(
                line_,
                fmt::format(
                    "the first period must be along the x axis: its y component is {}, must be 0",
                    periods[1]));
        }
        if (periods[0] <= 0.0 || periods[3] <= 0.0) {
            tokens_.fail(
                line_,
                fmt::format("the width and height of the torus must be positive, not {} and {}",
                            periods[0],
                            periods[3]));
        }
        if (!has_moderate_shape({periods[0], periods[3]})) {
            tokens_.fail(line_,
                         fmt::format("the width and the height of the torus must differ by at most "
                                     "the factor {}, but are {} and {}",
                                     kMaxAspect,
                                     periods[0],
                                     periods[3]));
        }
        if (std::abs(periods[2]) > kMaxShear * periods[0]) {
            tokens_.fail(line_,
                         fmt::format("the x component of the second period is {}; its magnitude "
                                     "must be at most {} times the width of the torus, which is {}",
                                     periods[2],
                                     kMaxShear,
                                     periods[0]));
        }
        header_.domain = {periods[0], periods[3], periods[2]};
    }

    void read_parameter() {
        const std::string name = lower(tokens_.take_word("the name of a parameter"));
        while (tokens_.at_symbol(':') || tokens_.at_symbol('=')) {
            tokens_.take();
        }
        header_.parameters[name] = take_expression(tokens_, header_.parameters);
    }

    // Reads METHOD_INSTANCE name METHOD method [MODULUS number] [GLOBAL] ...
    void read_method_instance() {
        const std::string name = lower(tokens_.take_word("the name of a method instance"));
        if (at_method()) {
            methods_[name] = take_method();
        }
        skip_statement();
    }

    // Reads QUANTITY name, or QUANTITY name INFO_ONLY | ENERGY | FIXED | CONSERVED ...
    void read_quantity() {
        const std::string name(tokens_.take_word("the name of a quantity"));
        if (tokens_.at_word("energy")) {
            read_energy(name);
        } else if (tokens_.at_word("fixed") || tokens_.at_word("conserved")) {
            header_.notes.push_back(
                fmt::format("line {}: quantity '{}' is FIXED or CONSERVED in the file; foamtex "
                            "ignores this",
                            line_,
                            name));
        }
        skip_statement();
    }

    // Reads a QUANTITY that is declared ENERGY. The energy is the modulus of the quantity times the
    // sum of the values of its methods. For each method that is the length of all edges, adds the
    // product of both moduli (of the method and of the quantity) to the film tension. Rejects every
    // other method and a quantity without methods, unless one of the moduli is 0.
    void read_energy(const std::string& name) {
        double modulus = 1.0;
        std::vector<Method> methods;
        tokens_.take();
        while (in_quantity()) {
            if (at_method()) {
                methods.push_back(take_method());
            } else if (lower(tokens_.take().text) == "modulus") {
                modulus = take_expression(tokens_, header_.parameters);
            }
        }
        bool supported = !methods.empty();
        for (const Method& method : methods) {
            supported = supported && (method.modulus == 0.0 || method.is_length_of_all_edges());
            header_.added_tension += modulus * method.modulus;
        }
        if (modulus != 0.0 && !supported) {
            tokens_.fail(line_,
                         fmt::format("quantity '{}' adds an energy that is not supported; only the "
                                     "length of all edges is supported",
                                     name));
        }
    }

    // Reads METHOD name or GLOBAL_METHOD name. Also reads the words after the name of a method, but
    // not those after the name of a method instance: a MODULUS there belongs to the quantity.
    Method take_method() {
        const bool global = lower(tokens_.take().text) == "global_method";
        const std::string name = lower(tokens_.take_word("the name of a method"));
        const auto instance = methods_.find(name);
        Method method = instance == methods_.end() ? Method{name} : instance->second;
        method.global = method.global || global;
        while (instance == methods_.end() && in_quantity() && !at_method()) {
            const std::string word = lower(tokens_.take().text);
            if (word == "modulus") {
                method.modulus = take_expression(tokens_, header_.parameters);
            }
            method.global = method.global || word == "global";
            method.weighted = method.weighted || word == "element_modulus";
        }
        return method;
    }

    bool at_method() const { return tokens_.at_word("method") || tokens_.at_word("global_method"); }

    // Returns true if the next token belongs to the statement of a quantity or of a method
    // instance, which may continue on a new line.
    bool in_quantity() const {
        return !at_statement_end() || at_method() || tokens_.at_word("modulus") ||
               tokens_.at_word("global");
    }

    void check_model() const {
        const int line = tokens_.peek().line;
        if (!is_string_) {
            tokens_.fail(line,
                         "the top section must contain STRING; only string models are supported");
        }
        if (dimension_ != 2) {
            tokens_.fail(
                line,
                fmt::format("the top section must contain SPACE_DIMENSION 2; the dimension is {}",
                            dimension_));
        }
    }

    TokenReader& tokens_;
    Header header_;
    int line_ = 1;  // line of the statement being read
    std::string_view keyword_;
    std::map<std::string, Method> methods_;
    bool is_string_ = false;
    bool is_torus_ = false;
    int dimension_ = 3;  // Evolver's default
};

}  // namespace

Header read_header(TokenReader& tokens) {
    return HeaderReader(tokens).read();
}

}  // namespace foam::evolver
