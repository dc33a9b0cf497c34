// Two lanes: what every processor of the kind has.
#include <limits>
#include <utility>

#include "filters/reads/kernel.h"

namespace zproof::texture::reads::scalar {
namespace {

constexpr int lanes = 2;
typedef double Lanes __attribute__((vector_size(16)));
typedef std::int64_t Bits __attribute__((vector_size(16)));

Lanes gather(const double* numbers, const std::int32_t* index) {
    return Lanes{numbers[std::ptrdiff_t{8} * index[0]], numbers[std::ptrdiff_t{8} * index[1]]};
}

Bits product(Bits a, Bits b) { return a * b; }

/// Adds 2^52 of x's own sign, which rounds x to a whole number.
Lanes whole_below(Lanes x) {
    const Bits sign = reinterpret_cast<Bits>(x) & std::numeric_limits<std::int64_t>::min();
    const Lanes large = reinterpret_cast<Lanes>(sign | reinterpret_cast<Bits>(0x1p52 + Lanes{})),
                nearest = (x + large) - large;
    return nearest > x ? nearest - 1 : nearest;
}

#include "filters/reads/taps.inl"

class Colour {
  public:
    explicit Colour(const double* sum) {
        __builtin_memcpy(&rg_, sum, sizeof rg_);
        __builtin_memcpy(&ba_, sum + 2, sizeof ba_);
    }
    void add(const float* texel, double weight) {
        rg_ += weight * Lanes{double(texel[0]), double(texel[1])};
        ba_ += weight * Lanes{double(texel[2]), double(texel[3])};
    }
    void to(double* sum) const {
        __builtin_memcpy(sum, &rg_, sizeof rg_);
        __builtin_memcpy(sum + 2, &ba_, sizeof ba_);
    }

  private:
    Lanes rg_, ba_;
};

#include "filters/reads/block.inl"

#include "filters/reads/lines.inl"

}  // namespace

const Kernel kernel{"scalar", find_taps, add_up, add_lines};

}  // namespace zproof::texture::reads::scalar
