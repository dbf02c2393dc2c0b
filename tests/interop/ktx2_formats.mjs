// SPDX-License-Identifier: Apache-2.0
//
// The fields of a KTX2 by pixel format, from the Vulkan specification (VkFormat), the KTX File Format Specification 2.0 and
// the Khronos Data Format Specification 1.3 (KHR_DF).

const rgbsda = 1; // KHR_DF_MODEL_RGBSDA
const bc4 = 131; // KHR_DF_MODEL_BC4
const bc5 = 132; // KHR_DF_MODEL_BC5
const bc7 = 134; // KHR_DF_MODEL_BC7
const linear = 1; // KHR_DF_TRANSFER_LINEAR
const srgb = 2; // KHR_DF_TRANSFER_SRGB
const alpha = 15; // KHR_DF_CHANNEL_RGBSDA_ALPHA
const linear_sample = 0x10; // KHR_DF_SAMPLE_DATATYPE_LINEAR

function compressed(vkFormat, dxgi, model, transfer, bytes, samples) {
    const bits = (8 * bytes) / samples;
    return {
        vkFormat,
        dxgi,
        typeSize: 1,
        model,
        transfer,
        has_alpha: model === bc7,
        texelBlockDimension: [3, 3, 0, 0],
        bytes,
        samples: Array.from({ length: samples }, (_, k) => [k * bits, bits - 1, k, 0xffffffff]),
    };
}

// `channels` are the numbers of the channels in the order of their bytes.
function plain(vkFormat, dxgi, transfer, bits, channels) {
    return {
        vkFormat,
        dxgi,
        typeSize: bits / 8,
        model: rgbsda,
        transfer,
        has_alpha: channels.length === 4,
        texelBlockDimension: [0, 0, 0, 0],
        bytes: (channels.length * bits) / 8,
        samples: channels.map((channel, k) => [k * bits, bits - 1, channel, 2 ** bits - 1]),
    };
}

export const formats = {
    BC4_UNORM: compressed(139, 80, bc4, linear, 8, 1),
    BC5_UNORM: compressed(141, 83, bc5, linear, 16, 2),
    BC7_UNORM: compressed(145, 98, bc7, linear, 16, 1),
    BC7_UNORM_SRGB: compressed(146, 99, bc7, srgb, 16, 1),
    R8_UNORM: plain(9, 61, linear, 8, [0]),
    R16_UNORM: plain(70, 56, linear, 16, [0]),
    R16G16_UNORM: plain(77, 35, linear, 16, [0, 1]),
    R8G8B8A8_UNORM: plain(37, 28, linear, 8, [0, 1, 2, alpha]),
    R8G8B8A8_UNORM_SRGB: plain(43, 29, srgb, 8, [0, 1, 2, alpha | linear_sample]),
    R16G16B16A16_UNORM: plain(91, 11, linear, 16, [0, 1, 2, alpha]),
};
