/// Files that a user names to be read: regular ones only. A pipe may never have a writer, and a device may
/// never end.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace zproof {

/// What keeps a file from being read: "no such file", "is a folder", "is a pipe", "Permission denied", ...;
/// empty where nothing does. Opens it without waiting.
std::string fault_of_input(const std::filesystem::path& file);

/// A text that somebody writes, such as a settings file, is smaller.
constexpr std::uint64_t largest_text_bytes = std::uint64_t{1} << 26;
/// What a run writes, such as results.json, is smaller.
constexpr std::uint64_t largest_result_bytes = std::uint64_t{1} << 32;

/// What a file must be, and how many bytes it may have.
struct ExpectedInput {
    std::string words;  ///< ends the sentence: "a JSON file"
    std::uint64_t most_bytes = largest_text_bytes;
};

/// All bytes of a regular file. Throws FrameError, with the file, what it is and what was expected, for
/// anything else, and for one of more bytes.
std::string read_input(const std::filesystem::path& file, const ExpectedInput& expected);

}  // namespace zproof
