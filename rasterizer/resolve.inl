// A tile's pixels into the frame: out of blocks into rows, inverse depth into camera depth.

/// Four blocks beside each other: 16 x 4 pixels, kept one after the other.
constexpr int strip_width = 16, strip_size = 4 * strip_width;

/// A row of a strip into a row of the frame, which nobody reads before it is whole.
template <class Value, class Kept>
void put_row(Value* to, const Kept* strip_row, int columns) {
    static_assert(sizeof(Value) == 4 && sizeof(Kept) == 4);
    if (columns >= strip_width && reinterpret_cast<std::uintptr_t>(to) % 16 == 0)
        for (int x = 0; x < strip_width; x += 4) stream_four(to + x, strip_row + 4 * x);
    else
        for (int x = 0; x < min(columns, strip_width); ++x)
            __builtin_memcpy(to + x, strip_row + x / 4 * 16 + x % 4, 4);
}

void resolve(const ResolveWork& work) noexcept {
    const DepthFunctional functional = work.depth;
    for (int y = 0; y < work.rows; y += 4) {
        for (int x = 0; x < work.columns; x += strip_width) {
            const float* const inverse_depth = work.pixels.inverse_depth + place_in_tile(x, y);
            const std::uint32_t* const primitive = work.pixels.primitive + place_in_tile(x, y);
            alignas(64) float depth[strip_size];
            for (int i = 0; i < strip_size; ++i) {
                const float seen = functional.depth_of(inverse_depth[i]);
                depth[i] = inverse_depth[i] > nothing_seen ? seen : background_depth;
            }
            for (int row = 0; row < min(4, work.rows - y); ++row) {
                const std::size_t to = work.stride * std::size_t(y + row) + std::size_t(x);
                const std::ptrdiff_t from = std::ptrdiff_t{4} * row;
                put_row(work.camera_depth + to, depth + from, work.columns - x);
                put_row(work.primitive + to, primitive + from, work.columns - x);
            }
        }
    }
}
