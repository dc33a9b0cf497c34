#include "oracle/povray/code.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "frame/number_text.h"
#include "oracle/oracle_error.h"
#include "oracle/povray/text.h"

namespace zproof::oracle {
namespace {

constexpr int channel_bits = 16, all_bits = 3 * channel_bits;
constexpr double brightest = 65535;  ///< a channel's value for 1.0

}  // namespace

PovrayCode::PovrayCode(std::size_t triangle_count, DepthSteps steps, double low, double high)
    : id_bits_(std::max(channel_bits, int(std::bit_width(triangle_count)))),
      depth_bits_(all_bits - id_bits_),
      triangle_count_(triangle_count),
      steps_(steps),
      low_(low),
      high_(high),
      span_(steps == DepthSteps::logarithmic ? std::log(high / low) : high - low),
      highest_(std::ldexp(1.0, depth_bits_) - 1) {
    const bool fine_enough =
        steps == DepthSteps::logarithmic ? 0.5 * span_ / highest_ <= 0x1p-24 : depth_bits_ >= 28;
    if (!fine_enough)
        throw OracleError("POV-Ray: the ids of " + std::to_string(triangle_count) +
                          " triangles leave too few bits for depths from " + shortest(low) + " to " +
                          shortest(high) + "; split the scene or bring near and far together");
}

PovrayCode::Pixel PovrayCode::decoded(const Channels& channels) const {
    const std::uint64_t code = std::uint64_t{channels[0]} | std::uint64_t{channels[1]} << channel_bits |
                               std::uint64_t{channels[2]} << (2 * channel_bits);
    if (code == 0) return {PrimitiveId::none, background_depth};
    const std::uint64_t number = code & ((std::uint64_t{1} << id_bits_) - 1);
    if (number == 0 || number > triangle_count_)
        throw OracleError("POV-Ray: the picture holds the code " + std::to_string(code) +
                          ", and there is no triangle " + std::to_string(number) + " of " +
                          std::to_string(triangle_count_) + "; expected an unfiltered picture, gamma 1");
    const double share = double(code >> id_bits_) / highest_;
    const double depth =
        steps_ == DepthSteps::logarithmic ? low_ * std::exp(share * span_) : low_ + share * span_;
    return {PrimitiveId{std::uint32_t(number - 1)}, depth};
}

std::array<double, 2> PovrayCode::colour_of(PrimitiveId primitive) const {
    const std::uint64_t number = std::uint64_t{static_cast<std::uint32_t>(primitive)} + 1;
    return {double(number & 0xFFFF) / brightest, double(number >> channel_bits) / brightest};
}

std::string PovrayCode::depth_pigments(const std::string& depth) const {
    const int shift = id_bits_ - channel_bits;  // of the depth within green
    const std::string lower_steps = shortest(std::ldexp(1.0, channel_bits - shift));
    const std::string share = steps_ == DepthSteps::logarithmic
                                  ? "ln((" + depth + ")/" + shortest(low_) + ")"
                                  : "((" + depth + ")-(" + shortest(low_) + "))";
    return "#declare Step=function{floor(0.5+" + share + "*" + shortest(highest_ / span_) + ")}\n" +
           "#declare Upper_step=function{floor(Step(x,y,z)/" + lower_steps + ")}\n" +
           "#declare Lower=pigment{function{(Step(x,y,z)-" + lower_steps + "*Upper_step(x,y,z))*" +
           shortest(std::ldexp(1.0, shift)) + "/65535}color_map{[0 rgb 0][1 rgb<0,4,0>]}}\n" +
           "#declare Upper=pigment{function{Upper_step(x,y,z)/65535}color_map{[0 rgb 0][1 rgb<0,0,4>]}}\n";
}

}  // namespace zproof::oracle
