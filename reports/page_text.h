/// A page of which the larger part lies in files: it is written piece by piece and never stands in memory
/// whole.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "reports/report_error.h"
#include "reports/text_sink.h"

namespace zproof {

/// Some bytes of a file.
struct ByteRange {
    std::uint64_t first = 0, size = 0;
};

/// Some bytes, and behind them parts of a file; all of that as one text in base64.
struct FileAsBase64 {
    std::string front;
    std::filesystem::path file;
    std::vector<ByteRange> ranges;
};

using PagePiece = std::variant<std::string, FileAsBase64>;

/// Its pieces one after another are its text.
using Page = std::vector<PagePiece>;

/// Puts the page out; base64 is made on the threads of the surrounding tbb::task_arena. Throws ReportError
/// where one of the files cannot be read.
void write_page(const TextSink& out, const Page& page);

/// Writes it in place of `file`. Throws ReportError where it cannot be written.
void write_page(const std::filesystem::path& file, const Page& page);

/// The text of the page that write_page() writes.
std::string text_of(const Page& page);

}  // namespace zproof
