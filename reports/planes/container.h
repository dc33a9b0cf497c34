/// planes.zvp: the blocks that the viewer shows of one view.
///
///     "ZVP1", the header's length (uint32, little-endian), the header (JSON), then the blocks one after
///     another
///
/// The header's "blocks" lists them in order with "name" and "bytes", and whatever else decoding one needs.
#pragma once

#include <functional>
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

/// Throws ReportError, naming `place`, where the text is no such container.
Container unpacked(std::string_view text, const std::string& place);

}  // namespace zproof::planes
