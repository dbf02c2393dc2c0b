// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <sys/resource.h>
#include <unistd.h>

#include <fstream>

namespace foam::test {

/// While an object of this class exists, the process can allocate only about `left` more bytes of
/// address space. Programs with sanitizers cannot run with such a limit (kMayHaveSanitizers).
class LimitedAddressSpace {
  public:
    explicit LimitedAddressSpace(rlim_t left) {
        rlim_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        getrlimit(RLIMIT_AS, &before_);
        const rlim_t used = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
        const rlimit smaller{used + left, before_.rlim_max};
        setrlimit(RLIMIT_AS, &smaller);
    }
    ~LimitedAddressSpace() { setrlimit(RLIMIT_AS, &before_); }
    LimitedAddressSpace(const LimitedAddressSpace&) = delete;
    LimitedAddressSpace& operator=(const LimitedAddressSpace&) = delete;

  private:
    rlimit before_{};
};

}  // namespace foam::test
