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

/// How a foam is seeded: the Voronoi diagram of random points. The same options give the same foam
/// on every machine.
struct SeedOptions {
    int bubbles = 1000;        ///< also the area of the torus, because the mean area is 1
    double aspect = 1.0;       ///< width of the torus divided by its height; unused for a disk
    int lloyd_iterations = 0;  ///< of Lloyd's algorithm, which makes the cells rounder
    /// Largest divided by smallest target area; 0 keeps the areas of the diagram.
    double area_ratio = 0.0;
    double surface_tension = 0.5;  ///< gamma; a film has the tension 2 gamma
    std::uint64_t seed = 1;        ///< of the random points
};

/// How a time step is computed. No result depends on the number of threads.
/// The defaults fit a mean area of 1. For a foam with another mean area A, such as one from Surface
/// Evolver, use the t1_distance 0.05 √A and the t2_area 0.01 A.
struct StepSettings {
    double kappa = 0.01;        ///< diffusion constant (E6), in foam units; 0 for no diffusion
    double tolerance = 1e-9;    ///< largest error of areas (relative) and of angles (radians)
    double t1_distance = 0.05;  ///< a film with a shorter chord may flip (E7), foam units
    double t2_area = 0.01;      ///< smaller bubbles of two or three sides vanish (E8), foam units
    int threads = 0;            ///< 0: all threads of the machine
};

/// The work and the result of `relax` or `step`.
struct Equilibrium {
    bool converged = false;    ///< true if an equilibrium was reached
    int iterations = 0;        ///< of Newton's method
    int t1 = 0;                ///< number of T1s: neighbor swaps at films
    int t2 = 0;                ///< number of T2s: bubbles that vanished
    double area_error = 0.0;   ///< largest |area / target area - 1|
    double angle_error = 0.0;  ///< largest deviation of an angle from 120 degrees, radians
};

/// A bubble whose target area is imposed during a step.
struct DrivenArea {
    std::int64_t identity = 0;  ///< of the bubble (Bubble::identity)
    double target_area = 0.0;   ///< at the end of the step; positive
};

/// A push: a junction at the distance r from the center moves by (1 - r²/R²)² times `by` if r is
/// less than the radius R.
struct Push {
    Point center;         ///< moves with the push
    double radius = 1.0;  ///< positive; on a torus, at most half of its shorter side
    Point by;             ///< displacement of the center
};

/// The changes that are imposed on a foam from outside during a step (E9).
struct Drive {
    /// Target areas of bubbles, which change evenly during the step. On a torus, the other bubbles
    /// give and take the gas, and the driven bubbles fill at most nine tenths of the torus; if
    /// every bubble is driven, all target areas are scaled to fill the torus. Bubbles that have
    /// vanished are ignored.
    std::vector<DrivenArea> areas{};
    double strain = 0.0;  ///< simple shear of a torus: every point moves to the right by strain * y
    std::vector<Push> pushes{};  ///< made in small steps
};

/// A two-dimensional dry foam, on a torus or as a free patch in the plane. Copies are
/// independent. A foam that was moved from may only be assigned to or destroyed. Different foams
/// may be used by different threads at the same time.
class FOAMTEX_EXPORT Foam {
  public:
    /// Returns the Voronoi diagram of random points on a torus. The foam is not yet in equilibrium:
    /// call `relax`. Throws ArgumentError if an option is out of range.
    static Foam torus(const SeedOptions& options);

    /// Returns a patch with a free surface, seeded in a disk. It is not in equilibrium. The number
    /// of bubbles may differ slightly from `bubbles`. Throws as `torus` does.
    static Foam disk(const SeedOptions& options);

    /// Reads a foam from a file: .fe or .dmp of Surface Evolver, or .json, a state of foamtex.
    /// Throws InputError, and ArgumentError for another ending.
    static Foam read(const std::string& file);

    /// Reads a foam from the text of a state (`state`). Throws InputError.
    static Foam from_state(const std::string& json);

    Foam(const Foam& other);                 ///< Copies.
    Foam(Foam&& other) noexcept;             ///< Moves.
    Foam& operator=(const Foam& other);      ///< Copies.
    Foam& operator=(Foam&& other) noexcept;  ///< Moves.
    ~Foam();                                 ///< Destroys.

    /// Writes the foam to a file. The ending of the name selects the format, as in `read`. Throws
    /// OutputError, and ArgumentError for another ending.
    void write(const std::string& file) const;

    /// Returns the whole state, without the events, as the JSON text of a .json file. A foam that
    /// is made from this text evolves with the same bits.
    std::string state() const;

    /// Brings the foam to equilibrium at its target areas (E2), to errors below 1e-9. If this
    /// fails, the result says so and has the errors of the last attempt, and the foam is unchanged.
    /// `threads` is as in StepSettings. If `poll` is not empty, it is called now and then while the
    /// solver works. An exception of `poll` ends the work, and the foam is unchanged;
    /// std::invalid_argument and std::system_error arrive as ArgumentError and OutputError.
    Equilibrium relax(int threads = 0, const std::function<void()>& poll = {});

    /// Advances a foam in equilibrium by a time, in which gas diffuses (E6), bubbles vanish (T2)
    /// and bubbles swap neighbors (T1), and `drive` acts on it. If this fails, the result says so,
    /// and the foam is in the last equilibrium that was reached; the errors in the result are 0 if
    /// the step reached none. Throws ArgumentError if an argument is not allowed. `poll` is as in
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
    /// errors of the foam are above 1e-3, or if Newton's method does not converge. `threads` is as
    /// in StepSettings.
    std::optional<double> shear_modulus(int threads = 0) const;

    /// Returns the changes of topology since the last call, or since the foam was made, in the
    /// order in which they happened, and removes them from the foam.
    std::vector<Event> take_events();

    /// Returns all bubbles, films and junctions.
    FoamRecords records() const;

  private:
    struct State;
    explicit Foam(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

}  // namespace foamtex
