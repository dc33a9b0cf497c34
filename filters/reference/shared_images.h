/// What references of one scene have in common: its images as light, and what definitions make of them.
#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <vector>

#include "filters/reference/filter_query.h"
#include "scenes/scene.h"

namespace zproof::oracle::filter_reference {

/// An image as a definition reads it.
struct DecodedImage {
    texture::LinearImage image;
    double largest = 1;  ///< of its colours' numbers, at least 1
};

using Chain = std::shared_ptr<const std::vector<IntervalImage>>;

/// Each is made once. For many threads.
class SharedImages {
  public:
    std::shared_ptr<const DecodedImage> decoded(const Image& stored, Decoding decoding);
    /// As exact_image() and chain(), of an image that decoded() has given; any other's is made anew.
    std::shared_ptr<const IntervalImage> exact(const texture::LinearImage& image);
    Chain chain(const texture::LinearImage& image, const Settings& settings);

  private:
    /// What of the settings a chain depends on.
    struct ChainRule {
        ChainKernel kernel;
        Wrap wrap_u, wrap_v;
        double texel_bits;
        LevelFormat format;
        std::shared_ptr<const std::vector<texture::LinearImage>> given_levels;

        bool operator==(const ChainRule&) const = default;
    };
    struct MadeChain {
        ChainRule rule;
        Chain chain;
    };
    struct Shared {
        Image stored;
        Decoding decoding;
        DecodedImage decoded;
        std::shared_ptr<const IntervalImage> exact;
        std::deque<MadeChain> chains;  ///< the latest first
    };
    Shared* of(const texture::LinearImage& image);

    std::mutex mutex_;
    std::deque<std::shared_ptr<Shared>> images_;  ///< the latest first
};

/// The same for one definition: shared where its settings say with whom.
std::shared_ptr<const DecodedImage> decoded_image(const Image& stored, const Settings& settings);
std::shared_ptr<const IntervalImage> exact_level(const texture::LinearImage& image, const Settings& settings);
Chain chain_of(const texture::LinearImage& image, const Settings& settings);

}  // namespace zproof::oracle::filter_reference
