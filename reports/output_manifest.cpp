#include "reports/output_manifest.h"

#include <isa-l/crc64.h>

#include <fstream>
#include <ios>
#include <sstream>
#include <vector>

#include "frame/whole_file.h"
#include "reports/report_error.h"

namespace zproof {
namespace {

namespace fs = std::filesystem;

constexpr const char* unfinished = "zproof has not finished this folder.";
constexpr const char* finished_partial =
    "zproof was interrupted, and made this folder of what it had. It replaces and removes only what is "
    "listed "
    "here: bytes, CRC-64, file.";
constexpr const char* finished =
    "zproof made this folder. It replaces and removes only what is listed here: bytes, CRC-64, file.";

std::string first_line(std::istream& in) {
    std::string line;
    std::getline(in, line);
    return line;
}

void close_written(std::ofstream& out, const fs::path& folder) {
    out.close();
    if (!out) throw ReportError(folder.string() + ": cannot be written to; is the disk full?");
}

}  // namespace

void mark_unfinished(const fs::path& folder) {
    std::ofstream out(folder / output_marker);
    out << unfinished << "\n";
    close_written(out, folder);
}

void mark_finished(const fs::path& folder, Completeness completeness) try {
    OutputManifest manifest;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        if (const auto file = as_it_is(entry.path()); file && entry.path() != folder / output_marker)
            manifest.emplace(entry.path().lexically_relative(folder).generic_string(), *file);
    std::ofstream out(folder / output_marker);
    out << (completeness == Completeness::full ? finished : finished_partial) << "\n" << std::hex;
    for (const auto& [name, file] : manifest)
        out << std::dec << file.bytes << " " << std::hex << file.crc64 << " " << name << "\n";
    close_written(out, folder);
} catch (const fs::filesystem_error& e) {
    throw ReportError(folder.string() + ": cannot be read: " + e.code().message());
}

bool is_unfinished(const fs::path& folder) {
    std::istringstream in(content_of(folder / output_marker));
    return first_line(in) == unfinished;
}

bool is_full(const fs::path& folder) {
    std::istringstream in(content_of(folder / output_marker));
    return first_line(in) == finished;
}

std::optional<OutputManifest> manifest_in(const fs::path& folder) {
    std::istringstream in(content_of(folder / output_marker));
    if (const std::string line = first_line(in); line != finished && line != finished_partial)
        return std::nullopt;
    OutputManifest manifest;
    WrittenFile file{};
    for (std::string name;
         in >> std::dec >> file.bytes >> std::hex >> file.crc64 && std::getline(in >> std::ws, name);)
        manifest.emplace(name, file);
    return manifest;
}

std::optional<WrittenFile> as_it_is(const fs::path& file) {
    std::error_code failure;
    if (!fs::is_regular_file(fs::symlink_status(file, failure))) return std::nullopt;
    std::ifstream in(file, std::ios::binary);
    WrittenFile sum{0, 0};
    std::vector<char> piece(1 << 20);
    while (in.read(piece.data(), std::streamsize(piece.size())), in.gcount() > 0) {
        const auto* bytes = reinterpret_cast<const unsigned char*>(piece.data());
        sum.crc64 = crc64_ecma_refl(sum.crc64, bytes, std::uint64_t(in.gcount()));
        sum.bytes += std::uintmax_t(in.gcount());
    }
    if (!in.eof()) return std::nullopt;
    return sum;
}

}  // namespace zproof
