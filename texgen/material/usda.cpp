// SPDX-License-Identifier: Apache-2.0

#include "texgen/material/usda.h"

#include <fmt/format.h>

#include <functional>
#include <string_view>

namespace foam::texgen {

namespace {

// Returns a text in quotes.
std::string in_quotes(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '\n') {
            escaped += "\\n";
        } else {
            escaped += c == '"' || c == '\\' ? fmt::format("\\{}", c) : std::string(1, c);
        }
    }
    return '"' + escaped + '"';
}

// Returns the path of an image as an asset. It begins with "./", so that it is relative to the
// folder of the scene and not looked up in a list of folders.
std::string asset(const std::string& path) {
    const char* const quotes = path.find('@') == std::string::npos ? "@" : "@@@";
    return fmt::format("{0}./{1}{0}", quotes, path);
}

// Returns a tuple of four numbers. If `channel` is given, the number with this index is multiplied
// by `factor`.
std::string tuple(std::array<double, 4> numbers,
                  std::optional<std::size_t> channel,
                  double factor) {
    if (channel) {
        numbers.at(*channel) *= factor;
    }
    return fmt::format("({})", fmt::join(numbers, ", "));
}

class UsdaWriter {
  public:
    explicit UsdaWriter(const SceneMaterial& material) : material_(material) {}

    std::string write() {
        write_header();
        begin(fmt::format("def Xform \"{}\" (\n    kind = \"component\"\n)", material_.id));
        write_plane();
        write_material();
        end();
        return text_;
    }

