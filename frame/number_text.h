/// Numbers as text.
#pragma once

#include <cstdint>
#include <string>

namespace zproof {

/// The shortest decimal that reads back to the same bits; "nan", "inf", "-inf" otherwise.
std::string shortest(double value);
std::string shortest(float value);

std::string with_digits(double value, int digits);  ///< so many significant ones at most: "0.1", "1.2e+07"
std::string rounded(double value);                  ///< three significant digits: "0.934", "41.2", "1.2e+07"
std::string fixed(double value, int decimals);      ///< "12.30"
std::string hex_bits(float value);                  ///< "0x3f800000"
std::string grouped(std::uint64_t value);           ///< "12,345,678"
std::string size_text(std::int64_t width, std::int64_t height);  ///< "1920 x 1080"

}  // namespace zproof
