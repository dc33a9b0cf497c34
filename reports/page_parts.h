/// What the pages of texture filters have in common. Markup comes escaped.
#pragma once

#include <string>
#include <string_view>

#include "frame/png.h"

namespace zproof {

/// From <!DOCTYPE> to </head>; `title` is plain text.
std::string page_head(const std::string& title, std::string_view own_style);

/// A PNG as a data URI.
std::string png_uri(const Plane<Rgb8>& picture);

/// An image with its plain-text caption.
std::string page_figure(const std::string& uri, const std::string& caption);

}  // namespace zproof
