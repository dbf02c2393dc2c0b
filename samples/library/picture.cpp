// SPDX-License-Identifier: Apache-2.0

// Draws maps of a few frames into buffers of this program, and writes the colors as PPM files.
// Usage: picture [FOLDER]

#include <foamtex/texture.h>

#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

int main(int argc, char** argv) try {
    const std::string folder = argc > 1 ? argv[1] : ".";
    const foamtex::Preset preset("lava", {{"image.size", "[256, 256]"}, {"foam.seed", "5"}});
    foamtex::Simulation simulation(preset, "1-24x8");
    while (const auto frame = simulation.next()) {
        const foamtex::ImageShape shape = frame->shape("albedo", true);
        std::vector<std::uint8_t> colors(shape.size());
        frame->draw("albedo", std::span(colors));  // the samples of the PNG that foamtex bakes

        std::vector<float> height(frame->shape("height").size());
        frame->draw("height", std::span(height));
        float highest = 0.0F;
        for (const float value : height) {
            highest = value > highest ? value : highest;
        }

        const std::string name = folder + "/lava_" + std::to_string(frame->number()) + ".ppm";
        std::ofstream file(name, std::ios::binary);
        file << "P6\n" << shape.width << ' ' << shape.height << "\n255\n";
        file.write(reinterpret_cast<const char*>(colors.data()),
                   static_cast<std::streamsize>(colors.size()));
        if (!file.flush()) {
            throw foamtex::OutputError("cannot write '" + name + "'");
        }
        std::printf("%s: %zu bubbles, height up to %.3f\n",
                    name.c_str(),
                    frame->records().bubbles.size(),
                    static_cast<double>(highest));
    }
    return 0;
} catch (const foamtex::Error& error) {
    std::fprintf(stderr, "picture: %s\n", error.what());
    return 1;
}
