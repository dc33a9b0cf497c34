/// The table of texels of docs/texture-filters.md, a second time: over a grid of the finest level's texels,
/// each choice by solving for all weights anew.
#pragma once

#include <array>
#include <mutex>
#include <vector>

namespace zproof::oracle::filter_reference {

/// A texel of one of three levels, counted from the texel of its level that holds the place.
struct ChosenTexel {
    int level, column, row;
    double weight;
};

class ChosenTexels {
  public:
    static constexpr int places = 32, lods = 16;  ///< along either axis

    explicit ChosenTexels(int most) : most_{most} {}

    /// The texels for a place in eighths of a texel and a LOD in eighths of a level, above the finest of the
    /// three levels. Found when first asked for; from many threads.
    const std::vector<ChosenTexel>& at(int u, int v, int lod);

  private:
    int most_;
    std::vector<std::vector<ChosenTexel>> found_{std::size_t(places * places * lods)};
    std::vector<std::once_flag> once_{std::size_t(places * places * lods)};
};

/// The one table of all of the program's references.
ChosenTexels& chosen_texels(int most);

}  // namespace zproof::oracle::filter_reference
