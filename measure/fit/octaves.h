/// Errors counted by powers of two, and which of them stand alone (docs/fit.md).
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace zproof::measure {

/// Octave k holds what is above 2^(k-1) and at most 2^k; the least one, all that is at most 2^least_octave.
inline constexpr int least_octave = -30, most_octave = 3;
/// Stands for what no error up to 2^most_octave explains.
inline constexpr int no_octave = most_octave + 1;

/// What errs by more than that factor less is apart from the rest.
inline constexpr int factor_apart = 10;

/// The octave of a number that is not NaN.
int octave_of(double value);

class OctaveCounts {
  public:
    void add(int octave, std::uint64_t count = 1) { counts_[index(octave)] += count; }
    std::uint64_t at(int octave) const { return counts_[index(octave)]; }
    std::uint64_t all() const;
    /// How many lie above this octave.
    std::uint64_t above(int octave) const;
    /// The greatest octave that counts any; the least one where none does.
    int greatest() const;
    /// The octave above which pixels stand alone: behind the widest gap of those that part, by more than a
    /// factor of ten, at most one pixel in a thousand from more others that err. Nothing where no gap does.
    /// What lies in no_octave stands outside of this.
    std::optional<int> last_before_gap() const;

  private:
    static std::size_t index(int octave) { return std::size_t(octave - least_octave); }

    std::array<std::uint64_t, std::size_t(no_octave - least_octave + 1)> counts_{};
};

}  // namespace zproof::measure
