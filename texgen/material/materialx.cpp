// SPDX-License-Identifier: Apache-2.0

#include "texgen/material/materialx.h"

#include "texgen/material/identifier.h"
#include "texgen/material/xml_writer.h"

#include <fmt/format.h>

#include <string_view>

namespace foam::texgen {

namespace {

// A node of the MaterialX node graph: its name and the type of its output.
struct Node {
    std::string name;
    std::string type;
};

std::string numbers(double x, double y, double z) {
    return fmt::format("{}, {}, {}", x, y, z);
}

// Returns MaterialX's name of the color space of an image.
const char* color_space_of(const SceneImage& image) {
    const std::string& space = image.samples().color_space;
    return space == "sRGB" ? "srgb_texture" : space == "ACEScg" ? "acescg" : "lin_rec709";
}

// Returns MaterialX's name of the type of a pixel of an image, such as "color3".
std::string type_of(const SceneImage& image) {
    const std::size_t channels = image.channels.size();
    return channels == 1 ? "float"
                         : fmt::format("{}{}", image.is_color() ? "color" : "vector", channels);
}

class MaterialXWriter {
  public:
    explicit MaterialXWriter(const SceneMaterial& material) : material_(material) {}

    std::string write() {
        xml_.begin("materialx", {{"version", "1.38"}, {"colorspace", "lin_rec709"}});
        write_comment();
        write_graph();
        write_surface();
        write_material();
        xml_.end();
        return xml_.text();
    }

  private:
    void write_comment() {
        if (material_.frames.size() > 1) {
            xml_.comment(fmt::format(
                "The images are those of frame {}, the first of {} frames. Programs that know the "
                "frame tokens of MaterialX play all frames if the N digits of the frame number in "
                "the names of the files are replaced by {{0Nframe}}, such as {{04frame}} for 4 "
                "digits.",
                material_.frames.front(),
                material_.frames.size()));
        }
    }

    void input(std::string_view name, std::string_view type, const std::string& value) {
        xml_.element("input",
                     {{"name", std::string(name)}, {"type", std::string(type)}, {"value", value}});
    }
    void input(std::string_view name, const Node& node) {
        xml_.element("input",
                     {{"name", std::string(name)}, {"type", node.type}, {"nodename", node.name}});
    }

    // Begins a node of the graph; the caller writes its inputs and ends it. If another node already
    // has this name, a number is appended to the name.
    Node begin(std::string_view category, std::string_view name, std::string_view type) {
        Node node{names_.unique(name), std::string(type)};
        xml_.begin(category, {{"name", node.name}, {"type", node.type}});
        return node;
    }
    // Writes a node that computes its output from another node. If `second_input` is not empty, it
    // is the name of a second input, which has the given value.
    Node computed(std::string_view category,
                  const std::string& name,
                  const Node& source,
                  std::string_view second_input,
                  const std::string& value) {
        Node node = begin(category, name, source.type);
        input(category == "invert" ? "in" : "in1", source);
        if (!second_input.empty()) {
            input(second_input, source.type, value);
        }
        xml_.end();
        return node;
    }

    void write_images() {
        for (const SceneImage& image : material_.images) {
            images_.push_back(
                begin(material_.tiles ? "tiledimage" : "image", image.id, type_of(image)));
            XmlWriter::Attributes file{
                {"name", "file"}, {"type", "filename"}, {"value", image.paths.front()}};
            if (image.is_color()) {
                file.emplace_back("colorspace", color_space_of(image));
            }
            xml_.element("input", file);
            for (const char* const mode : {"uaddressmode", "vaddressmode"}) {
                if (!material_.tiles) {
                    input(mode, "string", "clamp");
                }
            }
            xml_.end();
        }
    }

    // Returns a node with the colors of an image, not multiplied by the opacity.
    Node color_of(std::size_t index) {
        const SceneImage& image = material_.images[index];
        const Node& whole = images_[index];
        if (whole.type != "color4") {
            return whole;
        }
        Node color = begin("convert", whole.name + "_rgb", "color3");
        input("in", whole);
        xml_.end();
        return image.is_premultiplied()
                   ? divided(color, number_of({index, image.channels.size() - 1}))
                   : color;
    }

    // Divides premultiplied colors by their opacity. The node unpremult is not used, because its
    // implementation in the GLSL of MaterialX divides by 0 where the opacity is 0.
    Node divided(const Node& color, const Node& opacity) {
        const Node divisor =
            computed("max", opacity.name + "_positive", opacity, "in2", "0.000001");
        Node straight = begin("divide", color.name + "_straight", color.type);
        input("in1", color);
        input("in2", divisor);
        xml_.end();
        return straight;
    }

    // Returns a node with the numbers of a channel.
    Node number_of(const SceneChannel& channel) {
        const SceneImage& image = material_.images[channel.image];
        Node number = images_[channel.image];
        if (number.type != "float") {
            const Node whole = number;
            number = begin("extract", fmt::format("{}_{}", whole.name, channel.channel), "float");
            input("in", whole);
            input("index", "integer", fmt::format("{}", channel.channel));
            xml_.end();
        }
        const bool is_inverted = image.scale.at(channel.channel) < 0.0;
        return is_inverted ? computed("invert", number.name + "_inverted", number, "", "") : number;
    }

