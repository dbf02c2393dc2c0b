// SPDX-License-Identifier: Apache-2.0
//
// Reads KTX2 files of foamtex with ktx-parse, decompresses their mip levels with fzstd, and compares them with DDS files and
// PNGs of the same frames. See ktx2.sh.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import { import_package } from "../browser/packages.mjs";
import { read_dds } from "./dds_file.mjs";
import { formats } from "./ktx2_formats.mjs";

const ktx = await import_package("interop", "ktx-parse");
const { decompress } = await import_package("interop", "fzstd");
const zstandard = 2; // KHR_SUPERCOMPRESSION_ZSTD
const bt709 = 1; // KHR_DF_PRIMARIES_BT709

function check_header(file, format, size, layers) {
    assert.equal(file.vkFormat, format.vkFormat);
    assert.equal(file.typeSize, format.typeSize);
    assert.deepEqual([file.pixelWidth, file.pixelHeight, file.pixelDepth], [...size, 0]);
    assert.deepEqual([file.layerCount, file.faceCount], [layers, 1]);
    assert.equal(file.levels.length, Math.log2(Math.max(...size)) + 1);
    assert.equal(file.supercompressionScheme, zstandard);
}

function check_descriptor(descriptor, format) {
    assert.equal(descriptor.versionNumber, 2);
    assert.equal(descriptor.colorModel, format.model);
    assert.equal(descriptor.colorPrimaries, bt709);
    assert.equal(descriptor.transferFunction, format.transfer);
    assert.equal(descriptor.flags, 0); // alpha is not premultiplied
    assert.deepEqual(descriptor.texelBlockDimension, format.texelBlockDimension);
    assert.deepEqual(descriptor.bytesPlane, [format.bytes, 0, 0, 0, 0, 0, 0, 0]);
    const samples = descriptor.samples.map((sample) => {
        assert.equal(sample.sampleLower, 0);
        return [sample.bitOffset, sample.bitLength, sample.channelType, sample.sampleUpper];
    });
    assert.deepEqual(samples, format.samples);
}

// Checks the keys, which must be sorted. `animation` has the three numbers of KTXanimData, or is null. If a format has alpha
// but the images are opaque, the file says so.
function check_values(values, format, { animation, opaque = true }) {
    const keys = Object.keys(values);
    assert.deepEqual(keys, [...keys].sort());
    assert.match(values.KTXwriter, /^foamtex \d+\.\d+/);
    assert.equal(values.KTXorientation, "rd");
    assert.equal(values.KTXswizzle, format.has_alpha && opaque ? "rgb1" : undefined);
    if (animation === null) {
        assert.ok(!("KTXanimData" in values));
        return;
    }
    // ktx-parse takes the value for a text and drops the last byte, which is 0.
    const bytes = Buffer.from(`${values.KTXanimData}\0`, "latin1");
    assert.deepEqual([0, 4, 8].map((offset) => bytes.readUInt32LE(offset)), animation);
}

// Returns the decompressed mip levels.
function levels_of(file) {
    return file.levels.map((level) => {
        const bytes = decompress(level.levelData);
        assert.equal(bytes.length, level.uncompressedByteLength);
        return bytes;
    });
}

// A level of a KTX2 holds the images of all layers. They must be the images of the DDS.
function check_images(levels, dds) {
    levels.forEach((level, k) => {
        assert.ok(Buffer.concat(dds.layers.map((layer) => layer[k])).equals(level), `level ${k} differs from the DDS`);
    });
    assert.ok(dds.layers.every((layer) => layer.length === levels.length));
}

