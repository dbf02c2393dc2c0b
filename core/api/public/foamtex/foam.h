// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <foamtex/errors.h>
#include <foamtex/export.h>
#include <foamtex/records.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace foamtex {

/// Options for seeding a foam, which is the Voronoi diagram of random points. The same options give
/// the same foam on every machine.
struct SeedOptions {
    /// Number of bubbles, at most 10 million. Also the area of the torus, because the mean bubble
    /// area is 1.
    int bubbles = 1000;
    /// Width of the torus divided by its height, from 1/16384 to 16384; has no effect on a disk.
    double aspect = 1.0;
    /// Iterations of Lloyd's algorithm, which makes the cells rounder; from 0 to 1000.
    int lloyd_iterations = 0;
    /// Largest divided by smallest target area, from 1 to 1e6; 0 keeps the areas of the diagram.
    double area_ratio = 0.0;
    double surface_tension = 0.5;  ///< gamma, positive; a film has the tension 2 gamma
    std::uint64_t seed = 1;        ///< seed of the random points
};

/// Options for computing a time step. No result depends on the number of threads.
/// The defaults fit a mean area of 1. For a foam with another mean area A, such as one from Surface
/// Evolver, use the t1_distance 0.05 √A and the t2_area 0.01 A.
struct StepSettings {
    double kappa = 0.01;        ///< diffusion constant (E6), in foam units; 0 for no diffusion
    double tolerance = 1e-9;    ///< largest error of areas (relative) and of angles (radians)
    double t1_distance = 0.05;  ///< a film with a shorter chord may flip (E7), foam units
    /// Target area at which bubbles of up to three sides vanish (E8), square foam units.
    double t2_area = 0.01;
    int threads = 0;  ///< at most 256; 0: all threads of the machine
};

/// The work and the result of `relax` or `step`.
struct Equilibrium {
    bool converged = false;    ///< true if `relax` found an equilibrium or `step` was completed
    int iterations = 0;        ///< number of steps of Newton's method
    int t1 = 0;                ///< number of T1s: neighbor swaps at films
    int t2 = 0;                ///< number of T2s: bubbles that vanished
    double area_error = 0.0;   ///< largest |area / target area - 1|
    double angle_error = 0.0;  ///< largest deviation of an angle from 120 degrees, radians
};

/// A bubble whose target area is imposed during a step.
struct DrivenArea {
    std::int64_t identity = 0;  ///< identity of the bubble (Bubble::identity)
    double target_area = 0.0;   ///< at the end of the step; positive
};

/// A push: a junction at the distance r from the center moves by (1 - r²/R²)² times `by` if r is
/// less than the radius R.
struct Push {
    Point center;         ///< moves with the push
    double radius = 1.0;  ///< positive; on a torus, at most half of its shorter side
    Point by;             ///< displacement of the center, along x and y at most 1000 radii
};

/// The changes that are imposed on a foam from outside during a step (E9).
struct Drive {
    /// Bubbles whose target areas change evenly during the step. On a torus, the other bubbles give
    /// and take the gas; in a patch, the atmosphere does. If the driven bubbles would fill more
    /// than nine tenths of a torus, their target areas are scaled down so that they fill nine
    /// tenths. If every bubble of a torus is driven, all target areas are scaled to fill the torus.
    /// Bubbles that have vanished are ignored.
    std::vector<DrivenArea> areas{};
    /// Simple shear of a torus, from -100 to 100: every point moves to the right by strain * y.
    double strain = 0.0;
    std::vector<Push> pushes{};  ///< made in small steps
};

/// A two-dimensional dry foam, on a torus or as a free patch in the plane. Copies are
/// independent. A foam that was moved from may only be assigned to or destroyed. Different foams
/// may be used by different threads at the same time.
class FOAMTEX_EXPORT Foam {
  public:
    /// Returns the Voronoi diagram of random points on a torus. The foam is not yet in equilibrium:
    /// call `relax`. Throws ArgumentError if an option is out of range or if no valid foam results,
    /// for example for a torus of one bubble.
    static Foam torus(const SeedOptions& options);

