// SPDX-License-Identifier: Apache-2.0

#include "core/io/evolver_mesh.h"

#include <fmt/core.h>

#include <array>
#include <cstdlib>
#include <string>
#include <utility>

namespace foam::evolver {

namespace {

// The wrap of an edge is its lattice offset in the file: two symbols, or one number. The number has
// six bits per axis. The lower five of them are the number of periods in two's complement.
constexpr unsigned kWrapBits = 6;

std::int32_t decoded_wrap(unsigned bits) {
    const auto low = static_cast<std::int32_t>(bits & 0x1fU);
    return low < 0x10 ? low : low - 0x20;
}

// A table for one kind of element. In the file, each element has a number. The table converts this
// number to the index of the element. The numbers need not be contiguous.
class IdTable {
  public:
    IdTable(const TokenReader& tokens, const char* kind) : tokens_(tokens), kind_(kind) {}

    void add(int id, int line) {
        if (id < 1) {
            tokens_.fail(line, fmt::format("{} numbers must be at least 1, not {}", kind_, id));
        }
        if (!indices_.emplace(id, indices_.size()).second) {
            tokens_.fail(line, fmt::format("duplicate {} {}", kind_, id));
        }
    }

    // Returns the index of the element with the number `id`. Throws FormatError if the file has no
    // such element; the message then names `user`, the element that contains the reference.
    std::size_t index_of(int id, int line, const std::string& user) const {
        const auto found = indices_.find(id);
        if (found == indices_.end()) {
            tokens_.fail(
                line,
                fmt::format("{} refers to {} {}, which the file does not define", user, kind_, id));
        }
        return found->second;
    }

  private:
    const TokenReader& tokens_;
    const char* kind_;
    std::unordered_map<int, std::size_t> indices_;
};

// A section of the file. It begins with one of `words`; empty entries are unused.
struct Section {
    std::array<std::string_view, 4> words;
    const char* name = "";
};
constexpr Section kVertices{{"vertices", "vertex"}, "vertices"};
constexpr Section kEdges{{"edges", "edge"}, "edges"};
constexpr Section kFaces{{"faces", "facets", "face", "facet"}, "faces"};
constexpr Section kBodies{{"bodies", "body"}, "bodies"};

class MeshReader {
  public:
    MeshReader(TokenReader& tokens, const Parameters& parameters)
        : tokens_(tokens), parameters_(parameters) {}

    Mesh read() {
        read_section(kVertices, &MeshReader::read_vertex);
        read_section(kEdges, &MeshReader::read_edge);
        read_section(kFaces, &MeshReader::read_face);
        read_section(kBodies, &MeshReader::read_body);
        if (!tokens_.at_end() && !tokens_.at_word("read")) {
            tokens_.fail_expecting("'read' or the end of the file");
        }
        mesh_.end_line = tokens_.peek().line;
        return std::move(mesh_);
    }

  private:
    void read_section(const Section& section, void (MeshReader::*read_element)(int, int)) {
        if (!at_section(section)) {
            tokens_.fail_expecting(fmt::format("a section '{}'", section.name));
        }
        tokens_.take();
        while (tokens_.at_line_start() && tokens_.at_integer()) {
            const int line = tokens_.peek().line;
            const int id = tokens_.take_integer("an element number");
            (this->*read_element)(id, line);
        }
    }

    bool at_section(const Section& section) const {
        for (const std::string_view word : section.words) {
            if (!word.empty() && tokens_.at_word(word)) {
                return true;
            }
        }
        return false;
    }

    // Returns true at the end of an element. An element ends at the end of the file. It also ends
    // before a line that begins with an integer, with the name of a later section or with `read`.
    bool at_element_end() const {
        return tokens_.at_end() ||
               (tokens_.at_line_start() &&
                (tokens_.at_integer() || tokens_.at_word("read") || at_section(kEdges) ||
                 at_section(kFaces) || at_section(kBodies)));
    }

    void read_vertex(int id, int line) {
        vertex_ids_.add(id, line);
        Vertex vertex{id, line, {}};
        for (double* coordinate : {&vertex.point.x(), &vertex.point.y()}) {
            if (at_element_end()) {
                tokens_.fail(line, fmt::format("vertex {}: expected two coordinates", id));
            }
            *coordinate = take_expression(tokens_, parameters_);
        }
        read_attributes([&](const std::string& word, int) {
            if (word == "boundary") {
                tokens_.fail(line, fmt::format("vertex {}: boundaries are not supported", id));
            }
        });
        mesh_.vertices.push_back(vertex);
    }

    void read_edge(int id, int line) {
        edge_ids_.add(id, line);
        const std::string name = fmt::format("edge {}", id);
        Edge edge{id, line, take_vertex(name), take_vertex(name), {}, 1.0};
        if (!tokens_.at_line_start() && tokens_.at_integer() && !at_wrap()) {
            take_vertex(name);  // skips a midpoint: pressures determine the arc
        }
        edge.wrap = take_wrap_symbols();
        read_attributes([&](const std::string& word, int attribute_line) {
            if (word == "wrap") {
                edge.wrap = take_wrap_number();
            } else if (word == "density" || word == "tension") {
                edge.tension = take_expression(tokens_, parameters_);
            } else if (word == "energy" || word == "boundary") {
                tokens_.fail(attribute_line, fmt::format("{}: {} is not supported", name, word));
            }
        });
        mesh_.edges.push_back(edge);
    }

