// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/stats/record.h"

#include <string>

namespace foam::texgen {

// The tables of a run as CSV. The first line contains the names of the columns, separated by
// commas. Numbers have a decimal point in any locale, and reals are written without loss. Lengths,
// areas and times are in foam units. README.md explains each column.

/// Returns a table with one row per frame:
/// frame,time,bubbles,mean_area,energy,second_moment,area_error,angle_error,t1,t2,seconds
std::string frames_csv(const RunRecord& run);

/// Returns a table with one row per frame and number of sides that occurs in it:
/// frame,time,sides,bubbles,share,mean_area,mean_pressure,untouched,area_rate,film_rate,law_rate
/// `area_rate` is empty in the first record. It is also empty if the neighbors of every bubble with
/// this number of sides have changed since the preceding record.
std::string sides_csv(const RunRecord& run);

}  // namespace foam::texgen
