#include "tests/reports/packed_page.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <boost/archive/iterators/binary_from_base64.hpp>
#include <boost/archive/iterators/transform_width.hpp>

namespace zproof {
namespace {

constexpr std::size_t largest_text = std::size_t{1} << 23;

std::string content_of_element(const std::string& page, const std::string& id) {
    const std::string begin = " id=\"" + id + "\">";
    const std::size_t at = page.find(begin);
    if (at == std::string::npos) return "";
    const std::size_t first = at + begin.size();
    return page.substr(first, page.find('<', first) - first);
}

std::string from_base64(const std::string& text) {
    using namespace boost::archive::iterators;
    using Bytes = transform_width<binary_from_base64<std::string::const_iterator>, 8, 6>;
    const std::size_t padding = std::size_t(std::ranges::count(text, '=')), digits = text.size() - padding;
    std::string bytes;
    Bytes byte(text.begin());
    for (std::size_t i = 0; i < digits * 6 / 8; ++i) bytes += *byte++;
    return bytes;
}

}  // namespace

std::string packed_text(const std::string& page, const std::string& id) {
    const std::string packed = from_base64(content_of_element(page, id));
    if (packed.empty()) return "";
    std::string text(largest_text, '\0');
    uLongf size = text.size();
    EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(text.data()), &size,
                         reinterpret_cast<const Bytef*>(packed.data()), packed.size()),
              Z_OK);
    text.resize(size);
    return text;
}

planes::Container embedded_planes(const std::string& page, const std::string& anchor) {
    return planes::unpacked(from_base64(content_of_element(page, "planes-" + anchor)), anchor);
}

}  // namespace zproof
