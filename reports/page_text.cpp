#include "reports/page_text.h"

#include <tbb/parallel_pipeline.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <string_view>

#include "reports/base64.h"

namespace zproof {

namespace {

/// Stays in a core's own cache, and gives base64 without padding.
constexpr std::size_t bytes_in_piece = std::size_t{3} << 15;

/// Enough to keep every thread busy while one of them writes.
constexpr std::size_t pieces_under_way = 8;

/// Hands out what is to be written, piece by piece.
class PieceReader {
  public:
    explicit PieceReader(const FileAsBase64& source)
        : source_(source), front_(source.front), in_(source.file, std::ios::binary) {}

    /// The next piece of bytes_in_piece; the last one may have fewer, and is empty when nothing is left.
    std::string next() {
        std::string piece(bytes_in_piece, '\0');
        std::size_t size = 0, read = 0;
        while (size < piece.size() && (read = fill(piece.data() + size, piece.size() - size)) > 0)
            size += read;
        piece.resize(size);
        return piece;
    }

  private:
    /// How many bytes were there: 0 only where nothing is left.
    std::size_t fill(char* to, std::size_t room) {
        if (!front_.empty()) {
            const std::size_t size = front_.copy(to, room);
            front_.remove_prefix(size);
            return size;
        }
        while (range_ < source_.ranges.size() && done_ == source_.ranges[range_].size) ++range_, done_ = 0;
        if (range_ == source_.ranges.size()) return 0;
        const ByteRange& range = source_.ranges[range_];
        if (done_ == 0) in_.seekg(std::streamoff(range.first));
        const auto size = std::size_t(std::min<std::uint64_t>(room, range.size - done_));
        if (!in_.read(to, std::streamsize(size)))
            throw ReportError(source_.file.string() + ": cannot be read; run zproof again");
        done_ += size;
        return size;
    }

    const FileAsBase64& source_;
    std::string_view front_;
    std::ifstream in_;
    std::size_t range_ = 0;
    std::uint64_t done_ = 0;  ///< of that range
};

void write(const TextSink& out, const std::string& text) { out(text); }

/// While one thread writes a piece, others make the next ones.
void write(const TextSink& out, const FileAsBase64& source) {
    PieceReader reader(source);
    const auto read = [&](tbb::flow_control& flow) {
        std::string piece = reader.next();
        if (piece.empty()) flow.stop();
        return piece;
    };
    using tbb::filter_mode;
    tbb::parallel_pipeline(
        pieces_under_way,
        tbb::make_filter<void, std::string>(filter_mode::serial_in_order, read) &
            tbb::make_filter<std::string, std::string>(
                filter_mode::parallel, [](const std::string& piece) { return base64(piece); }) &
            tbb::make_filter<std::string, void>(filter_mode::serial_in_order,
                                                [&](const std::string& text) { out(text); }));
}

}  // namespace

void write_page(const TextSink& out, const Page& page) {
    for (const PagePiece& piece : page) std::visit([&](const auto& content) { write(out, content); }, piece);
}

void write_page(const std::filesystem::path& file, const Page& page) {
    std::ofstream out(file, std::ios::binary);
    write_page([&](std::string_view text) { out << text; }, page);
    if (!out.flush()) throw ReportError(file.string() + ": cannot be written; is the disk full?");
}

std::string text_of(const Page& page) {
    return collected([&](const TextSink& out) { write_page(out, page); });
}

}  // namespace zproof
