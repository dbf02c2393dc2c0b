// SPDX-License-Identifier: Apache-2.0
//
// Reads DDS files with the header of Direct3D 10, as Microsoft's reference of DDS_HEADER and DDS_HEADER_DXT10 describes them.

import fs from "node:fs";

// The number of bytes of a block of 4 x 4 texels, or of a texel, by DXGI_FORMAT.
const blocks = { 80: 8, 83: 16, 98: 16, 99: 16 };
const texels = { 11: 8, 28: 4, 29: 4, 35: 4, 56: 2, 61: 1 };

function image_bytes(format, width, height) {
    return format in blocks
        ? Math.ceil(width / 4) * Math.ceil(height / 4) * blocks[format]
        : width * height * texels[format];
}

// Returns the number of the format, the size, and for each layer its mip levels as arrays of bytes.
export function read_dds(path) {
    const file = fs.readFileSync(path);
    const number = (index) => file.readUInt32LE(4 * index);
    const dds = { format: number(32), width: number(4), height: number(3), layers: [] };
    let offset = 4 * 37;
    for (let layer = 0; layer < number(35); ++layer) {
        const levels = [];
        for (let level = 0; level < number(7); ++level) {
            const width = Math.max(1, dds.width >> level);
            const height = Math.max(1, dds.height >> level);
            const bytes = image_bytes(dds.format, width, height);
            levels.push(file.subarray(offset, offset + bytes));
            offset += bytes;
        }
        dds.layers.push(levels);
    }
    if (offset !== file.length) {
        throw new Error(`${path}: the images have ${offset} bytes with the headers, but the file has ${file.length}`);
    }
    return dds;
}