  private:
    template <class... Values>
    void line(fmt::format_string<Values...> format, Values&&... values) {
        text_ += std::string(depth_ * 4, ' ') +
                 fmt::format(format, std::forward<Values>(values)...) + '\n';
    }
    void begin(const std::string& head) {
        text_ += text_.ends_with("{\n") ? "" : "\n";
        std::string_view rest = head;
        while (!rest.empty()) {
            const std::size_t end = std::min(rest.find('\n'), rest.size());
            line("{}", rest.substr(0, end));
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
        line("{{");
        ++depth_;
    }
    void end() {
        --depth_;
        line("}}");
    }

    std::string path(std::string_view node) const {
        return fmt::format("/{}/material/{}", material_.id, node);
    }

    void write_header() {
        text_ = "#usda 1.0\n(\n";
        ++depth_;
        line("defaultPrim = \"{}\"", material_.id);
        line("doc = {}", in_quotes(material_.description));
        line("endTimeCode = {}", material_.frames.back());
        line("framesPerSecond = {}", material_.frames_per_second);
        line("metersPerUnit = 1");
        line("startTimeCode = {}", material_.frames.front());
        line("timeCodesPerSecond = {}", material_.frames_per_second);
        line("upAxis = \"Y\"");
        --depth_;
        text_ += ")\n";
    }

    // For displacement, a renderer must subdivide the mesh. With the subdivision scheme "bilinear",
    // the subdivided mesh stays flat.
    void write_plane() {
        const double x = kPlaneWidth / 2.0;
        const double y = material_.plane_height / 2.0;
        begin("def Mesh \"plane\" (\n    prepend apiSchemas = [\"MaterialBindingAPI\"]\n)");
        line("bool doubleSided = true");
        line("float3[] extent = [({}, {}, 0), ({}, {}, 0)]", -x, -y, x, y);
        line("int[] faceVertexCounts = [4]");
        line("int[] faceVertexIndices = [0, 1, 2, 3]");
        line("rel material:binding = </{}/material>", material_.id);
        line("point3f[] points = [({0}, {1}, 0), ({2}, {1}, 0), ({2}, {3}, 0), ({0}, {3}, 0)]",
             -x,
             -y,
             x,
             y);
        line("texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 1)] (");
        line("    interpolation = \"vertex\"");
        line(")");
        line("uniform token subdivisionScheme = \"bilinear\"");
        end();
    }

    void write_material() {
        begin("def Material \"material\"");
        line("token outputs:surface.connect = <{}.outputs:surface>", path("surface"));
        if (material_.height) {
            line("token outputs:displacement.connect = <{}.outputs:displacement>", path("surface"));
        }
        write_surface();
        begin("def Shader \"st\"");
        line("uniform token info:id = \"UsdPrimvarReader_float2\"");
        line("string inputs:varname = \"st\"");
        line("float2 outputs:result");
        end();
        for (std::size_t k = 0; k < material_.images.size(); ++k) {
            write_image(k);
        }
        end();
    }

    void connect(std::string_view input, std::size_t image, std::string_view output) {
        line("{}.connect = <{}.outputs:{}>", input, path(material_.images[image].id), output);
    }
    void connect_color(std::string_view input, std::optional<std::size_t> image) {
        if (image) {
            connect(fmt::format("color3f inputs:{}", input), *image, "rgb");
        }
    }
    void connect_number(std::string_view input, const std::optional<SceneChannel>& channel) {
        if (channel) {
            connect(fmt::format("float inputs:{}", input),
                    channel->image,
                    std::string_view("rgba").substr(channel->channel, 1));
        }
    }

    void write_surface() {
        begin("def Shader \"surface\"");
        line("uniform token info:id = \"UsdPreviewSurface\"");
        connect_color("diffuseColor", material_.base_color);
        connect_color("emissiveColor", material_.lit ? material_.lit : material_.emission);
        if (material_.lit) {  // the colors contain light already, so the surface reflects nothing
            line("color3f inputs:diffuseColor = (0, 0, 0)");
            line("color3f inputs:specularColor = (0, 0, 0)");
            line("int inputs:useSpecularWorkflow = 1");
        } else if (!material_.base_color) {
            line("color3f inputs:diffuseColor = (0.5, 0.5, 0.5)");
        }
        if (material_.normal) {
            connect("normal3f inputs:normal", *material_.normal, "rgb");
        }
        connect_number("roughness", material_.roughness);
        connect_number("metallic", material_.metallic);
        connect_number("occlusion", material_.occlusion);
        connect_number("opacity", material_.opacity);
        connect_number("displacement", material_.height);
        line("token outputs:displacement");
        line("token outputs:surface");
        end();
    }

    // Writes an attribute. value(k) is its value in the frame with the index k. If `varies` is true
    // and there are several frames, each frame gets a time sample; the default value of the
    // attribute is always the value in the first frame.
    void write_samples(std::string_view attribute,
                       const std::function<std::string(std::size_t)>& value,
                       bool varies) {
        line("{} = {}", attribute, value(0));
        if (varies && material_.frames.size() > 1) {
            line("{}.timeSamples = {{", attribute);
            for (std::size_t k = 0; k < material_.frames.size(); ++k) {
                line("    {}: {},", material_.frames[k], value(k));
            }
            line("}}");
        }
    }

    void write_image(std::size_t index) {
        const SceneImage& image = material_.images[index];
        const bool is_height = material_.height && material_.height->image == index;
        const std::optional<std::size_t> height =
            is_height ? std::optional(material_.height->channel) : std::nullopt;
        const auto displacement = [&](std::size_t frame) {
            return is_height ? material_.displacements[frame] : 1.0;
        };
        const bool varies = is_height && !material_.has_one_displacement();
        begin(fmt::format("def Shader \"{}\"", image.id));
        line("uniform token info:id = \"UsdUVTexture\"");
        write_samples(
            "float4 inputs:bias",
            [&](std::size_t k) { return tuple(image.bias, height, displacement(k)); },
            varies && image.bias.at(*height) != 0.0);
        write_samples(
            "asset inputs:file", [&](std::size_t k) { return asset(image.paths[k]); }, true);
        write_samples(
            "float4 inputs:scale",
            [&](std::size_t k) { return tuple(image.scale, height, displacement(k)); },
            varies);
        line("token inputs:sourceColorSpace = \"{}\"",
             image.samples().color_space == "sRGB" ? "sRGB" : "raw");
        line("float2 inputs:st.connect = <{}.outputs:result>", path("st"));
        const char* const wrap = material_.tiles ? "repeat" : "clamp";
        line("token inputs:wrapS = \"{}\"", wrap);
        line("token inputs:wrapT = \"{}\"", wrap);
        for (const char output : std::string_view("rgba").substr(0, image.channels.size())) {
            line("float outputs:{}", output);
        }
        if (image.channels.size() >= 3) {
            line("float3 outputs:rgb");
        }
        end();
    }

    const SceneMaterial& material_;
    std::string text_;
    std::size_t depth_ = 0;
};

}  // namespace

std::string usda_text(const SceneMaterial& material) {
    return UsdaWriter(material).write();
}

}  // namespace foam::texgen
