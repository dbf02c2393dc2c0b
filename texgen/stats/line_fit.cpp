#include "texgen/stats/line_fit.h"

namespace foam::texgen {

LineFit fit_line(std::span<const ChartPoint> points) {
    const auto count = static_cast<double>(points.size());
    ChartPoint mean;
    for (const ChartPoint& point : points) {
        mean.x += point.x / count;
        mean.y += point.y / count;
    }
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    for (const ChartPoint& point : points) {
        xx += (point.x - mean.x) * (point.x - mean.x);
        xy += (point.x - mean.x) * (point.y - mean.y);
        yy += (point.y - mean.y) * (point.y - mean.y);
    }
    const double slope = xy / xx;
    return {mean.y - slope * mean.x, slope, yy > 0.0 ? xy * xy / (xx * yy) : 1.0};
}

}  // namespace foam::texgen
