#include "reports/planes/error_code.h"

#include <bit>
#include <limits>

#include "math/widest.h"

namespace zproof::planes {

namespace {

constexpr int fraction_bits = std::numeric_limits<float>::digits - 1;
constexpr std::uint32_t infinite = 0xFFu << fraction_bits;

/// The fraction bits of the least float in [1, 2) that is not below `least`.
constexpr std::uint32_t least_fraction(double least) {
    const double exact = (least - 1) * (1 << fraction_bits);
    const auto whole = std::uint32_t(exact);
    return whole + (double(whole) < exact);
}

/// No branches, so that neighbours are done side by side.
[[gnu::always_inline]] inline std::uint8_t code_of(float ratio) {
    constexpr std::uint32_t first = least_fraction(1.189207115002721),
                            second = least_fraction(1.4142135623730951),
                            third = least_fraction(1.681792830507429);
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(ratio) & 0x7FFF'FFFF;
    const int octave = int(bits >> fraction_bits) - 127;  // 0 and what is denormal is far below 2^-50
    const std::uint32_t fraction = bits % (1u << fraction_bits);
    const int part = (fraction >= first) + (fraction >= second) + (fraction >= third);
    const int place = 4 * octave + part + 200;
    const int within = place < 0 ? 0 : place > 254 ? 254 : place;
    return std::uint8_t(bits > infinite ? 0 : 1 + within);  // infinity's octave is the last
}

void fill_codes(const float* errors, std::size_t count, char* codes) {
    for (std::size_t i = 0; i < count; ++i) codes[i] = char(code_of(errors[i]));
}

}  // namespace

std::uint8_t error_code(float ratio) { return code_of(ratio); }

std::string error_codes(std::span<const float> errors) {
    std::string codes(errors.size(), '\0');
    widest<fill_codes>(errors.data(), errors.size(), codes.data());
    return codes;
}

}  // namespace zproof::planes
