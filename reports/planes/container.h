/// planes.zvp: the blocks that the viewer shows of one view.
///
///     "ZVP1", the header's length (uint32, little-endian), the header (JSON), then the blocks one after
///     another
///
/// The header's "blocks" lists them in order with "name" and "bytes", and whatever else decoding one needs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "reports/report_error.h"

namespace zproof::planes {

struct Block {
    std::string name;
    nlohmann::json facts;  ///< an object: how to decode it
    std::string content;
};

struct Container {
    nlohmann::json header;  ///< an object without "blocks"
    std::vector<Block> blocks;
};

std::string packed(const Container& container);
/// packed() as a whole file. Throws FrameError where it cannot be written.
void write(const std::filesystem::path& file, const Container& container);

/// Throws ReportError, naming `place`, where the text is no such container.
Container unpacked(std::string_view text, const std::string& place);

/// The place of a block's content in a file.
struct BlockPlace {
    std::string name;
    nlohmann::json facts;
    std::uint64_t first = 0, size = 0;  ///< bytes
};

/// A container without what its blocks hold.
struct Directory {
    nlohmann::json header;
    std::vector<BlockPlace> blocks;
};

/// The directory of the container in a file; its blocks are not read. Throws ReportError, naming the file,
/// where it is none.
Directory directory_of(const std::filesystem::path& file);

/// All of packed() that stands before the contents of these blocks.
std::string packed_front(const Directory& directory);

}  // namespace zproof::planes
