/// Numbers and names as text, and text made safe for the page that it goes to.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "frame/frame.h"
#include "frame/number_text.h"
#include "frame/printable.h"

namespace zproof {

std::string id_text(PrimitiveId id);  ///< "4711", or "none" for background

/// "1 view", "2 views".
std::string counted(std::uint64_t count, std::string_view noun);

/// "57,600 of 2,073,600 pixels, chosen by seed 1".
std::string sample_words(std::uint64_t pixels, std::uint64_t of_pixels, std::uint64_t seed);

/// printable(text), safe as content and in quoted attributes of HTML and XML.
std::string escaped(std::string_view text);

/// A field of a CSV file, in quotes where it needs them (RFC 4180).
std::string csv_field(const std::string& text);

/// A relative path as a URL: everything but letters, digits and "-._~/" is percent-encoded.
std::string as_url(std::string_view path);

}  // namespace zproof
