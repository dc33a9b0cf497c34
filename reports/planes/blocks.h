/// Blocks of a container, with what a reader must know to decode each. Every plane has the CRC-32 of what it
/// decodes to.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "reports/planes/coding.h"
#include "reports/planes/container.h"

namespace zproof::planes {

/// The facts of a plane of that coding.
nlohmann::json plane_facts(std::string_view coding, std::string_view decoded);

/// Row-major, values.size() a multiple of width > 0.
Block predicted(const std::string& name, Words values, std::size_t width, Prediction prediction);

/// Another plane that stands before in the container; the reader needs it as well.
struct Guess {
    std::string name;
    Words values;
};

/// The block is guessed from another plane of the same size.
Block beside(const std::string& name, Words values, const Guess& guess);

/// A byte per pixel.
Block bytes_block(const std::string& name, std::string_view bytes);

/// A byte per pixel, mostly that of its neighbour.
Block runs_block(const std::string& name, std::string_view bytes);

Block json_block(const std::string& name, const nlohmann::json& content);

}  // namespace zproof::planes
