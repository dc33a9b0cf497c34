// Sixteen lanes in plain C++: any processor.
#include "rasterizer/kernel.h"
#include "rasterizer/view_setup.h"

namespace zproof::rasterizer::scalar {
namespace {

struct Mask {
    unsigned lanes = 0;  ///< bit i: lane i
};

Mask operator&(Mask a, Mask b) { return {a.lanes & b.lanes}; }
unsigned bits_of(Mask mask) { return mask.lanes; }
Mask narrowed(Mask mask) { return mask; }

struct Doubles {
    double lane[16];
};

struct Floats {
    float lane[16];
};

Doubles all(double value) {
    Doubles d;
    for (double& lane : d.lane) lane = value;
    return d;
}

Floats all(float value) {
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

Mask at_least(const Doubles& a, double b) {
    Mask mask;
    for (int i = 0; i < 16; ++i) mask.lanes |= unsigned{a.lane[i] >= b} << i;
    return mask;
}

Mask greater(const Floats& a, const Floats& b) {
    Mask mask;
    for (int i = 0; i < 16; ++i) mask.lanes |= unsigned{a.lane[i] > b.lane[i]} << i;
    return mask;
}

Floats rounded(const Doubles& a) {
    Floats f;
    for (int i = 0; i < 16; ++i) f.lane[i] = float(a.lane[i]);
    return f;
}

Floats chosen(Mask where, const Floats& a, const Floats& b) {
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

/// Four pixels past the caches: nobody reads them soon, and no line is fetched to be overwritten. Here they
/// go the ordinary way.
void stream_four(void* to, const void* four) { __builtin_memcpy(to, four, 16); }
void finish_streams() {}

#include "rasterizer/kernel.inl"

}  // namespace

const Kernel kernel{Isa::scalar, "scalar", project,          place,        resolve,
                    draw,        count,    draw_every_block, draw_tallied, draw_shaded};

}  // namespace zproof::rasterizer::scalar
