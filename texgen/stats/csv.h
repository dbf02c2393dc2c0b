// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/stats/record.h"

#include <string>

namespace foam::texgen {

// The tables of a run as CSV. The first line contains the names of the columns, separated by
// commas. Numbers have a decimal point in any locale, and floating-point numbers are written
// without loss of precision. `seconds` is in seconds, `angle_error` and `orientation` in radians;
// all other quantities are in foam units. texgen/stats/TABLES.md explains each column.

/// Returns a table with one row per frame:
/// frame,time,bubbles,mean_area,energy,second_moment,area_error,angle_error,t1,t2,seconds
std::string frames_csv(const RunRecord& run);

/// Returns a table with one row for each frame and each number of sides that occurs in this frame:
/// frame,time,sides,bubbles,share,mean_area,mean_pressure,untouched,area_rate,film_rate,law_rate
/// `area_rate` is empty:
/// - in the rows of the first frame and of lone bubbles (0 sides);
/// - if no foam time has passed since the preceding frame of the table;
/// - if every bubble with this number of sides has other neighbors than in that frame.
std::string sides_csv(const RunRecord& run);

/// Returns a table of the stress with one row per frame:
/// frame,time,strain,energy,stress_xx,stress_xy,stress_yy,normal_stress_difference,shear_modulus
/// `shear_modulus` is empty if the frame has none (core/dynamics/shear_modulus.h).
std::string stress_csv(const RunRecord& run);

/// Returns a table of the topology events with one row for each T1, T2 and birth:
/// frame,time,kind,x,y,bubbles
/// `bubbles` lists the identities of the bubbles whose neighbors changed, separated by spaces.
std::string events_csv(const RunRecord& run);

/// Returns a table of the bubbles in the last frame of the run with one row per bubble:
/// frame,identity,x,y,sides,area,target_area,pressure,perimeter,elongation,orientation
/// If the run has no frames, the table has no rows.
std::string bubbles_csv(const RunRecord& run);

/// Returns a table of the mazes with one row per frame:
/// frame,time,bubbles,solution,dead_ends,branches
/// Returns an empty text if no map of the run's preset shows a maze, or if the run has no frames.
std::string maze_csv(const RunRecord& run);

}  // namespace foam::texgen
