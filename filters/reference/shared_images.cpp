#include "filters/reference/shared_images.h"

#include <algorithm>

#include "filters/reference/chain.h"
#include "math/srgb.h"

namespace zproof::oracle::filter_reference {

namespace {

constexpr std::size_t most_images = 4, most_chains = 4;

texture::LinearImage light_of(const Image& stored, Decoding decoding) {
    texture::LinearImage linear =
        texture::linear_image({stored.width, stored.height, stored.texels, stored.light});
    if (decoding == Decoding::before_filtering) return linear;
    for (std::size_t i = 0; i < linear.texels.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const double code = stored.texels[4 * i + std::size_t(c)] / 255.0;
            linear.texels[i][c] =
                float(decoding == Decoding::twice ? decoded_srgb(decoded_srgb(code)) : code);
        }
    return linear;
}

double largest_of(const texture::LinearImage& image) {
    float largest = 1;
    for (const glm::vec4& texel : image.texels)
        largest = std::max({largest, std::abs(texel.r), std::abs(texel.g), std::abs(texel.b)});
    return double{largest};
}

bool are_alike(const Image& a, const Image& b) {
    return a.width == b.width && a.height == b.height && a.texels == b.texels && a.light == b.light;
}

DecodedImage decode(const Image& stored, Decoding decoding) {
    DecodedImage decoded{light_of(stored, decoding)};
    decoded.largest = largest_of(decoded.image);
    return decoded;
}

template <class T>
void put_first(std::deque<T>& all, T one, std::size_t most) {
    if (all.size() == most) all.pop_back();
    all.push_front(std::move(one));
}

}  // namespace

std::shared_ptr<const DecodedImage> SharedImages::decoded(const Image& stored, Decoding decoding) {
    const std::lock_guard lock(mutex_);
    auto found = std::ranges::find_if(images_, [&](const auto& one) {
        return one->decoding == decoding && are_alike(one->stored, stored);
    });
    if (found == images_.end()) {
        put_first(images_,
                  std::make_shared<Shared>(Shared{stored, decoding, decode(stored, decoding), {}, {}}),
                  most_images);
        found = images_.begin();
    }
    return {*found, &(*found)->decoded};
}

SharedImages::Shared* SharedImages::of(const texture::LinearImage& image) {
    const auto found =
        std::ranges::find_if(images_, [&](const auto& one) { return &one->decoded.image == &image; });
    return found == images_.end() ? nullptr : found->get();
}

std::shared_ptr<const IntervalImage> SharedImages::exact(const texture::LinearImage& image) {
    const std::lock_guard lock(mutex_);
    Shared* const shared = of(image);
    if (shared == nullptr) return std::make_shared<const IntervalImage>(exact_image(image));
    if (!shared->exact) shared->exact = std::make_shared<const IntervalImage>(exact_image(image));
    return shared->exact;
}

Chain SharedImages::chain(const texture::LinearImage& image, const Settings& s) {
    const auto made = [&] {
        return std::make_shared<const std::vector<IntervalImage>>(filter_reference::chain(image, s));
    };
    ChainRule rule{s.kernel, s.wrap.u, s.wrap.v, s.texel_bits, s.format, s.given_levels};
    const std::lock_guard lock(mutex_);
    Shared* const shared = of(image);
    if (shared == nullptr) return made();
    const auto found = std::ranges::find(shared->chains, rule, &MadeChain::rule);
    if (found != shared->chains.end()) return found->chain;
    put_first(shared->chains, {std::move(rule), made()}, most_chains);
    return shared->chains.front().chain;
}

std::shared_ptr<const DecodedImage> decoded_image(const Image& stored, const Settings& settings) {
    return settings.shared ? settings.shared->decoded(stored, settings.decoding)
                           : std::make_shared<const DecodedImage>(decode(stored, settings.decoding));
}

std::shared_ptr<const IntervalImage> exact_level(const texture::LinearImage& image,
                                                 const Settings& settings) {
    return settings.shared ? settings.shared->exact(image)
                           : std::make_shared<const IntervalImage>(exact_image(image));
}

Chain chain_of(const texture::LinearImage& image, const Settings& settings) {
    return settings.shared ? settings.shared->chain(image, settings)
                           : std::make_shared<const std::vector<IntervalImage>>(chain(image, settings));
}

}  // namespace zproof::oracle::filter_reference