// Returns the codes of a PNG, of one layer of a texture with uncompressed texels, as ImageMagick reads it.
function codes_of(png, format, opaque) {
    const count = format.samples.length;
    const order = { 1: "gray", 2: "rgb", 4: "rgba" }[count];
    const bits = 8 * format.typeSize;
    const args = [png, "-alpha", count < 4 ? "off" : opaque ? "opaque" : "on", "-depth", bits, "-endian", "LSB", `${order}:-`];
    const bytes = execFileSync("/usr/bin/convert", args.map(String), { maxBuffer: 1 << 28 });
    const pixel = 3 * format.typeSize;
    return count === 2 ? Buffer.from(bytes.filter((_, k) => k % pixel < 2 * format.typeSize)) : bytes;
}

function check(name, file, facts) {
    const { format, size, layers, dds, pngs, opaque = true } = facts;
    const expected = formats[format];
    const texture = ktx.read(fs.readFileSync(file));
    check_header(texture, expected, size, layers);
    check_descriptor(texture.dataFormatDescriptor[0], expected);
    check_values(texture.keyValue, expected, facts);
    const levels = levels_of(texture);
    const same = read_dds(dds);
    assert.equal(same.format, expected.dxgi);
    check_images(levels, same);
    if (expected.texelBlockDimension[0] === 0) {
        const codes = Buffer.concat(pngs.map((png) => codes_of(png, expected, opaque)));
        assert.ok(codes.equals(levels[0]), "the pixels differ from those of the PNG");
    }
    const bytes = levels.reduce((sum, level) => sum + level.length, 0);
    console.log(`${name}: ${format}, ${Math.max(1, layers)} layers, ${levels.length} levels, ${bytes} bytes are the same`);
}

// The formats of single textures, and those of images of 8 bits without block compression.
const single = {
    albedo: "BC7_UNORM_SRGB",
    ORM: "BC7_UNORM",
    normal: "BC5_UNORM",
    roughness: "BC4_UNORM",
    height: "R16_UNORM",
    id: "R16_UNORM",
    motion: "R16G16_UNORM",
    wide: "R16G16B16A16_UNORM",
};
const uncompressed = {
    albedo: "R8G8B8A8_UNORM_SRGB",
    ORM: "R8G8B8A8_UNORM",
    normal: "R8G8B8A8_UNORM",
    roughness: "R8_UNORM",
};

const folder = process.argv[2];
const size = process.argv[3].split("x").map(Number);
const frames = ["0001", "0033", "0065"];
const description = JSON.parse(fs.readFileSync(`${folder}/array/lava_array.json`));
// Every 32nd of 96 frames, at 24 frames per second: a frame lasts 32/24 seconds, and the loop has no end.
const animation = [32, 24, 0];
assert.equal(description.frames_per_second, 24 / 32);
assert.equal(description.loop.closes, true);
for (const [map, format] of Object.entries(single)) {
    const pngs = frames.map((frame) => `${folder}/png/${map}.${frame}.png`);
    const common = { format, size };
    check(map, `${folder}/ktx2/${map}.0033.ktx2`, {
        ...common, layers: 0, animation: null, dds: `${folder}/dds/${map}.0033.dds`, pngs: pngs.slice(1, 2),
    });
    const array = `${folder}/array/lava_array_${map}`;
    check(`array of ${map}`, `${array}.ktx2`, {
        ...common, layers: frames.length, animation, dds: `${array}.dds`, pngs,
    });
}
for (const [map, format] of Object.entries(uncompressed)) {
    const of_map = (folder_name) => `${folder}/${folder_name}/${map}.0033`;
    check(`${map} without blocks`, `${of_map("plain_ktx2")}.ktx2`, {
        format, size, layers: 0, animation: null, dds: `${of_map("plain_dds")}.dds`, pngs: [`${of_map("png")}.png`],
    });
}
for (const [folder_name, format] of [["", "BC7_UNORM_SRGB"], ["plain_", "R8G8B8A8_UNORM_SRGB"]]) {
    check(`${folder_name}image with alpha`, `${folder}/${folder_name}ktx2/transparent.ktx2`, {
        format, size, layers: 0, animation: null, opaque: false,
        dds: `${folder}/${folder_name}dds/transparent.dds`, pngs: [`${folder}/png/transparent.png`],
    });
}
