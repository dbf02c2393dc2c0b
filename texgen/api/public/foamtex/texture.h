// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <foamtex/errors.h>
#include <foamtex/export.h>
#include <foamtex/foam.h>
#include <foamtex/records.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// Presets, their animations, and the images (maps) of their frames.
namespace foamtex {

/// Returns the version of the library, such as "1.2.3".
FOAMTEX_EXPORT std::string version();

/// Returns the version of the algorithms on which pixels depend. As long as this number is the
/// same, a preset and a seed give the same pixels.
FOAMTEX_EXPORT int algorithm_version();

/// Returns the names of the shipped presets.
FOAMTEX_EXPORT std::vector<std::string> preset_names();

/// Returns the JSON Schema of preset files, which documents every key.
FOAMTEX_EXPORT std::string key_schema();

/// A map: an image that can be drawn of a frame.
struct MapInfo {
    std::string name;      ///< such as "height"
    std::string meaning;   ///< in a few words
    std::string unit;      ///< unit or range of the samples in words, such as "0 to 1"
    std::string channels;  ///< names of the channels, such as "R G B"
};

/// Returns all maps.
FOAMTEX_EXPORT std::vector<MapInfo> maps();

/// Width, height and number of channels of an image.
struct ImageShape {
    int width = 0;     ///< pixels
    int height = 0;    ///< pixels
    int channels = 0;  ///< samples of a pixel

    /// Returns the number of samples.
    std::size_t size() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
               static_cast<std::size_t>(channels);
    }
};

/// A preset: all options of an animation. Copies are independent.
class FOAMTEX_EXPORT Preset {
  public:
    /// Loads a shipped preset, such as "sea_foam", or a preset file, whose path ends in .toml or
    /// contains a '/'. Then sets keys as `foamtex bake --set` does: `values` maps a key, such as
    /// "foam.bubbles", to its value as TOML, in which words need no quotes. Throws ArgumentError
    /// for an unknown preset or key, for a preset file that is unreadable or invalid, or for a
    /// value that is not allowed.
    explicit Preset(const std::string& name_or_path,
                    const std::map<std::string, std::string>& values = {});

    Preset(const Preset& other);                 ///< Copies.
    Preset(Preset&& other) noexcept;             ///< Moves.
    Preset& operator=(const Preset& other);      ///< Copies.
    Preset& operator=(Preset&& other) noexcept;  ///< Moves.
    ~Preset();                                   ///< Destroys.

    /// Sets keys, all or none of them. Ranges that fit_ranges has fitted are automatic again.
    /// Throws as the constructor does.
    void set(const std::map<std::string, std::string>& values);

    /// Returns the value of a key as TOML, or nothing if the key is unset. Throws ArgumentError for
    /// an unknown key.
    std::optional<std::string> get(const std::string& key) const;

    std::string name() const;               ///< such as "sea_foam"
    std::string description() const;        ///< in one sentence
    int frame_count() const;                ///< of the animation; loops repeat after so many frames
    std::vector<std::string> maps() const;  ///< the value of the key image.maps
    int width() const;                      ///< of images, in pixels
    int height() const;                     ///< of images, in pixels

    /// Returns the whole preset as the text of a preset file.
    std::string toml() const;

    /// Returns the seeded foam: a raw Voronoi diagram (Foam::torus, Foam::disk). The animation
    /// starts from this foam, unless the library contains a stored start for the loop of the
    /// preset, as it does for some shipped presets. Throws ArgumentError if no valid foam can be
    /// seeded.
    Foam seeded_foam() const;

    /// Fits automatic ranges, such as height.full = "auto", to the whole animation, as
    /// `foamtex bake` does. Fits the ranges of the maps in image.maps and output.pack. Only integer
    /// samples (Frame::draw) need this. Frames have the ranges that the preset had when their
    /// Simulation was constructed. Throws EquilibriumError if the animation fails. Throws
    /// ArgumentError if `threads` is not allowed, or if no valid foam can be seeded. `threads`: 0
    /// for all threads of the machine.
    void fit_ranges(int threads = 0);

    struct State;  ///< internal to the library