    // The node normalmap expects vectors that are encoded as numbers from 0 to 1, with y up.
    Node normal_of(std::size_t index) {
        const std::array<double, 4>& scale = material_.images[index].scale;
        const std::array<double, 4>& bias = material_.images[index].bias;
        Node encoded = images_[index];
        if (scale != std::array{2.0, 2.0, 2.0, 1.0}) {
            encoded = computed("multiply",
                               encoded.name + "_scaled",
                               encoded,
                               "in2",
                               numbers(scale[0] / 2.0, scale[1] / 2.0, scale[2] / 2.0));
            encoded = computed(
                "add",
                images_[index].name + "_encoded",
                encoded,
                "in2",
                numbers((bias[0] + 1.0) / 2.0, (bias[1] + 1.0) / 2.0, (bias[2] + 1.0) / 2.0));
        }
        Node normal = begin("normalmap", "normalmap", "vector3");
        input("in", encoded);
        xml_.end();
        return normal;
    }

    Node gray_of(const Node& number) {
        Node color = begin("convert", number.name + "_rgb", "color3");
        input("in", number);
        xml_.end();
        return color;
    }

    // Connects an input of the surface to a node of the graph. kHeight is not an input of the
    // surface: it stands for the input of the displacement.
    void use(std::string_view surface_input, const Node& node) {
        outputs_.push_back({std::string(surface_input), node});
    }
    void use_number(std::string_view surface_input, const std::optional<SceneChannel>& channel) {
        if (channel) {
            use(surface_input, number_of(*channel));
        }
    }

    void write_graph() {
        xml_.begin("nodegraph", {{"name", kGraph}});
        write_images();
        use_number("base", material_.occlusion);
        if (material_.base_color) {
            use("base_color", color_of(*material_.base_color));
        }
        use_number("metalness", material_.metallic);
        use_number("specular_roughness", material_.roughness);
        if (material_.lit || material_.emission) {
            use("emission_color", color_of(material_.lit ? *material_.lit : *material_.emission));
        }
        if (material_.normal) {
            use("normal", normal_of(*material_.normal));
        }
        if (material_.opacity) {
            use("opacity", gray_of(number_of(*material_.opacity)));
        }
        use_number(kHeight, material_.height);
        for (const auto& [name, node] : outputs_) {
            xml_.element("output", {{"name", name}, {"type", node.type}, {"nodename", node.name}});
        }
        xml_.end();
    }

    void connect(std::string_view name, std::string_view output, std::string_view type) {
        xml_.element("input",
                     {{"name", std::string(name)},
                      {"type", std::string(type)},
                      {"nodegraph", kGraph},
                      {"output", std::string(output)}});
    }

    void write_surface() {
        xml_.begin("standard_surface", {{"name", kSurface}, {"type", "surfaceshader"}});
        if (material_.lit) {  // the colors of the map `lit` contain all reflected light
            input("base", "float", "0");
            input("specular", "float", "0");
        } else if (!material_.base_color) {
            input("base_color", "color3", "0.5, 0.5, 0.5");
        }
        if (material_.lit || material_.emission) {
            input("emission", "float", "1");
        }
        for (const auto& [name, node] : outputs_) {
            const bool is_replaced = material_.lit && name == "base";
            if (name != kHeight && !is_replaced) {
                connect(name, name, node.type);
            }
        }
        xml_.end();
    }

    void write_material() {
        if (material_.height) {
            xml_.begin("displacement", {{"name", kDisplacement}, {"type", "displacementshader"}});
            connect("displacement", kHeight, "float");
            input("scale", "float", fmt::format("{}", material_.displacements.front()));
            xml_.end();
        }
        xml_.begin("surfacematerial", {{"name", "M_" + material_.id}, {"type", "material"}});
        input("surfaceshader", {kSurface, "surfaceshader"});
        if (material_.height) {
            input("displacementshader", {kDisplacement, "displacementshader"});
        }
        xml_.end();
    }

    static constexpr const char* kGraph = "images";
    static constexpr const char* kSurface = "surface";
    static constexpr const char* kDisplacement = "displacement";
    static constexpr const char* kHeight = "height";

    const SceneMaterial& material_;
    XmlWriter xml_;
    Identifiers names_;         // the names of the nodes of the graph
    std::vector<Node> images_;  // the nodes of the images of the material
    // The outputs of the graph: their names, and the nodes that compute them. Each output has the
    // name of the input of the surface to which it belongs, or the name kHeight.
    std::vector<std::pair<std::string, Node>> outputs_;
};

}  // namespace

std::string materialx_text(const SceneMaterial& material) {
    return MaterialXWriter(material).write();
}

}  // namespace foam::texgen