    /// Returns a patch with a free surface, seeded in a disk. It is not in equilibrium. The number
    /// of bubbles may differ slightly from `bubbles`, which must be at least 2. Throws as `torus`
    /// does.
    static Foam disk(const SeedOptions& options);

    /// Reads a foam from a file: a .fe or .dmp file of Surface Evolver, or a .json file with a
    /// state of foamtex. Throws InputError if the file cannot be read or is malformed, and
    /// ArgumentError if its name has another ending.
    static Foam read(const std::string& file);

    /// Reads a foam from the text of a state (`state`). Throws InputError if the text is malformed.
    static Foam from_state(const std::string& json);

    Foam(const Foam& other);                 ///< Copies.
    Foam(Foam&& other) noexcept;             ///< Moves.
    Foam& operator=(const Foam& other);      ///< Copies.
    Foam& operator=(Foam&& other) noexcept;  ///< Moves.
    ~Foam();                                 ///< Destroys.

    /// Writes the foam to a file. The ending of the name selects the format, as in `read`. Throws
    /// OutputError if the file cannot be written or the format cannot store the foam, and
    /// ArgumentError for another ending.
    void write(const std::string& file) const;

    /// Returns the whole state, without the events, as the JSON text of a .json file. A foam that
    /// is made from this text evolves exactly like this foam, to the last bit.
    std::string state() const;

    /// Brings the foam to equilibrium at its target areas (E2), to errors below 1e-9. If this
    /// fails, the result says so and has the errors of the last attempt, and the foam is unchanged.
    /// `threads` is as in StepSettings. If `poll` is not empty, it is called now and then while the
    /// solver works. An exception of `poll` ends the work, and the foam is unchanged;
    /// std::invalid_argument and std::system_error arrive as ArgumentError and OutputError.
    Equilibrium relax(int threads = 0, const std::function<void()>& poll = {});

    /// Advances a foam in equilibrium by a time of at least 0, in the unit of foam time (E6). In
    /// this time gas diffuses, bubbles vanish (T2), bubbles swap neighbors (T1), and `drive` acts
    /// on the foam. If this fails, the result says so, and the foam is in the last equilibrium that
    /// was reached. The errors in the result are 0 if the step reached no equilibrium. A step of
    /// time 0 without a drive only measures the errors, and `converged` tells whether they are
    /// below the tolerance. Throws ArgumentError if an argument is not allowed. `poll` is as in
    /// `relax`.
    Equilibrium step(double time,
                     const Drive& drive = {},
                     const StepSettings& settings = {},
                     const std::function<void()>& poll = {});

    /// Shears a torus (Drive::strain) without restoring equilibrium. Throws ArgumentError for a
    /// patch, and if the strain is not from -100 to 100.
    void shear(double strain);

    double time() const;                ///< foam time (E6)
    double film_tension() const;        ///< 2 gamma
    Extent extent() const;              ///< the torus, or zeros for a patch
    std::int64_t bubble_count() const;  ///< the number of bubbles

    /// Returns the film tension times the length of all films.
    double energy() const;

    /// Returns the mean stress of the foam (E11).
    Stress stress() const;

    /// Returns the shear modulus of a torus in equilibrium (E11): the derivative of the shear
    /// stress with respect to the strain, without T1s. Returns nothing for a patch, if the
    /// errors of the foam are not below 1e-3, or if Newton's method does not converge. `threads` is
    /// as in StepSettings.
    std::optional<double> shear_modulus(int threads = 0) const;

    /// Returns the changes of topology since the last call, in the order in which they happened,
    /// and removes them from the foam. The first call returns all changes since the foam was made;
    /// a copy of a foam also has the changes that were not yet removed from the original.
    std::vector<Event> take_events();

    /// Returns all bubbles, films and junctions.
    FoamRecords records() const;

  private:
    struct State;
    explicit Foam(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

}  // namespace foamtex
