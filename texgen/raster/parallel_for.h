#pragma once

#include <functional>

namespace foam::texgen {

/// Calls body(k) once for every k in [0, count), on up to `threads` threads; fewer than two run it
/// on the caller's. The calls come in no certain order. Returns when all are done; if some throw,
/// calls not yet begun are left out and the first exception is thrown here.
void parallel_for(int count, int threads, const std::function<void(int)>& body);

}  // namespace foam::texgen