    /// Returns the state, for other classes of the library.
    const State& state() const { return *state_; }

  private:
    std::shared_ptr<const State> state_;
};

/// One frame of an animation: a foam, and its images. A copy refers to the same frame. All
/// functions may be called by several threads at the same time.
class FOAMTEX_EXPORT Frame {
  public:
    int number() const;     ///< from 1
    double time() const;    ///< foam time (E6)
    Extent extent() const;  ///< the torus, or zeros for a patch

    /// Returns the changes of topology since the frame that the simulation returned before this
    /// one, or since the start of the simulation if there is none.
    std::vector<Event> events() const;

    /// Returns the film tension times the length of all films of the simulated foam. If the preset
    /// has a drift, a current or a loop of the kind shear, the frame shows this foam displaced; the
    /// displaced films may have another length.
    double energy() const;

    /// Returns the mean stress (E11) of the simulated foam.
    Stress stress() const;

    const FoamRecords& records() const;  ///< valid as long as a copy of this frame exists

    /// Returns the shape of the image of a map. `integers` is true for an image of integer samples,
    /// in which a map of two channels has three. Throws ArgumentError for an unknown map.
    ImageShape shape(const std::string& map, bool integers = false) const;

    /// Draws a map into a caller's buffer: the rows from top to bottom, with interleaved channels.
    /// Numbers are in the unit of the map; colors are linear light from 0 to 1, multiplied by the
    /// opacity if there is one. `threads`: 0 for all threads of the machine. Throws ArgumentError
    /// in these cases:
    /// - The map is unknown.
    /// - `threads` is not allowed.
    /// - The size of the buffer is not that of shape(map).
    /// - The map needs the next frame, as "motion" and "growth" do, but neither image.maps nor
    ///   output.pack contains a map that needs the next frame.
    void draw(const std::string& map, std::span<float> samples, int threads = 1) const;

    /// Draws a map as integers of 8 bits. If PNGs of the map have 8 bits, the integers are exactly
    /// those that `foamtex bake` stores. Throws as above, but the buffer must have the size of
    /// shape(map, true). Also throws ArgumentError if a range of the map is automatic and has not
    /// been fitted (Preset::fit_ranges) before the Simulation was constructed.
    void draw(const std::string& map, std::span<std::uint8_t> samples, int threads = 1) const;
    /// Draws a map as integers of 16 bits. If PNGs of the map have 16 bits, the integers are
    /// exactly those that `foamtex bake` stores. Throws as the function for 8 bits does. Also
    /// throws ArgumentError for a map of colors.
    void draw(const std::string& map, std::span<std::uint16_t> samples, int threads = 1) const;

    struct State;  ///< internal to the library

    /// Makes a frame; only the library can.
    explicit Frame(std::shared_ptr<const State> state) : state_(std::move(state)) {}
    /// Returns the state, for other classes of the library.
    const State& state() const { return *state_; }

  private:
    std::shared_ptr<const State> state_;
};

/// A running simulation of a preset. A background thread computes frames in advance; up to three of
/// them wait in a queue. One thread at a time may use a Simulation.
class FOAMTEX_EXPORT Simulation {
  public:
    /// Starts the simulation. `frames` are the numbers of the frames that are wanted, such as
    /// "1-48" or "1-10x3,20" (the notation of `foamtex bake --frames`); all frames if it is empty.
    /// Throws ArgumentError if `frames` or `threads` is not allowed. `threads`: 0 for all threads
    /// of the machine; no result depends on it.
    explicit Simulation(const Preset& preset, const std::string& frames = {}, int threads = 0);
    Simulation(Simulation&& other) noexcept;             ///< Moves.
    Simulation& operator=(Simulation&& other) noexcept;  ///< Moves.
    /// Stops the simulation. Waits until the step that is running has ended.
    ~Simulation();

    /// Waits for the next frame and returns it; nothing after the last one. Frames usually
    /// come in increasing order; exceptions are loops of the kind pingpong, and frames after the
    /// first period of a loop of the kind flow. Throws EquilibriumError if the foam finds no
    /// equilibrium or the loop does not close, and ArgumentError if no valid foam can be seeded.
    /// While it waits, calls `poll` ten times per second, if there is one; an exception of `poll`
    /// ends the wait.
    std::optional<Frame> next(const std::function<void()>& poll = {});

