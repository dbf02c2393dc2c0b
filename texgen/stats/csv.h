#pragma once

#include "texgen/stats/record.h"

#include <string>

namespace foam::texgen {

// Tables with a line of names, commas between, a point in numbers whatever the locale, and every
// real to its last bit. Lengths, areas and times are in foam units; README.md explains each column.

/// A row per frame:
/// frame,time,bubbles,mean_area,energy,second_moment,area_error,angle_error,t1,t2,seconds
std::string frames_csv(const RunRecord& run);

/// A row per frame and number of sides that occurs in it:
/// frame,time,sides,bubbles,share,mean_area,mean_pressure,untouched,area_rate,film_rate,law_rate
/// `area_rate` is empty where no bubble was untouched by events since the record before.
std::string sides_csv(const RunRecord& run);

}  // namespace foam::texgen
