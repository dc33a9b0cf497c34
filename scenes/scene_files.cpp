#include "scenes/scene_files.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <fstream>

#include "frame/input_file.h"
#include "frame/printable.h"
#include "scenes/limits.h"
#include "scenes/refusal.h"

namespace zproof {
namespace {

namespace fs = std::filesystem;

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

bool has_scheme(const std::string& uri) {
    const std::size_t colon = uri.find(':');
    return colon != std::string::npos && colon < uri.find('/');
}

bool is_within(const fs::path& folder, const fs::path& file) {
    return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

/// What keeps the text from being a relative path, or nothing.
std::string fault_of_relative(const std::string& relative) {
    if (relative.empty()) return "expected a path, found nothing";
    const bool printable =
        std::ranges::all_of(relative, [](char c) { return static_cast<unsigned char>(c) >= 0x20; });
    if (!printable || relative.find('\\') != std::string::npos)
        return "expected a path without control characters and backslashes";
    if (has_scheme(relative)) return "expected a relative path without a scheme";
    if (fs::path(relative).is_absolute()) return "expected a relative path";
    return {};
}

/// What keeps the text from being a path beneath the folder, or nothing.
std::string fault_of(const std::string& relative) {
    if (std::string fault = fault_of_relative(relative); !fault.empty()) return fault;
    const fs::path path = fs::path(relative).lexically_normal();
    return *path.begin() == ".." ? "the path leaves the file's folder" : "";
}

/// The path in quotes, as a message shows it.
std::string quoted(const std::string& path) {
    std::string text(1, '"');
    text += shortened(path, 100);
    text += '"';
    return text;
}

/// The folder in which a file lies, symbolic links resolved.
fs::path folder_of(const fs::path& file, const std::string& place) {
    std::error_code error;
    const fs::path folder = fs::canonical(fs::absolute(file).parent_path(), error);
    if (error) refuse(file, place, "the file's folder cannot be resolved; check its permissions");
    return folder;
}

/// The size of a regular file.
std::uint64_t size_of(const fs::path& file) {
    if (const std::string fault = fault_of_input(file); !fault.empty())
        refuse(file, "file", fault + "; expected a regular file");
    std::error_code error;
    const std::uint64_t bytes = fs::file_size(file, error);
    if (error) refuse(file, "file", "its size cannot be told; check its permissions");
    return bytes;
}

}  // namespace

Bytes read_file(const fs::path& file, std::uint64_t limit) {
    const std::uint64_t bytes = size_of(file);
    if (bytes > limit)
        refuse(
            file, "file",
            std::to_string(bytes) + " bytes; at most " + std::to_string(limit) + " are read: split the file");
    Bytes content(bytes);
    read_first(file, content);
    return content;
}

std::string_view text_in(const fs::path& file, std::span<const unsigned char> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        refuse(file, "byte 0", "is UTF-16; expected UTF-8: save or export the file again");
    return text.starts_with(byte_order_mark) ? text.substr(byte_order_mark.size()) : text;
}

void read_first(const fs::path& file, std::span<unsigned char> to) {
    constexpr std::size_t worth_a_task = std::size_t{1} << 20;
    std::atomic<bool> is_whole = true;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, to.size(), worth_a_task), [&](const auto& some) {
        std::ifstream source(file, std::ios::binary);
        source.seekg(static_cast<std::streamoff>(some.begin()));
        source.read(reinterpret_cast<char*>(&to[some.begin()]), static_cast<std::streamsize>(some.size()));
        if (!source) is_whole = false;
    });
    if (!is_whole) refuse(file, "file", "cannot be read to its end; check its permissions");
}

std::string percent_decoded(const std::string& uri) {
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const bool escape =
            uri[i] == '%' && uri.size() > i + 2 && hex_digit(uri[i + 1]) >= 0 && hex_digit(uri[i + 2]) >= 0;
        text += escape ? static_cast<char>(hex_digit(uri[i + 1]) << 4 | hex_digit(uri[i + 2])) : uri[i];
        if (escape) i += 2;
    }
    return text;
}

fs::path beneath_folder_of(const fs::path& from, const std::string& place, const std::string& relative,
                           const std::string& remedy) {
    const std::string end = "; " + remedy;
    if (const std::string fault = fault_of(relative); !fault.empty())
        refuse(from, place, quoted(relative) + ": " + fault + end);
    const fs::path folder = folder_of(from, place);
    std::error_code error;
    const fs::path file = fs::canonical(folder / relative, error);
    if (error) refuse(from, place, quoted(relative) + " not found in the file's folder" + end);
    if (!is_within(folder, file))
        refuse(from, place, quoted(relative) + " leads out of the file's folder" + end);
    if (!fs::is_regular_file(file, error))
        refuse(from, place, quoted(relative) + " is not a regular file" + end);
    return file;
}

fs::path beneath_folder_or_root(const fs::path& from, const std::string& place, const std::string& relative,
                                const fs::path& root) {
    if (const std::string fault = fault_of_relative(relative); !fault.empty())
        refuse(from, place, quoted(relative) + ": " + fault);
    std::error_code error;
    const fs::path folder = folder_of(from, place), models = fs::canonical(root, error);
    if (error)
        refuse(from, place,
               "the folder of models " + quoted(root.string()) + " is not there; expected a folder");
    for (const fs::path& base : {folder, models}) {
        const fs::path file = fs::canonical(base / relative, error);
        if (error || !(is_within(folder, file) || is_within(models, file))) continue;
        if (fs::is_regular_file(file, error)) return file;
    }
    refuse(from, place,
           quoted(relative) + ": no such file beneath the file's folder or beneath the folder of models " +
               quoted(root.string()) + "; put the model into either");
}

AdmittedFile Admission::admit(const std::string& place, const std::string& uri,
                              std::optional<std::uint64_t> declared) {
    if (uri.starts_with("data:"))
        refuse(scene_file_, place,
               "expected data:TYPE;base64, with an octet-stream, gltf-buffer, PNG or JPEG type; export the "
               "file again");
    const fs::path file = beneath_folder_of(scene_file_, place, percent_decoded(uri));
    const std::uint64_t there = size_of(file), bytes = declared.value_or(there);
    if (there < bytes)
        refuse(scene_file_, place,
               "expected a file of at least byteLength = " + std::to_string(bytes) + " bytes, found " +
                   std::to_string(there) + "; export the file again");
    total_bytes_ += bytes;
    if (bytes > limits::file_bytes || total_bytes_ > limits::total_bytes)
        refuse(scene_file_, place,
               "too large: at most " + std::to_string(limits::file_bytes) + " bytes a file and " +
                   std::to_string(limits::total_bytes) + " in all; split the scene");
    return {file, bytes};
}

}  // namespace zproof
