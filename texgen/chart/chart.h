#pragma once

#include "texgen/image/color.h"

#include <string>
#include <vector>

namespace foam::texgen {

enum class AxisKind {
    Linear,
    Logarithmic,  // shows positive values only
};

struct Axis {
    std::string label;  // the quantity and its unit
    AxisKind kind = AxisKind::Linear;
};

struct ChartPoint {
    double x = 0.0;
    double y = 0.0;
};

/// How the points of a series are drawn.
enum class Mark {
    Line,  // from point to point
    DashedLine,
    Discs,
    Circles,
    Diamonds,
};

struct Series {
    std::string name;  // in the legend; a series without a name is not there
    Mark mark = Mark::Line;
    Srgb8 color;
    std::vector<ChartPoint> points;  // those that are not finite, or off a logarithm, are left out
};

/// The values of y between two lines, over the whole width; positive ones on a logarithm.
struct Band {
    std::string name;
    double low = 0.0;
    double high = 0.0;
    Srgb8 color;
};

/// A diagram of y over x. The axes take in every point and every band.
struct Chart {
    std::string title;
    Axis x;
    Axis y;
    std::vector<Band> bands;     // behind the series
    std::vector<Series> series;  // the later over the earlier
};

}  // namespace foam::texgen
