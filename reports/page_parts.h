/// What the pages of studies have in common. Markup comes escaped.
#pragma once

#include <string>
#include <string_view>

#include "frame/picture.h"
#include "frame/plane.h"
#include "reports/page_scripts.h"

namespace zproof {

/// The page from <!DOCTYPE> to </head>; `title` is plain text. It admits that script and no other.
std::string page_head(const std::string& title, std::string_view own_style,
                      const PageScript& script = table_script());

/// The page from the end of the content on: the script, and nothing after it.
std::string page_end(const PageScript& script = table_script());

/// "#0072b2"
std::string css_colour(Rgb8 colour);

/// A PNG as a data URI.
std::string png_uri(const Plane<Rgb8>& picture);

/// An image with its plain-text caption. Images of one group share a zoom and a place; empty: of none.
std::string page_figure(const std::string& uri, const std::string& caption, const std::string& group = "");

}  // namespace zproof
