/// The folder that a run leaves behind.
#pragma once

#include <filesystem>

#include "reports/report_error.h"

namespace zproof {

/// An output folder that appears whole or not at all: written as PATH.tmp-PID, renamed by publish(). Replaces
/// PATH only where PATH is a folder that zproof itself made (it holds .zproof-out) or an empty one; otherwise
/// the constructor throws ReportError and touches nothing. The destructor removes what was not published.
class OutputFolder {
  public:
    explicit OutputFolder(const std::filesystem::path& path);
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    const std::filesystem::path& working() const { return working_; }  ///< where to write

    /// Puts the working folder in PATH's place: the old one is renamed away, the new one in, then the old one
    /// is removed. Whenever the process dies, a whole folder is left, old or new. Throws ReportError where a
    /// rename fails or PATH has become somebody else's meanwhile; PATH is then as it was. To be called once.
    void publish();

  private:
    std::filesystem::path path_, working_;
    bool published_ = false;
};

}  // namespace zproof
