#pragma once

#include <cstddef>
#include <functional>

namespace foam {

/// Number of threads that an option asks for: 0 or less are as many as the machine runs at once.
int threads_meant(int threads);

/// Calls body(first, last) for each chunk of [begin, end): [begin, begin + grain),
/// [begin + grain, begin + 2 grain) and so on, the last one cut off at the end.
///
/// Runs on up to threads_meant(threads) threads, one of them the caller's. The chunks are the same
/// for any number of threads, so what each makes of its own range alone is so too; they come in no
/// certain order. Returns when all are done; if some throw, chunks not yet begun are left out and
/// the first exception is thrown here. `body` may call parallel_for. Precondition: grain > 0.
void parallel_for(std::size_t begin,
                  std::size_t end,
                  std::size_t grain,
                  int threads,
                  const std::function<void(std::size_t, std::size_t)>& body);

}  // namespace foam
