// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <array>
#include <cstdint>

namespace foam::texgen {

// Colors of ColorBrewer, https://colorbrewer2.org (copyright 2002 Cynthia Brewer, Mark Harrower and
// The Pennsylvania State University, Apache-2.0), evenly spaced on a scale and in Matplotlib's
// order.

inline constexpr std::array<std::uint32_t, 11> kSpectral = {0x9e0142,
                                                            0xd53e4f,
                                                            0xf46d43,
                                                            0xfdae61,
                                                            0xfee08b,
                                                            0xffffbf,
                                                            0xe6f598,
                                                            0xabdda4,
                                                            0x66c2a5,
                                                            0x3288bd,
                                                            0x5e4fa2};
inline constexpr std::array<std::uint32_t, 11> kRdBu = {0x67001f,
                                                        0xb2182b,
                                                        0xd6604d,
                                                        0xf4a582,
                                                        0xfddbc7,
                                                        0xf7f7f7,
                                                        0xd1e5f0,
                                                        0x92c5de,
                                                        0x4393c3,
                                                        0x2166ac,
                                                        0x053061};
inline constexpr std::array<std::uint32_t, 11> kRdYlBu = {0xa50026,
                                                          0xd73027,
                                                          0xf46d43,
                                                          0xfdae61,
                                                          0xfee090,
                                                          0xffffbf,
                                                          0xe0f3f8,
                                                          0xabd9e9,
                                                          0x74add1,
                                                          0x4575b4,
                                                          0x313695};
inline constexpr std::array<std::uint32_t, 11> kBrBG = {0x543005,
                                                        0x8c510a,
                                                        0xbf812d,
                                                        0xdfc27d,
                                                        0xf6e8c3,
                                                        0xf5f5f5,
                                                        0xc7eae5,
                                                        0x80cdc1,
                                                        0x35978f,
                                                        0x01665e,
                                                        0x003c30};
inline constexpr std::array<std::uint32_t, 11> kPuOr = {0x7f3b08,
                                                        0xb35806,
                                                        0xe08214,
                                                        0xfdb863,
                                                        0xfee0b6,
                                                        0xf7f7f7,
                                                        0xd8daeb,
                                                        0xb2abd2,
                                                        0x8073ac,
                                                        0x542788,
                                                        0x2d004b};
inline constexpr std::array<std::uint32_t, 9> kYlGnBu = {
    0xffffd9, 0xedf8b1, 0xc7e9b4, 0x7fcdbb, 0x41b6c4, 0x1d91c0, 0x225ea8, 0x253494, 0x081d58};
inline constexpr std::array<std::uint32_t, 9> kYlOrRd = {
    0xffffcc, 0xffeda0, 0xfed976, 0xfeb24c, 0xfd8d3c, 0xfc4e2a, 0xe31a1c, 0xbd0026, 0x800026};
inline constexpr std::array<std::uint32_t, 9> kBlues = {
    0xf7fbff, 0xdeebf7, 0xc6dbef, 0x9ecae1, 0x6baed6, 0x4292c6, 0x2171b5, 0x08519c, 0x08306b};
inline constexpr std::array<std::uint32_t, 9> kGreens = {
    0xf7fcf5, 0xe5f5e0, 0xc7e9c0, 0xa1d99b, 0x74c476, 0x41ab5d, 0x238b45, 0x006d2c, 0x00441b};

}  // namespace foam::texgen
