// SPDX-License-Identifier: Apache-2.0

#include "texgen/image/exr_zip.h"

#include "core/parallel/parallel_for.h"
#include "texgen/image/byte_order.h"
#include "texgen/image/deflate.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

// The format of OpenEXR ("OpenEXR File Layout" in its documentation): after the header come the
// offsets of all chunks in the file. A chunk has the number of its first row, the size of its data,
// and the data. If a zlib stream (RFC 1950) of the samples is smaller than the samples, the data is
// this stream; otherwise the data is the samples themselves. The samples of a chunk are sorted by
// rows, and within a row by channels. Before the compression, the bytes with even indices are moved
// to the front, followed by those with odd indices. Each byte except the first is then replaced by
// its difference from the preceding byte, plus 128.
//
// The functions below compress without OpenEXR, because OpenEXR 3.1 uses zlib. For output of the
// same size, zlib takes several times as long as Deflater (deflate.h).

namespace foam::texgen {

namespace {

// The buffers of one thread.
struct ZipWorker {
    Bytes samples;    // the samples of a chunk
    Bytes parted;     // the bytes of `samples` with even indices, then those with odd indices
    Bytes predicted;  // the differences of the bytes of `parted`
    Deflater deflater;
};

// Sets `samples` to the samples of the rows from `first` up to, but not including, `last`. Rows are
// counted from the top.
void gather_rows(const ExrPlanes& planes, int first, int last, Bytes& samples) {
    samples.clear();
    for (int row = first; row < last; ++row) {
        for (const ExrPlane& plane : planes.planes()) {
            append(samples, plane.row(row));
        }
    }
}

// Computes `worker.parted` and `worker.predicted` from `worker.samples`.
void predict(ZipWorker& worker) {
    const std::size_t size = worker.samples.size();
    const std::size_t half = (size + 1) / 2;
    worker.parted.resize(size);
    worker.predicted.resize(size);
    const auto* const from = reinterpret_cast<const std::uint8_t*>(worker.samples.data());
    auto* const parted = reinterpret_cast<std::uint8_t*>(worker.parted.data());
    auto* const predicted = reinterpret_cast<std::uint8_t*>(worker.predicted.data());
    for (std::size_t k = 0; k < size / 2; ++k) {
        parted[k] = from[2 * k];
        parted[half + k] = from[2 * k + 1];
    }
    if (size % 2 == 1) {
        parted[half - 1] = from[size - 1];
    }
    predicted[0] = parted[0];
    for (std::size_t k = 1; k < size; ++k) {
        predicted[k] = static_cast<std::uint8_t>(parted[k] - parted[k - 1] + 128);
    }
}

// Returns a chunk of the rows from `first` up to, but not including, `last`.
Bytes chunk_of(const ExrPlanes& planes, int first, int last, int level, ZipWorker& worker) {
    gather_rows(planes, first, last, worker.samples);
    predict(worker);
    const Bytes zlib = worker.deflater.zlib_stream(level, worker.predicted);
    const Bytes& data = zlib.size() < worker.samples.size() ? zlib : worker.samples;
    Bytes chunk;
    append(chunk, little_endian(static_cast<std::uint32_t>(first)));
    append(chunk, little_endian(static_cast<std::uint32_t>(data.size())));
    append(chunk, data);
    return chunk;
}

}  // namespace

void append_zip_chunks(const ExrPlanes& planes, const ExrZip& options, Bytes& file) {
    const int rows = options.rows_per_chunk;
    const int count = (planes.height() + rows - 1) / rows;
    std::vector<Bytes> chunks(static_cast<std::size_t>(count));
    std::vector<ZipWorker> workers(
        static_cast<std::size_t>(std::min(thread_count(options.threads), count)));
    parallel_for(count, workers, [&](ZipWorker& worker, int k) {
        const int first = k * rows;
        const int last = std::min(first + rows, planes.height());
        chunks[static_cast<std::size_t>(k)] = chunk_of(planes, first, last, options.level, worker);
    });
    std::size_t offset = file.size() + chunks.size() * sizeof(std::uint64_t);
    for (const Bytes& chunk : chunks) {
        append(file, little_endian(std::uint64_t{offset}));
        offset += chunk.size();
    }
    file.reserve(offset);
    for (const Bytes& chunk : chunks) {
        append(file, chunk);
    }
}

}  // namespace foam::texgen
