// SPDX-License-Identifier: Apache-2.0

#include "texgen/cache/state_codec.h"

#include "core/foam/statistics.h"
#include "core/foam/stress.h"
#include "texgen/cache/byte_stream.h"
#include "texgen/cache/frame_check.h"
#include "texgen/cache/frame_codec.h"
#include "texgen/maps/per_bubble.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <memory>

// An encoded state consists of its frame (frame_codec.h), its effort, its record (FoamRecord) and
// its measurements, in this order. The effort and the measurements together are the members of
// FrameEffort. Older versions of foamtex did not store the measurements; their states end after the
// record. In the record, values per bubble are in the order of the bubbles of the frame, followed
// by its lone bubbles. Identities are therefore stored only once, in the frame. A flag precedes
// FoamRecord::first_pressures, the pressures at the end of the warm-up. If the flag is 1, these
// pressures equal the pressures in the file pressures.foam of the cache and are left out. At the
// end of the record are the averages (RecentAverages). A flag precedes them, too; it is 0 if there
// are no averages.

namespace foam::texgen {

namespace {

/// Reads a number. Throws BadContent if it is not plausible. `what` names the number in the
/// message.
double take_number(ByteReader& reader, const char* what) {
    const auto number = reader.take<double>();
    if (!is_plausible(number)) {
        throw BadContent(fmt::format("{} has an impossible value, {}", what, number));
    }
    return number;
}

void write_effort(const FrameEffort& effort, ByteWriter& writer) {
    writer.put(static_cast<std::int32_t>(effort.t1));
    writer.put(static_cast<std::int32_t>(effort.t2));
    writer.put(effort.area_error);
    writer.put(effort.angle_error);
    writer.put(effort.seconds);
}

FrameEffort read_effort(ByteReader& reader) {
    FrameEffort effort;
    effort.t1 = reader.take_integer(0);
    effort.t2 = reader.take_integer(0);
    effort.area_error = take_number(reader, "the largest error of an area");
    effort.angle_error = take_number(reader, "the largest error of an angle");
    effort.seconds = take_number(reader, "the computing time");
    return effort;
}

void write_by_identity(const std::vector<double>& values,
                       const std::vector<BubbleIdentity>& bubbles,
                       ByteWriter& writer) {
    for (const BubbleIdentity bubble : bubbles) {
        writer.put(values.at(bubble));
    }
}

// Returns the number of elements of a vector whose indices are the identities of these bubbles.
std::size_t size_by_identity(const std::vector<BubbleIdentity>& bubbles) {
    const auto largest = std::ranges::max_element(bubbles);
    return largest == bubbles.end() ? 0 : std::size_t{*largest} + 1;
}

std::vector<double> read_by_identity(const std::vector<BubbleIdentity>& bubbles,
                                     ByteReader& reader) {
    std::vector<double> values(size_by_identity(bubbles), 0.0);
    for (const BubbleIdentity bubble : bubbles) {
        values[bubble] = take_number(reader, "the time of a birth or of a change of neighbors");
    }
    return values;
}

void write_events(const std::vector<RecordedEvent>& events, ByteWriter& writer) {
    writer.put(static_cast<std::uint32_t>(events.size()));
    for (const RecordedEvent& event : events) {
        writer.put(static_cast<std::uint8_t>(event.kind));
        writer.put(std::int32_t{event.frame});
        writer.put(event.position.x());
        writer.put(event.position.y());
    }
}

TopologyEventKind read_event_kind(ByteReader& reader) {
    const auto kind = reader.take<std::uint8_t>();
    if (kind > static_cast<std::uint8_t>(TopologyEventKind::Birth)) {
        throw BadContent("unknown kind of topology event");
    }
    return static_cast<TopologyEventKind>(kind);
}

// Reads the events of the record of the frame `record_frame`. They must belong to the
// kRecordedFrames frames that end with this frame.
std::vector<RecordedEvent> read_events(std::int64_t record_frame, ByteReader& reader) {
    constexpr std::size_t kEventBytes = 1 + sizeof(std::int32_t) + 2 * sizeof(double);
    std::vector<RecordedEvent> events(reader.take_count(kEventBytes));
    for (RecordedEvent& event : events) {
        event.kind = read_event_kind(reader);
        event.frame = reader.take_integer(record_frame - kRecordedFrames + 1, record_frame);
        event.position.x() = take_number(reader, "the position of an event");
        event.position.y() = take_number(reader, "the position of an event");
    }
    return events;
}

void write_numbers(const std::vector<double>& numbers, ByteWriter& writer) {
    writer.put(static_cast<std::uint32_t>(numbers.size()));
    for (const double number : numbers) {
        writer.put(number);
    }
}

std::vector<double> read_numbers(ByteReader& reader) {
    std::vector<double> numbers(reader.take_count(sizeof(double)));
    std::ranges::generate(numbers, [&] { return take_number(reader, "a pressure"); });
    return numbers;
}

void write_averages(const RecentAverages& averages,
                    const std::vector<BubbleIdentity>& bubbles,
                    ByteWriter& writer) {
    const bool has_averages = !averages.bubbles.empty();
    writer.put(static_cast<std::uint8_t>(has_averages));
    if (!has_averages) {
        return;
    }
    writer.put(averages.mean_area);
    for (const BubbleIdentity bubble : bubbles) {
        const BubbleValues& values = averages.bubbles.at(bubble);
        writer.put(values.pressure);
        writer.put(values.area);
        writer.put(values.sides);
    }
}

RecentAverages read_averages(const std::vector<BubbleIdentity>& bubbles, ByteReader& reader) {
    RecentAverages averages;
    if (reader.take<std::uint8_t>() == 0) {
        return averages;
    }
    averages.mean_area = take_number(reader, "the mean area");
    averages.bubbles.resize(size_by_identity(bubbles));
    for (const BubbleIdentity bubble : bubbles) {
        BubbleValues& values = averages.bubbles[bubble];
        values.pressure = take_number(reader, "an average pressure");
        values.area = take_number(reader, "an average area");
        values.sides = take_number(reader, "an average number of sides");
    }
    return averages;
}

void write_record(const FoamRecord& record,
                  const Frame& frame,
                  const std::vector<double>& first_pressures,
                  ByteWriter& writer) {
    const std::vector<BubbleIdentity> bubbles = identities_of(frame);
    const bool left_out =
        !record.first_pressures.empty() && record.first_pressures == first_pressures;
    writer.put(std::int32_t{record.frame});
    write_by_identity(record.births, bubbles, writer);
    write_by_identity(record.changes, bubbles, writer);
    write_events(record.events, writer);
    writer.put(static_cast<std::uint8_t>(left_out));
    if (!left_out) {
        write_numbers(record.first_pressures, writer);
    }
    write_averages(record.averages, bubbles, writer);
}

FoamRecord read_record(const Frame& frame,
                       const std::vector<double>& first_pressures,
                       ByteReader& reader) {
    const std::vector<BubbleIdentity> bubbles = identities_of(frame);
    FoamRecord record;
    record.frame = reader.take<std::int32_t>();
    record.births = read_by_identity(bubbles, reader);
    record.changes = read_by_identity(bubbles, reader);
    record.events = read_events(record.frame, reader);
    const bool left_out = reader.take<std::uint8_t>() != 0;
    if (left_out && first_pressures.empty()) {
        throw BadContent("'pressures.foam' is missing in the cache");
    }
    record.first_pressures = left_out ? first_pressures : read_numbers(reader);
    record.averages = read_averages(bubbles, reader);
    return record;
}

void write_topology_events(const std::vector<TopologyEvent>& events, ByteWriter& writer) {
    writer.put(static_cast<std::uint32_t>(events.size()));
    for (const TopologyEvent& event : events) {
        writer.put(static_cast<std::uint8_t>(event.kind));
        writer.put(event.time);
        writer.put(event.position.x());
        writer.put(event.position.y());
        writer.put(static_cast<std::uint32_t>(event.bubbles.size()));
        for (const BubbleIdentity bubble : event.bubbles) {
            writer.put(bubble);
        }
    }
}

std::vector<TopologyEvent> read_topology_events(ByteReader& reader) {
    constexpr std::size_t kEventBytes = 1 + 3 * sizeof(double) + sizeof(std::uint32_t);
    std::vector<TopologyEvent> events(reader.take_count(kEventBytes));
    for (TopologyEvent& event : events) {
        event.kind = read_event_kind(reader);
        event.time = take_number(reader, "the time of an event");
        event.position.x() = take_number(reader, "the position of an event");
        event.position.y() = take_number(reader, "the position of an event");
        event.bubbles.resize(reader.take_count(sizeof(BubbleIdentity)));
        std::ranges::generate(event.bubbles, [&] { return reader.take<BubbleIdentity>(); });
    }
    return events;
}

void write_measurements(const FrameEffort& effort, ByteWriter& writer) {
    writer.put(effort.strain);
    writer.put(effort.energy);
    writer.put(effort.stress(0, 0));
    writer.put(effort.stress(0, 1));
    writer.put(effort.stress(1, 1));
    write_topology_events(effort.events, writer);
}

void read_measurements(FrameEffort& effort, ByteReader& reader) {
    effort.strain = take_number(reader, "the strain");
    effort.energy = take_number(reader, "the energy");
    const double xx = take_number(reader, "the stress");
    const double xy = take_number(reader, "the stress");
    const double yy = take_number(reader, "the stress");
    effort.stress << xx, xy, xy, yy;
    effort.events = read_topology_events(reader);
}

// Computes the energy and the stress of a state of an older version, which did not store the
// measurements. The strain stays 0, and there are no events.
void measure(FrameEffort& effort, const Frame& frame) {
    effort.energy = statistics(frame).energy;
    effort.stress = mean_stress(frame);
}

}  // namespace

Bytes pack_state(const SimulatedFrame& state, const std::vector<double>& first_pressures) {
    ByteWriter writer;
    write_frame(*state.frame, writer);
    write_effort(state.effort, writer);
    write_record(*state.record, *state.frame, first_pressures, writer);
    write_measurements(state.effort, writer);
    return writer.bytes();
}

SimulatedFrame unpack_state(std::span<const std::byte> content,
                            const std::vector<double>& first_pressures) {
    ByteReader reader(content);
    SimulatedFrame state;
    state.frame = std::make_shared<const Frame>(read_frame(reader));
    state.effort = read_effort(reader);
    state.record =
        std::make_shared<const FoamRecord>(read_record(*state.frame, first_pressures, reader));
    if (reader.is_at_end()) {
        measure(state.effort, *state.frame);
    } else {
        read_measurements(state.effort, reader);
    }
    if (!reader.is_at_end()) {
        throw BadContent("unexpected data after the state");
    }
    return state;
}

Bytes pack_numbers(const std::vector<double>& numbers) {
    ByteWriter writer;
    write_numbers(numbers, writer);
    return writer.bytes();
}

std::vector<double> unpack_numbers(std::span<const std::byte> content) {
    ByteReader reader(content);
    return read_numbers(reader);
}

}  // namespace foam::texgen
