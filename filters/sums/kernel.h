/// Rows of a summed-area table, several at a time, by the widest vectors that the machine has.
///
/// kernel_scalar.cpp, kernel_avx2.cpp and kernel_avx512.cpp are compiled for one instruction set each and
/// share the algorithm of rows.inl. Whole numbers have no order: all write the same. Plain structs only, as
/// in filters/reads/kernel.h.
#pragma once

#include <cstddef>
#include <cstdint>

namespace zproof::texture::sums {

/// Rows that follow each other, row after row and channels side by side.
template <class Code>
struct Rows {
    const Code* codes = nullptr;
    std::size_t count = 0;
    std::size_t width = 0;   ///< values of a row that are looked at
    std::size_t stride = 0;  ///< from row to row; a multiple of `channels`
    std::size_t channels = 1;
    std::uint32_t* columns = nullptr;  ///< of everything above, `width` of them; these rows are added to them
};

/// The place where the table's rows go.
struct Table {
    std::uint32_t* sums = nullptr;  ///< of the first row; they follow each other as the codes' do
    bool is_streamed = false;       ///< past the caches, as far as whole vectors go
};

struct Kernel {
    const char* name = "";
    void (*add_bytes)(const Rows<std::uint8_t>& rows) noexcept = nullptr;
    void (*add_words)(const Rows<std::uint16_t>& rows) noexcept = nullptr;
    void (*sum_bytes)(const Rows<std::uint8_t>& rows, const Table& table) noexcept = nullptr;
    void (*sum_words)(const Rows<std::uint16_t>& rows, const Table& table) noexcept = nullptr;
};

namespace scalar {
extern const Kernel kernel;
}
namespace avx2 {
extern const Kernel kernel;
}
namespace avx512 {
extern const Kernel kernel;
}

/// One for each InstructionSet of the machine, for widest_of() and available_of().
inline constexpr const Kernel* kernels[] = {
    &scalar::kernel,
#ifdef __x86_64__
    &avx2::kernel,
    &avx512::kernel,
#endif
};

}  // namespace zproof::texture::sums
