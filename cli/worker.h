/// A process that judges scenes, one after the other, and tells what came of each.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cli/message_pipe.h"
#include "cli/scene_run.h"
#include "oracle/file_descriptor.h"

namespace zproof {

class Worker {
  public:
    /// Judges the scenes from `first` on, on so many threads. To be started before this process has any
    /// thread but one. Interrupts are handed on to it. Throws std::runtime_error where there can be no more
    /// processes.
    Worker(const std::vector<SceneSource>& sources, std::size_t first, const RunConfig& config, int threads);
    ~Worker();  ///< ends it
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    /// First the facts of the renderers that somebody named, then the stages and the results of each scene:
    /// Results as MessagePack, with the renderers, or with views. Nothing where it has ended.
    std::optional<Message> next() const { return receive(from_.number()); }

    /// Waits for its end. "killed by signal 11 (Segmentation fault)"; empty where it ended as it should.
    std::string end();

  private:
    oracle::FileDescriptor from_;
    pid_t id_ = 0;
};

}  // namespace zproof
