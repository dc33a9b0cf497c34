#include "filters/commands/evidence_files.h"

#include <array>

#include "filters/report/folder.h"
#include "frame/joined.h"

namespace zproof {

namespace {

using study::Patch;

template <class Value>
Plane<float> plane_of(Resolution size, const Value& value) {
    Plane<float> plane(size);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) plane.at(x, y) = float(value(x, y));
    return plane;
}

struct NamedFloats {
    std::string name;
    Plane<float> values;
};

struct PatchChannel {
    const char* name;
    double (*value)(const Patch&);
};

constexpr std::array<PatchChannel, 10> patch_channels{
    {{"major", [](const Patch& p) { return p.major; }},
     {"minor", [](const Patch& p) { return p.minor; }},
     {"angle_degrees", [](const Patch& p) { return p.angle_degrees; }},
     {"lod", [](const Patch& p) { return p.lod; }},
     {"u", [](const Patch& p) { return p.centre.x; }},
     {"v", [](const Patch& p) { return p.centre.y; }},
     {"du_dx", [](const Patch& p) { return p.per_x.x; }},
     {"dv_dx", [](const Patch& p) { return p.per_x.y; }},
     {"du_dy", [](const Patch& p) { return p.per_y.x; }},
     {"dv_dy", [](const Patch& p) { return p.per_y.y; }}}};

}  // namespace

void EvidenceFiles::begin(const study::ViewEvidence& known) {
    truth_ = known.truth;
    const Resolution size = truth_.size();
    std::vector<Plane<float>> reals{plane_of(size, [&](int x, int y) { return known.half_width.at(x, y); })};
    std::vector<std::string> names{"half_width"};
    for (const PatchChannel& channel : patch_channels) {
        reals.push_back(plane_of(size, [&](int x, int y) { return channel.value(known.patches.at(x, y)); }));
        names.emplace_back(channel.name);
    }
    const Plane<std::uint32_t> regions = study::region_bits(known.regions);
    std::vector<NamedPlane> planes;
    for (std::size_t i = 0; i < reals.size(); ++i) planes.push_back({names[i], &reals[i]});
    planes.push_back({"region", &regions});
    FileFacts facts = facts_;
    facts.emplace_back("zproof:regions", joined(known.regions, ", ", &study::Region::name));
    write_planes(folder_ / "surface.exr", planes, facts);
}

void EvidenceFiles::show(const std::string&, const Picture& picture) {
    error_ = picture;
    for (std::size_t i = 0; i < truth_.pixels().size(); ++i) {
        const LinearRgb &c = picture.pixels()[i], &t = truth_.pixels()[i];
        error_.pixels()[i] = {c.r - t.r, c.g - t.g, c.b - t.b};
    }
}

void EvidenceFiles::claim(const ClaimedPicture& claimed) const {
    const auto& [least, greatest] = claimed.permitted;
    const Resolution size = least.size();
    std::vector<NamedFloats> floats;
    for (const auto& [bound, name] : {std::pair{&least, "least."}, std::pair{&greatest, "greatest."}})
        for (const auto& [part, letter] :
             {std::pair{&LinearRgb::r, "R"}, std::pair{&LinearRgb::g, "G"}, std::pair{&LinearRgb::b, "B"}})
            floats.push_back({std::string{name} + letter,
                              plane_of(size, [&](int x, int y) { return bound->at(x, y).*part; })});
    floats.push_back({"outside", plane_of(size, [&](int x, int y) {
                          return distance_outside(claimed.picture.at(x, y), least.at(x, y),
                                                  greatest.at(x, y));
                      })});
    std::vector<NamedPlane> planes;
    for (const NamedFloats& one : floats) planes.push_back({one.name, &one.values});
    FileFacts facts = facts_;
    facts.emplace_back("zproof:claim", claimed.method);
    facts.emplace_back("zproof:promise", claimed.promise);
    write_planes(folder_ / (file_stem(claimed.label) + "-permitted.exr"), planes, facts);
}

void EvidenceFiles::map(const std::string& label, const PictureMetric& metric, const Plane<double>& map) {
    if (metric.name != "flip") return;
    const Resolution size = map.size();
    const auto of_error = [&](float LinearRgb::*part) {
        return plane_of(size, [&](int x, int y) { return error_.at(x, y).*part; });
    };
    const Plane<float> r = of_error(&LinearRgb::r), g = of_error(&LinearRgb::g), b = of_error(&LinearRgb::b),
                       flip = plane_of(size, [&](int x, int y) { return map.at(x, y); });
    const std::array<NamedPlane, 4> planes{{{"R", &r}, {"G", &g}, {"B", &b}, {"flip", &flip}}};
    write_planes(folder_ / (file_stem(label) + "-error.exr"), planes, facts_);
}

}  // namespace zproof
