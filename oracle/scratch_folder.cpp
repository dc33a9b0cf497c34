#include "oracle/scratch_folder.h"

#include <fstream>

#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

#include "oracle/oracle_error.h"

namespace zproof::oracle {
namespace {

std::string prefix_of(pid_t process) { return "zproof-" + std::to_string(process) + "-"; }

}  // namespace

void remove_scratch_folders_of(pid_t process) {
    std::error_code ignored;
    const std::filesystem::path parent = std::filesystem::temp_directory_path(ignored);
    std::error_code failure;  // a range's loop would throw where the folder cannot be read on
    for (auto i = std::filesystem::directory_iterator(parent, failure); !failure && i != end(i);
         i.increment(failure))
        if (i->path().filename().string().starts_with(prefix_of(process)))
            std::filesystem::remove_all(i->path(), ignored);
}

ScratchFolder::ScratchFolder() {
    std::error_code trouble;
    const std::filesystem::path parent = std::filesystem::temp_directory_path(trouble);
    if (trouble)
        throw OracleError("folder for temporary files: " + trouble.message() +
                          "; set TMPDIR to one that exists");
    std::string name = parent / (prefix_of(getpid()) + "XXXXXX");
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
