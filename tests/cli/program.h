/// The real program, run as a user would run it.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/test_folder.h"

namespace zproof::test {

/// What a finished run left to see.
struct Ran {
    int exit_code = -1;  ///< -1: ended by a signal
    std::string out, err;
};

using Words = std::vector<std::string>;

/// A folder in which the program is run.
class Folder : public TestFolder {
  public:
    std::string read(const std::filesystem::path& name) const;
    Words names() const;  ///< of what lies in it, sorted
};

/// Files for the program's stdout and stderr.
struct Streams {
    int out, err;
};

/// Starts zproof in the folder; environment holds "NAME=VALUE" words that are added to ours.
pid_t start(const Folder& folder, const Words& arguments, Streams streams, const Words& environment = {});
int exit_code_of(pid_t pid);  ///< waits

/// Runs zproof to its end with stdout and stderr in files.
Ran run(const Folder& folder, const Words& arguments, const Words& environment = {});

/// The same with stdout on a terminal; err is not kept.
Ran run_on_terminal(const Folder& folder, const Words& arguments, const Words& environment);

/// glTF files with their vertices inside: one triangle; the same and one that crosses it.
std::string one_triangle();
std::string two_triangles();
std::string point_cloud();  ///< a mesh of three points, no triangle

}  // namespace zproof::test
