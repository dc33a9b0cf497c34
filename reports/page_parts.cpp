#include "reports/page_parts.h"

#include "image_io/image_io.h"
#include "reports/base64.h"
#include "reports/html_parts.h"
#include "reports/wording.h"

namespace zproof {

std::string page_head(const std::string& title, std::string_view own_style, const PageScript& script) {
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta http-equiv=\"Content-Security-Policy\" content=\"" +
           content_policy(script) +
           "\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
           "<meta name=\"color-scheme\" content=\"light dark\">\n<title>zproof: " +
           escaped(title) + "</title>\n<style>\n" + std::string{html_style()} + std::string{own_style} +
           "</style>\n</head>\n";
}

std::string css_colour(Rgb8 c) {
    constexpr std::string_view hex = "0123456789abcdef";
    std::string text = "#";
    for (const std::uint8_t channel : {c.r, c.g, c.b}) text += {hex[channel >> 4], hex[channel & 15]};
    return text;
}

std::string png_uri(const Plane<Rgb8>& picture) {
    const std::vector<std::byte> png = encode_png(picture);
    return "data:image/png;base64," + base64({reinterpret_cast<const char*>(png.data()), png.size()});
}

std::string page_end(const PageScript& script) { return script_element(script) + "</body>\n</html>\n"; }

std::string page_figure(const std::string& uri, const std::string& caption, const std::string& group) {
    const std::string link = group.empty() ? "" : " data-linked=\"" + escaped(group) + "\"";
    return "<figure" + link + "><img src=\"" + uri + "\" alt=\"" + escaped(caption) + "\"><figcaption>" +
           escaped(caption) + "</figcaption></figure>\n";
}

}  // namespace zproof
