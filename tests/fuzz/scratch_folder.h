/// A folder for readers that take a file. `./dev fuzz` keeps it in memory (TMPDIR).
#pragma once

#include "tests/fuzz/harness.h"
#include "tests/support/test_folder.h"

namespace zproof::fuzz {

class ScratchFolder : public TestFolder {
  public:
    using TestFolder::write;
    std::filesystem::path write(const std::filesystem::path& name, Input bytes) const {
        return write(name, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    }
};

}  // namespace zproof::fuzz
