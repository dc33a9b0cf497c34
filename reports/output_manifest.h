/// What zproof itself wrote into an output folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace zproof {

/// The file in each output folder that says that zproof made it.
constexpr const char* output_marker = ".zproof-out";

/// A file as it was written: with other bytes it is somebody else's.
struct WrittenFile {
    std::uintmax_t bytes;
    std::uint64_t crc64;  ///< of ECMA-182

    bool operator==(const WrittenFile&) const = default;
};

/// By path in the folder, with slashes.
using OutputManifest = std::map<std::string, WrittenFile>;

/// Marks a folder as one that zproof is still writing. Throws ReportError.
void mark_unfinished(const std::filesystem::path& folder);

enum class Completeness {
    full,
    partial,  ///< an interrupt cut short what it reports
};

/// Marks a folder as finished, and lists every file in it. Throws ReportError.
void mark_finished(const std::filesystem::path& folder, Completeness completeness);

bool is_unfinished(const std::filesystem::path& folder);

/// Did zproof finish it, and not as a partial one?
bool is_full(const std::filesystem::path& folder);

/// What the folder's list says; nothing where the folder is not one that zproof has finished.
std::optional<OutputManifest> manifest_in(const std::filesystem::path& folder);

/// The file as it is now; nothing where it is no regular file or cannot be read.
std::optional<WrittenFile> as_it_is(const std::filesystem::path& file);

}  // namespace zproof
