/// Reads back what reports/planes/coding.h writes, as the viewer does. Each throws ReportError where it is
/// damaged.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reports/planes/coding.h"

namespace zproof::planes {

std::vector<std::uint32_t> decode(std::string_view bytes, std::size_t count, std::size_t width,
                                  Prediction prediction);
std::vector<std::uint32_t> decode(std::string_view bytes, std::span<const std::uint32_t> guess);
std::vector<std::uint32_t> decode_sparse(std::string_view bytes, std::size_t count,
                                         std::span<const std::uint32_t> guess);
std::string decode_runs(std::string_view bytes, std::size_t count);
std::vector<double> decode_doubles(std::string_view bytes, std::size_t count);

/// What zproof::deflated() made of at most `most` bytes.
std::string inflated(std::string_view bytes, std::size_t most);

}  // namespace zproof::planes
