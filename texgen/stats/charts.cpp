#include "texgen/stats/charts.h"

#include "texgen/image/colormap.h"
#include "texgen/stats/line_fit.h"
#include "texgen/stats/scaling_state.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <span>

namespace foam::texgen {

namespace {

// Okabe and Ito's colours, which the colour-blind tell apart.
constexpr Srgb8 kBlue{0x00, 0x72, 0xb2};
constexpr Srgb8 kVermilion{0xd5, 0x5e, 0x00};
constexpr Srgb8 kGrey{0x77, 0x77, 0x77};
constexpr Srgb8 kBlack{0x22, 0x22, 0x22};
constexpr Srgb8 kPaleGreen{0xd3, 0xec, 0xe2};

// Of soap froths in their scaling state.
constexpr double kFrothMoment = 1.4;
constexpr double kFrothMomentError = 0.1;

// One bubble that is about to vanish has a pressure of its own: means are of kinds of bubbles that
// make up this share.
constexpr double kCommonShare = 0.01;

// The paper's Figure 5: a foam that evolves, on one core of a 2 GHz laptop.
constexpr ChartPoint kPaperFirst{10'000.0, 39.5};
constexpr ChartPoint kPaperLast{11.0, 0.084};

constexpr const char* kTime = "time (foam units)";

/// The points that a function makes of the records.
template <class Point>
std::vector<ChartPoint> points_of(std::span<const FrameRecord> records, Point point) {
    std::vector<ChartPoint> points;
    for (const FrameRecord& record : records) {
        points.push_back(point(record));
    }
    return points;
}

/// A mean over all frames, each counted by its bubbles.
struct WeightedMean {
    double sum = 0.0;
    double weight = 0.0;

    void add(double value, double count) {
        sum += value * count;
        weight += count;
    }
    double value() const { return sum / weight; }
};

Chart mean_area_chart(const RunRecord& run) {
    const auto point = [](const FrameRecord& record) {
        return ChartPoint{record.time, record.foam.mean_area};
    };
    Chart chart{"Mean bubble area", {kTime}, {"mean area (foam units)"}, {}, {}};
    chart.series.push_back({"measured", Mark::Discs, kBlue, points_of(measurable(run), point)});
    const std::vector<ChartPoint> scaling = points_of(scaling_state(run), point);
    if (!scaling.empty() && scaling.front().x < scaling.back().x) {
        const LineFit fit = fit_line(scaling);
        const double begin = scaling.front().x;
        const double end = scaling.back().x;
        chart.series.push_back(
            {fmt::format(
                 "{:.3g} + {:.4g} t, R² = {:.4f}", fit.intercept, fit.slope, fit.determination),
             Mark::Line,
             kVermilion,
             {{begin, fit.at(begin)}, {end, fit.at(end)}}});
    }
    return chart;
}

ChartPoint second_moment_point(const FrameRecord& record) {
    return {record.time, record.foam.second_moment};
}

/// A level line through the scaling state, at the mean that counts every bubble of every frame
/// alike.
Series mean_second_moment(std::span<const FrameRecord> scaling) {
    WeightedMean mean;
    for (const FrameRecord& record : scaling) {
        mean.add(record.foam.second_moment, record.foam.bubbles);
    }
    return {fmt::format("mean {:.2f}", mean.value()),
            Mark::DashedLine,
            kVermilion,
            {{scaling.front().time, mean.value()}, {scaling.back().time, mean.value()}}};
}

Chart second_moment_chart(const RunRecord& run) {
    Chart chart{"Second moment of the number of sides",
                {kTime, AxisKind::Logarithmic},
                {"second moment μ₂"},
                {},
                {}};
    chart.bands.push_back({"soap froths, 1.4 ± 0.1",
                           kFrothMoment - kFrothMomentError,
                           kFrothMoment + kFrothMomentError,
                           kPaleGreen});
    chart.series.push_back(
        {"measured", Mark::Line, kBlue, points_of(measurable(run), second_moment_point)});
    const std::span<const FrameRecord> scaling = scaling_state(run);
    if (scaling.size() >= 2) {
        chart.series.push_back(mean_second_moment(scaling));
    }
    return chart;
}

/// A line for each number of sides from 3 to 10 that occurs, in the colours of a map from dark to
/// bright, where the bubbles are no rarer than the least share of all.
template <class Value>
std::vector<Series> series_by_sides(std::span<const FrameRecord> records,
                                    double least_share,
                                    Value value) {
    constexpr int kFewest = 3;
    constexpr int kMost = 10;
    std::vector<Series> series;
    for (int sides = kFewest; sides <= kMost; ++sides) {
        const int entry = 235 * (sides - kFewest) / (kMost - kFewest);
        series.push_back(
            {fmt::format("n = {}", sides), Mark::Line, find_colormap("viridis").entry(entry), {}});
    }
    for (const FrameRecord& record : records) {
        for (const SidesStatistics& part : record.foam.by_sides) {
            const bool is_common = part.bubbles >= least_share * record.foam.bubbles;
            if (is_common && part.sides >= kFewest && part.sides <= kMost) {
                const auto at = static_cast<std::size_t>(part.sides - kFewest);
                series[at].points.push_back({record.time, value(record.foam, part)});
            }
        }
    }
    std::erase_if(series, [](const Series& one) { return one.points.empty(); });
    return series;
}

Chart sides_chart(const RunRecord& run) {
    return {"Distribution of the number of sides",
            {kTime, AxisKind::Logarithmic},
            {"share of the bubbles"},
            {},
            series_by_sides(
                measurable(run), 0.0, [](const FoamStatistics& all, const SidesStatistics& part) {
                    return static_cast<double>(part.bubbles) / all.bubbles;
                })};
}

Chart pressures_chart(const RunRecord& run) {
    return {"Mean pressure by the number of sides",
            {kTime, AxisKind::Logarithmic},
            {"mean pressure (T / √mean area)"},
            {},
            series_by_sides(measurable(run),
                            kCommonShare,
                            [&](const FoamStatistics& all, const SidesStatistics& part) {
                                return part.mean_pressure * std::sqrt(all.mean_area) /
                                       run.film_tension;
                            })};
}

std::vector<ChartPoint> means(const std::map<int, WeightedMean>& by_sides) {
    std::vector<ChartPoint> points;
    points.reserve(by_sides.size());
    for (const auto& [sides, mean] : by_sides) {
        points.push_back({static_cast<double>(sides), mean.value()});
    }
    return points;
}

Chart growth_rates_chart(const RunRecord& run) {
    std::map<int, WeightedMean> by_area;
    std::map<int, WeightedMean> by_films;
    for (const FrameRecord& record : run.frames) {
        for (const SidesGrowth& part : record.growth) {
            by_area[part.sides].add(part.mean_rate, part.bubbles);
        }
        for (const SidesStatistics& part : record.foam.by_sides) {
            by_films[part.sides].add(run.kappa * part.mean_inflow, part.bubbles);
        }
    }
    Chart chart{"von Neumann's law",
                {"number of sides n"},
                {"dA/dt (foam units)"},
                {},
                {{"(2π/3) γ κ (n − 6)", Mark::Line, kGrey, {}}}};
    for (const auto& [sides, mean] : by_films) {
        chart.series[0].points.push_back({static_cast<double>(sides), run.law_rate(sides)});
    }
    chart.series.push_back({"areas between events", Mark::Discs, kBlue, means(by_area)});
    chart.series.push_back({"κ Σ Δp l of the films", Mark::Diamonds, kVermilion, means(by_films)});
    return chart;
}

/// The time of each frame but the first, which comes from the seed; a record's frames are alike.
std::vector<ChartPoint> frame_times(const RunRecord& run) {
    std::vector<ChartPoint> points;
    for (std::size_t k = 1; k < run.frames.size(); ++k) {
        const FrameRecord& record = run.frames[k];
        const int frames = record.frame - run.frames[k - 1].frame;
        points.push_back(
            {static_cast<double>(record.foam.bubbles), record.effort.seconds / frames});
    }
    return points;
}

Chart seconds_chart(const RunRecord& run) {
    Chart chart{"Time of a frame over the evolution",
                {"bubbles", AxisKind::Logarithmic},
                {"time of a frame (s)", AxisKind::Logarithmic},
                {},
                {}};
    chart.series.push_back(
        {"the paper, 2 GHz laptop", Mark::Diamonds, kVermilion, {kPaperFirst, kPaperLast}});
    chart.series.push_back({"foamtex", Mark::Discs, kBlue, frame_times(run)});
    if (!run.frames.empty()) {
        const FrameRecord& first = run.frames.front();
        chart.series.push_back({"foamtex, from the raw diagram",
                                Mark::Circles,
                                kBlack,
                                {{static_cast<double>(first.foam.bubbles), first.effort.seconds}}});
    }
    return chart;
}

}  // namespace

std::vector<NamedChart> charts(const RunRecord& run) {
    return {{"mean_area", mean_area_chart(run)},
            {"second_moment", second_moment_chart(run)},
            {"sides", sides_chart(run)},
            {"pressures", pressures_chart(run)},
            {"growth_rates", growth_rates_chart(run)},
            {"seconds", seconds_chart(run)}};
}

}  // namespace foam::texgen
