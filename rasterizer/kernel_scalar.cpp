// Sixteen lanes in plain C++: any processor.
#include "rasterizer/kernel.h"
#include "rasterizer/view_setup.h"

namespace zproof::rasterizer::scalar {
namespace {

struct Mask {
    unsigned lanes = 0;  ///< bit i: lane i
};

unsigned bits_of(Mask mask) { return mask.lanes; }

struct Doubles {
    double lane[16];
};

struct Floats {
    float lane[16];
};

struct Ints {
    std::int32_t lane[16];
};

unsigned negative_lanes(const Ints& a) {
    unsigned lanes = 0;
    for (int i = 0; i < 16; ++i) lanes |= unsigned{a.lane[i] < 0} << i;
    return lanes;
}

Mask without_negative(Mask mask, const Ints& a) { return {mask.lanes & ~negative_lanes(a)}; }

Ints splat(std::int32_t value) {
    Ints splat;
    for (std::int32_t& lane : splat.lane) lane = value;
    return splat;
}

Ints load(const std::int32_t* values) {
    Ints a;
    for (int i = 0; i < 16; ++i) a.lane[i] = values[i];
    return a;
}

void store(std::int32_t* to, const Ints& values) {
    for (int i = 0; i < 16; ++i) to[i] = values.lane[i];
}

Ints operator+(const Ints& a, const Ints& b) {
    Ints sum;
    for (int i = 0; i < 16; ++i) sum.lane[i] = a.lane[i] + b.lane[i];
    return sum;
}

Ints operator*(const Ints& a, std::int32_t b) {
    Ints product;
    for (int i = 0; i < 16; ++i) product.lane[i] = a.lane[i] * b;
    return product;
}

Ints operator|(const Ints& a, const Ints& b) {
    Ints either;
    for (int i = 0; i < 16; ++i) either.lane[i] = a.lane[i] | b.lane[i];
    return either;
}

/// `set` with `bit` besides where a value is not negative.
Ints with_bit_where_not_negative(const Ints& set, std::int32_t bit, const Ints& values) {
    Ints more;
    for (int i = 0; i < 16; ++i) more.lane[i] = set.lane[i] | (~(values.lane[i] >> 31) & bit);
    return more;
}

Doubles splat(double value) {
    Doubles d;
    for (double& lane : d.lane) lane = value;
    return d;
}

Floats splat(float value) {
    Floats f;
    for (float& lane : f.lane) lane = value;
    return f;
}

Doubles load(const double* values) {
    Doubles d;
    for (int i = 0; i < 16; ++i) d.lane[i] = values[i];
    return d;
}

Floats load(const float* values) {
    Floats f;
    for (int i = 0; i < 16; ++i) f.lane[i] = values[i];
    return f;
}

/// Four rows of four, `stride` apart.
Floats load_square(const float* values, std::ptrdiff_t stride) {
    Floats f;
    for (int i = 0; i < 16; ++i) f.lane[i] = values[i / 4 * stride + i % 4];
    return f;
}

void store(double* to, const Doubles& values) {
    for (int i = 0; i < 16; ++i) to[i] = values.lane[i];
}

Doubles operator+(const Doubles& a, const Doubles& b) {
    Doubles d;
    for (int i = 0; i < 16; ++i) d.lane[i] = a.lane[i] + b.lane[i];
    return d;
}

Doubles operator*(const Doubles& a, double b) {
    Doubles d;
    for (int i = 0; i < 16; ++i) d.lane[i] = a.lane[i] * b;
    return d;
}

Doubles operator*(const Doubles& a, const Doubles& b) {
    Doubles d;
    for (int i = 0; i < 16; ++i) d.lane[i] = a.lane[i] * b.lane[i];
    return d;
}

Doubles doubles_of(const Ints& a) {
    Doubles d;
    for (int i = 0; i < 16; ++i) d.lane[i] = a.lane[i];
    return d;
}

/// Clamps whole numbers to [-most, most].
Ints clamped(const Doubles& a, double most) {
    Ints whole;
    for (int i = 0; i < 16; ++i) {
        const double at_most = a.lane[i] < most ? a.lane[i] : most;
        whole.lane[i] = std::int32_t(at_most > -most ? at_most : -most);
    }
    return whole;
}

Mask greater(const Floats& a, const Floats& b) {
    Mask mask;
    for (int i = 0; i < 16; ++i) mask.lanes |= unsigned{a.lane[i] > b.lane[i]} << i;
    return mask;
}

Mask not_less(const Floats& a, const Floats& b) {
    Mask mask;
    for (int i = 0; i < 16; ++i) mask.lanes |= unsigned{a.lane[i] >= b.lane[i]} << i;
    return mask;
}

Mask equal(const Floats& a, const Floats& b) {
    Mask mask;
    for (int i = 0; i < 16; ++i) mask.lanes |= unsigned{a.lane[i] == b.lane[i]} << i;
    return mask;
}

Mask operator|(Mask a, Mask b) { return {a.lanes | b.lanes}; }

/// The lanes of `where` that hold more than `least`.
Mask above(Mask where, const std::uint32_t* values, std::uint32_t least) {
    Mask mask;
    for (int i = 0; i < 16; ++i) mask.lanes |= unsigned{values[i] > least} << i;
    return {mask.lanes & where.lanes};
}

Floats rounded(const Doubles& a) {
    Floats f;
    for (int i = 0; i < 16; ++i) f.lane[i] = float(a.lane[i]);
    return f;
}

Floats select(Mask where, const Floats& a, const Floats& b) {
    Floats f;
    for (int i = 0; i < 16; ++i) f.lane[i] = where.lanes >> i & 1 ? a.lane[i] : b.lane[i];
    return f;
}

void store(float* to, const Floats& values) {
    for (int i = 0; i < 16; ++i) to[i] = values.lane[i];
}

void put(std::uint32_t* to, Mask where, std::uint32_t value) {
    for (int i = 0; i < 16; ++i) to[i] = where.lanes >> i & 1 ? value : to[i];
}

float least_of(const Floats& f) {
    float least = f.lane[0];
    for (const float lane : f.lane) least = lane < least ? lane : least;
    return least;
}

/// Stores the least of each of four times sixteen values.
void store_least_of_four(float* to, const float* values) {
    for (int i = 0; i < 4; ++i) to[i] = least_of(load(values + 16 * i));
}

/// Writes index + 16 b for every bit b of the sixteen, and perhaps something after them. Returns how many
/// there are.
int put_bits(std::uint8_t* to, unsigned bits, int index) {
    int count = 0;
    for (; bits != 0; bits &= bits - 1) to[count++] = std::uint8_t(16 * __builtin_ctz(bits) + index);
    return count;
}

/// Four pixels past the caches: nobody reads them soon, and no line is fetched to be overwritten. Here they
/// go the ordinary way.
void stream_four(void* to, const void* four) { __builtin_memcpy(to, four, 16); }
void publish() noexcept {}

/// Sixteen vertices.
void put_side_by_side(const SnappedVertex* const (&vertex)[16], std::int32_t* x, std::int32_t* y,
                      double* inverse_depth) {
    for (int i = 0; i < 16; ++i) {
        x[i] = vertex[i]->p.x;
        y[i] = vertex[i]->p.y;
        inverse_depth[i] = vertex[i]->inverse_depth;
    }
}

/// The other way.
void put_one_by_one(const std::int32_t* x, const std::int32_t* y, const double* inverse_depth,
                    SnappedVertex* vertex) {
    for (int i = 0; i < 16; ++i) vertex[i] = {{x[i], y[i]}, inverse_depth[i]};
}

#include "rasterizer/kernel.inl"

}  // namespace

const Kernel kernel{Isa::scalar, "scalar", project,          place,        clear,      resolve, publish,
                    draw,        count,    draw_every_block, draw_tallied, draw_shaded};

}  // namespace zproof::rasterizer::scalar
