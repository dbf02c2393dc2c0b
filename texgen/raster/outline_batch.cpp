#include "texgen/raster/outline_batch.h"

#include <utility>

namespace foam::texgen {

void close_outline(OutlineBatch& batch, BubbleId bubble, std::size_t first_point) {
    const auto chain = std::span<const SubpixelPoint>(batch.points).subspan(first_point);
    SubpixelPoint low = chain.front();
    SubpixelPoint high = low;
    for (const SubpixelPoint point : chain) {
        low = {std::min(low.x, point.x), std::min(low.y, point.y)};
        high = {std::max(high.x, point.x), std::max(high.y, point.y)};
    }
    batch.outlines.push_back({bubble, 0, first_point, chain.size(), low, high});
}

std::int64_t twice_area(std::span<const SubpixelPoint> chain) {
    std::int64_t area = 0;
    SubpixelPoint a = chain.back() - chain.front();
    for (const SubpixelPoint point : chain) {
        const SubpixelPoint b = point - chain.front();
        area += std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x;
        a = b;
    }
    return area;
}

CellOutlines gather(const RasterGrid& grid, std::vector<OutlineBatch>& batches) {
    CellOutlines cells;
    cells.grid = grid;
    for (OutlineBatch& batch : batches) {
        for (Outline& outline : batch.outlines) {
            outline.batch = cells.batches.size();
        }
        cells.outlines.insert(cells.outlines.end(), batch.outlines.begin(), batch.outlines.end());
        cells.batches.push_back(std::move(batch.points));
    }
    return cells;
}

}  // namespace foam::texgen
