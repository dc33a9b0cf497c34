// Four lanes: what every processor of the kind has, written through the caches.
#include <utility>

#include "filters/sums/kernel.h"

namespace zproof::texture::sums::scalar {
namespace {

typedef std::uint32_t Lanes __attribute__((vector_size(16)));

template <class Code>
Lanes widened(const Code* codes) {
    return Lanes{codes[0], codes[1], codes[2], codes[3]};
}

void stream(std::uint32_t* to, Lanes sums) { __builtin_memcpy(to, &sums, sizeof sums); }
void fence() {}

#include "filters/sums/rows.inl"

}  // namespace

const Kernel kernel{"scalar", add, add, sum, sum};

}  // namespace zproof::texture::sums::scalar
