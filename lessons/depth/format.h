/// What a depth buffer may hold, and the arithmetic in float32 that brings a depth there.
///
/// Symbols, here and in docs/depth.md: n, f are the near and far planes, d is camera depth, v = 1 / d, s is
/// the value in the buffer's own unit, 0 to 1 between the planes (1 to 0 where it is reversed).
#pragma once

#include <span>
#include <string>

namespace zproof::study::depth {

/// Which function of depth is stored.
enum class Coding {
    z,            ///< a + b / d, 0 at near, 1 at far: what a projection matrix gives
    reversed,     ///< the same, 1 at near, 0 at far
    w,            ///< (d - n) / (f - n)
    logarithmic,  ///< log(d / n) / log(f / n)
};

/// The interval that the projection matrix maps near and far to, before the window's [0, 1].
enum class NdcRange {
    zero_to_one,       ///< Direct3D, Vulkan
    minus_one_to_one,  ///< OpenGL: halved and moved by 1/2 on the way to the window
};

enum class Store {
    float32,
    unorm24,  ///< whole numbers 0 to 2^24 - 1, rounded to nearest
    unorm16,  ///< whole numbers 0 to 2^16 - 1, rounded to nearest
};

struct Format {
    const char* name = "";
    Coding coding = Coding::z;
    NdcRange range = NdcRange::zero_to_one;
    Store store = Store::float32;
};

/// Every format that is studied, the plain ones first.
std::span<const Format> formats();

/// The format of that name. Throws std::out_of_range where there is none.
const Format& format_named(const std::string& name);

int bits_of(Store store);

/// "z = a + b/d in [-1, 1], then the window; 24 bits": what the format holds, in words.
std::string definition_of(const Format& format);

/// The clip planes: 0 < near < far. far may be +inf for z and reversed.
struct Planes {
    double near = 0.1, far = 1000;
};

/// Is it affine in 1 / d, and so, under perspective, in the image?
bool is_affine_in_image(Coding coding);

/// Does s grow with depth? Then the smaller s is the nearer one.
bool grows_with_depth(Coding coding);

/// Does the coding mean something between these planes? Those that are not affine in 1 / d need a
/// finite far plane.
bool can_hold(Coding coding, const Planes& planes);

/// The coding's constants. d and s as above: s = a + b v (z, reversed), (d - n) k (w), log2(d / n) k
/// (logarithmic); in NDC's own unit, `half` is 1/2 where the window halves it, else 1.
struct Constants {
    double a = 0, b = 0, k = 0, near = 1, half = 1;
};
Constants constants_of(const Format& format, const Planes& planes);

/// Brings depths into the buffer as a renderer in float32 does it. Every argument is a value: NaN, infinite,
/// zero and negative depths give whatever the arithmetic gives.
class Coder {
  public:
    Coder(const Format& format, const Planes& planes);

    /// s, of a depth: what a corner gets. z: (a d + b) / d, as matrix and division have it.
    float of_depth(float depth) const;
    /// s, of 1 / depth: what a pixel gets whose 1 / depth was interpolated.
    float of_inverse(float inverse) const;

    /// s as the buffer holds it: cut to [0, 1] and rounded to the store. NaN stays NaN in float32 and is 0
    /// in whole numbers (Direct3D 11.3, 3.2.3.6).
    double stored(float s) const;
    /// Is the first of two stored values nearer for certain? Never where one is NaN.
    bool is_nearer(double first, double second) const {
        return grows_with_depth(format_.coding) ? first < second : first > second;
    }

    /// s of a depth and depth of s by the formula itself, in double.
    double ideal(double depth) const;
    double depth_of(double s) const;

    const Format& format() const { return format_; }
    const Constants& constants() const { return exact_; }

  private:
    float in_window(float z_ndc) const;

    Format format_;
    Constants exact_;
    float a_, b_, k_, near_, inverse_near_;  ///< each rounded once
};

}  // namespace zproof::study::depth
