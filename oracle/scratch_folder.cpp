#include "oracle/scratch_folder.h"

#include <fstream>

#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

#include "oracle/oracle_error.h"

namespace zproof::oracle {

ScratchFolder::ScratchFolder() {
    std::error_code trouble;
    const std::filesystem::path parent = std::filesystem::temp_directory_path(trouble);
    if (trouble)
        throw OracleError("folder for temporary files: " + trouble.message() +
                          "; set TMPDIR to one that exists");
    std::string name = parent / "zproof-XXXXXX";
    if (mkdtemp(name.data()) == nullptr)
        throw OracleError(parent.string() + ": no folder can be made here: " + std::strerror(errno) +
                          "; set TMPDIR to one that can be written");
    path_ = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

void ScratchFolder::write(const std::string& name, const std::string& bytes) const {
    const std::filesystem::path file = path_ / name;
    std::ofstream out(file, std::ios::binary);
    out << bytes << std::flush;
    if (!out) throw OracleError(file.string() + ": cannot be written; set TMPDIR to a folder with more room");
}

}  // namespace zproof::oracle