    // Reads the number of a vertex to which the element `user` refers. Returns the index of this
    // vertex.
    std::size_t take_vertex(const std::string& user) {
        const int line = tokens_.peek().line;
        return vertex_ids_.index_of(tokens_.take_integer("a vertex number"), line, user);
    }

    bool at_wrap() const {
        return tokens_.at_symbol('*') || tokens_.at_symbol('+') || tokens_.at_symbol('-');
    }

    std::optional<LatticeOffset> take_wrap_symbols() {
        if (tokens_.at_line_start() || !at_wrap()) {
            return std::nullopt;
        }
        LatticeOffset wrap;
        for (std::int32_t* periods : {&wrap.i, &wrap.j}) {
            if (tokens_.at_line_start() || !at_wrap()) {
                tokens_.fail_expecting("a second wrap symbol, '*', '+' or '-'");
            }
            const Token token = tokens_.take();
            *periods = token.is_symbol('*') ? 0 : (token.is_symbol('+') ? 1 : -1);
        }
        return wrap;
    }

    LatticeOffset take_wrap_number() {
        const auto bits = static_cast<unsigned>(tokens_.take_integer("a wrap number"));
        return {decoded_wrap(bits), decoded_wrap(bits >> kWrapBits)};
    }

    void read_face(int id, int line) {
        face_ids_.add(id, line);
        Face face{id, line, {}, false};
        const std::string name = fmt::format("face {}", id);
        while (at_integer_of_element()) {
            const int edge_line = tokens_.peek().line;
            const int edge = tokens_.take_integer("an edge number");
            face.sides.push_back({edge_ids_.index_of(std::abs(edge), edge_line, name), edge > 0});
        }
        if (face.sides.empty()) {
            tokens_.fail(line, fmt::format("{} has no edges", name));
        }
        read_attributes([](const std::string&, int) {});
        mesh_.faces.push_back(std::move(face));
    }

    void read_body(int id, int line) {
        body_ids_.add(id, line);
        const std::string name = fmt::format("body {}", id);
        Body body{id, line, 0, false, {}, {}};
        const int face = tokens_.take_integer("a face number");
        body.face = face_ids_.index_of(std::abs(face), line, name);
        body.reversed = face < 0;
        if (at_integer_of_element()) {
            tokens_.fail(line, fmt::format("{} has more than one face", name));
        }
        if (std::exchange(mesh_.faces[body.face].has_body, true)) {
            tokens_.fail(line, fmt::format("{}: face {} already has a body", name, std::abs(face)));
        }
        read_attributes([&](const std::string& word, int attribute_line) {
            if (word == "volume") {
                body.volume = take_expression(tokens_, parameters_);
            } else if (word == "lagrange_multiplier") {
                body.pressure = take_expression(tokens_, parameters_);
            } else if (word == "pressure") {
                tokens_.fail(attribute_line,
                             fmt::format("{}: a prescribed pressure is not supported; give a "
                                         "volume, and the pressure as lagrange_multiplier",
                                         name));
            }
        });
        mesh_.bodies.push_back(body);
    }

    // Returns true if an integer follows on the same line.
    bool at_integer_of_element() const { return !tokens_.at_line_start() && tokens_.at_integer(); }

    // Reads the attributes of an element. Passes each word and its line to `handle`, which may read
    // the values that follow the word. Skips all other tokens. Counts the element in
    // Mesh::constrained_count if it is fixed or has constraints. Throws FormatError if the first
    // token is not a word.
    template <class Handle>
    void read_attributes(Handle handle) {
        if (!at_element_end() && tokens_.peek().kind != TokenKind::Word) {
            tokens_.fail_expecting("an attribute or the end of the line");
        }
        bool is_constrained = false;
        while (!at_element_end()) {
            const Token token = tokens_.take();
            if (token.kind == TokenKind::Word) {
                const std::string word = lower(token.text);
                is_constrained = is_constrained || word == "fixed" || word == "constraint" ||
                                 word == "constraints";
                handle(word, token.line);
            }
        }
        mesh_.constrained_count += is_constrained ? 1 : 0;
    }

    TokenReader& tokens_;
    const Parameters& parameters_;
    Mesh mesh_;
    IdTable vertex_ids_{tokens_, "vertex"};
    IdTable edge_ids_{tokens_, "edge"};
    IdTable face_ids_{tokens_, "face"};
    IdTable body_ids_{tokens_, "body"};
};

}  // namespace

Mesh read_mesh(TokenReader& tokens, const Parameters& parameters) {
    return MeshReader(tokens, parameters).read();
}

}  // namespace foam::evolver
