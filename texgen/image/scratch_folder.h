#pragma once

#include <filesystem>

namespace foam::texgen {

/// An empty folder of its own among the temporary ones of the system, gone with all that is in it
/// when this is.
class ScratchFolder {
  public:
    /// Throws OutputError.
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace foam::texgen