  private:
    struct Stream;
    std::unique_ptr<Stream> stream_;
};

/// The progress of a bake.
struct Progress {
    std::string phase;  ///< such as "frames"; `foamtex bake --progress json` prints the same words
    int done = 0;       ///< number of units of the phase that are done
    int total = 0;      ///< number of units of the phase; 0 if unknown
    int frame = 0;      ///< the frame that was done last; 0 if there is none
};

/// The options of a bake.
struct BakeSettings {
    std::string frames{};  ///< such as "1-48"; empty for the whole animation
    int threads = 0;       ///< 0: all threads of the machine
    bool resume = false;   ///< keeps frames that an earlier bake of the same preset has written
    /// Called now and then, by one thread at a time. If it throws an exception, the bake ends, and
    /// `bake` throws the same exception, but ArgumentError instead of std::invalid_argument, and
    /// OutputError instead of std::system_error.
    std::function<void(const Progress&)> on_progress{};
};

/// Writes the images of a preset, and what else `foamtex bake` writes: the manifest, sheets and
/// scene files. `out` is a folder, or a pattern of file names such as "out/{map}.####.exr". It is a
/// pattern if it has an extension or contains `{`, `#`, `@` or `%`, unless it is an existing
/// folder. A folder replaces the folders that all files of output.pattern, the preset's own
/// pattern, share. For example, with output.pattern = "out/{map}/####.png" and `out` = "foam",
/// images are written to "foam/{map}/####.png".
///
/// Returns the names of all images. Throws ArgumentError if an argument is not allowed, InputError
/// if an existing manifest is unreadable, and OutputError if a file cannot be written. Throws
/// EquilibriumError if the animation fails. The frames before the failure are then already written,
/// unless the failure occurs while automatic ranges are fitted, before the first frame is written.
FOAMTEX_EXPORT std::vector<std::string> bake(const Preset& preset,
                                             const std::string& out,
                                             const BakeSettings& settings = {});

/// The largest differences that `compare` allows. Integer samples are scaled so that the largest
/// integer is 1. If no limit is set, no sample may differ by more than 1e-6. If only `rms` or, for
/// maps of normals, `angle` is set, single samples are not limited.
struct Limits {
    std::optional<double> sample{};  ///< of any sample
    std::optional<double> rms{};     ///< root mean square over all samples
    std::optional<double> angle{};   ///< of normals, in degrees
    double allowed_percent = 0.0;    ///< percentage of pixels that may exceed `sample` or `angle`
};

/// The comparison of two images, or of one layer of two images.
struct Difference {
    bool same_shape = true;  ///< false if size or channels differ; nothing is compared then
    bool is_within = false;  ///< true if no limit is exceeded
    std::string map{};       ///< empty if it is not known
    std::string layer{};     ///< empty if the images have no layers
    double largest = 0.0;    ///< largest difference of two samples
    double mean = 0.0;       ///< mean difference of all samples
    double rms = 0.0;        ///< root mean square of the differences
    std::string channel{};   ///< of the largest difference; empty if all samples are equal
    int x = 0;               ///< column of the largest difference
    int y = 0;               ///< row of the largest difference, from the top
    /// The limits that are exceeded, in words; if same_shape is false, a sentence that says so.
    std::vector<std::string> reasons{};
};

/// Compares two image files, such as a golden image and a new one. Returns one element per layer,
/// or a single element if the images have no layers or differ in size or channels. If `picture` is
/// not empty, writes a PNG of the differences with this name, unless the images differ in size or
/// channels. Throws ArgumentError if a limit is not allowed, InputError if an image is unreadable,
/// and OutputError if the PNG cannot be written.
FOAMTEX_EXPORT std::vector<Difference> compare(const std::string& a,
                                               const std::string& b,
                                               const Limits& limits = {},
                                               const std::string& picture = {});

}  // namespace foamtex
