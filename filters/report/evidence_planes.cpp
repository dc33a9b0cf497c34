#include "filters/report/evidence_planes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "reports/planes/blocks.h"

namespace zproof {

namespace {

using planes::Words;

struct Channel {
    const char* name;
    float LinearRgb::*value;
};
constexpr std::array<Channel, 3> channels{
    {{".r", &LinearRgb::r}, {".g", &LinearRgb::g}, {".b", &LinearRgb::b}}};

std::vector<float> channel_of(const Picture& picture, const Channel& channel) {
    std::vector<float> values;
    for (const LinearRgb& colour : picture.pixels()) values.push_back(colour.*channel.value);
    return values;
}

/// One number per element.
template <class T, class ValueOf>
std::vector<float> floats(const Plane<T>& plane, const ValueOf& value_of) {
    std::vector<float> values;
    for (const T& element : plane.pixels()) values.push_back(float(value_of(element)));
    return values;
}

Words words(const std::vector<float>& values) { return std::span(values); }

/// Both guesses are planes of the container; a grey picture has nothing to add to its red channel.
planes::Block channel_block(const std::string& name, Words values, const planes::Guess& red,
                            const planes::Guess& truth) {
    const bool is_grey = planes::missed_by(values, red.values) < values.size() / 16;
    return planes::beside(name, values, is_grey ? red : truth);
}

constexpr int page_tiers = 4;

int evidence_tier_of(const std::string& block) {
    if (block.starts_with("inspected.")) return page_tiers;
    if (block.starts_with("footprint.")) return 3;
    if (block.starts_with("claim.")) return 2;
    if (!block.starts_with("method.")) return 0;
    return block.ends_with(".flip") ? 2 : 1;
}

/// "method.LABEL.r" and "claim.LABEL.least.r" belong together; a label may have dots.
std::string script_of(const std::string& block) {
    if (block.starts_with("footprint.")) return "footprint";
    if (block.starts_with("inspected.")) return block;
    const bool is_claim = block.starts_with("claim.");
    if (!is_claim && !block.starts_with("method.")) return "view";
    const std::string named = block.substr(block.find('.'));
    const std::size_t last = named.rfind('.');
    return named.substr(0, is_claim ? named.rfind('.', last - 1) : last);
}

}  // namespace

EvidencePlanes::EvidencePlanes(const study::ViewEvidence& evidence)
    : size_(evidence.truth.size()),
      truth_(evidence.truth),
      regions_(nlohmann::json::array()),
      claims_(nlohmann::json::object()) {
    for (const study::Region& region : evidence.regions)
        regions_.push_back({{"name", region.name}, {"pixels", region.pixels}});
    const Plane<std::uint32_t> bits = study::region_bits(evidence.regions);
    blocks_.push_back(
        planes::predicted("region", bits.pixels(), std::size_t(size_.width), planes::Prediction::left));
    const std::vector<float> red = channel_of(truth_, channels[0]);
    add_words("truth.r", red);
    for (std::size_t i = 1; i < channels.size(); ++i)
        blocks_.push_back(planes::beside(std::string{"truth"} + channels[i].name,
                                         words(channel_of(truth_, channels[i])), {"truth.r", words(red)}));
    add_words("half_width", floats(evidence.half_width, [](double h) { return h; }));
    using study::Patch;
    const Plane<Patch>& patches = evidence.patches;
    add_words("lod", floats(patches, [](const Patch& p) { return p.lod; }));
    add_words("major", floats(patches, [](const Patch& p) { return p.major; }));
    add_words("minor", floats(patches, [](const Patch& p) { return p.minor; }));
    add_words("footprint.centre.u", floats(patches, [](const Patch& p) { return p.centre.x; }));
    add_words("footprint.centre.v", floats(patches, [](const Patch& p) { return p.centre.y; }));
    add_words("footprint.per_x.u", floats(patches, [](const Patch& p) { return p.per_x.x; }));
    add_words("footprint.per_x.v", floats(patches, [](const Patch& p) { return p.per_x.y; }));
    add_words("footprint.per_y.u", floats(patches, [](const Patch& p) { return p.per_y.x; }));
    add_words("footprint.per_y.v", floats(patches, [](const Patch& p) { return p.per_y.y; }));
}

void EvidencePlanes::add_words(const std::string& name, const std::vector<float>& values) {
    blocks_.push_back(
        planes::predicted(name, words(values), std::size_t(size_.width), planes::Prediction::planar));
}

void EvidencePlanes::add_picture(const std::string& label, const Picture& picture) {
    methods_.push_back(label);
    const std::string name = "method." + label, red_name = name + ".r";
    const std::vector<float> red = channel_of(picture, channels[0]);
    for (const Channel& channel : channels) {
        const std::vector<float> values = channel_of(picture, channel), truth = channel_of(truth_, channel);
        const planes::Guess by_truth{std::string{"truth"} + channel.name, words(truth)};
        const bool is_red = &channel == channels.data();
        blocks_.push_back(
            is_red ? planes::beside(red_name, words(red), by_truth)
                   : channel_block(name + channel.name, words(values), {red_name, words(red)}, by_truth));
    }
}

void EvidencePlanes::add_claim(const ClaimedPicture& claimed) {
    claims_[claimed.label] = {{"method", claimed.method}, {"promise", claimed.promise}};
    for (const Channel& channel : channels) {
        const std::vector<float> found = channel_of(claimed.picture, channel);
        const planes::Guess by_picture{"method." + claimed.label + channel.name, words(found)};
        const auto add = [&](const char* end, const Picture& bound) {
            blocks_.push_back(planes::beside("claim." + claimed.label + end + channel.name,
                                             words(channel_of(bound, channel)), by_picture));
        };
        add(".least", claimed.permitted.least);
        add(".greatest", claimed.permitted.greatest);
    }
}

void EvidencePlanes::add_flip(const std::string& label, const Plane<double>& flip) {
    std::string bytes;
    for (const double value : flip.pixels())
        bytes += char(std::isfinite(value) ? std::lround(255 * std::clamp(value, 0.0, 1.0)) : 255);
    blocks_.push_back(planes::bytes_block("method." + label + ".flip", bytes));
}

void EvidencePlanes::add_inspected_row(const std::string& label, int row, const nlohmann::json& inspections) {
    blocks_.push_back(planes::json_block("inspected." + label + "." + std::to_string(row), inspections));
}

planes::Container EvidencePlanes::container(const FilterViewFacts& facts,
                                            const nlohmann::json& inspections) && {
    blocks_.push_back(planes::json_block("inspections", inspections));
    return {{{"kind", "filters"},
             {"width", size_.width},
             {"height", size_.height},
             {"scene", facts.scene},
             {"view", facts.view},
             {"truth", facts.truth},
             {"regions", std::move(regions_)},
             {"methods", std::move(methods_)},
             {"claims", std::move(claims_)},
             {"explain", facts.explain}},
            std::move(blocks_)};
}

planes::Tiers evidence_tiers() { return {page_tiers, evidence_tier_of, script_of}; }

}  // namespace zproof
