#include "image_io/id_decoder.h"

#include <cmath>
#include <limits>
#include <utility>

#include "frame/frame_error.h"
#include "frame/number_text.h"

namespace zproof::image_io {
namespace {

std::int64_t largest_number(IdCoding coding, Sample sample) {
    if (coding == IdCoding::rgb || coding == IdCoding::bgr) return 0xFF'FFFF;
    switch (sample) {
        case Sample::uint8:
            return std::numeric_limits<std::uint8_t>::max();
        case Sample::uint16:
            return std::numeric_limits<std::uint16_t>::max();
        case Sample::int32:
            return std::numeric_limits<std::int32_t>::max();
        case Sample::int64:
            return std::numeric_limits<std::int64_t>::max();
        default:
            return std::numeric_limits<std::uint32_t>::max();
    }
}

std::optional<std::int64_t> background_number(const Convention& convention, Sample sample) {
    if (convention.id_background || convention.background_by == BackgroundBy::depth)
        return convention.id_background;
    return largest_number(convention.id_coding, sample);
}

/// 2^p where the type has p binary digits.
double first_inexact(Sample sample) {
    if (sample == Sample::half) return 0x1p11;
    return sample == Sample::float32 ? 0x1p24 : 0x1p53;
}

}  // namespace

IdDecoder::IdDecoder(const Convention& convention, Sample sample, std::string channel)
    : base_(convention.id_base),
      background_(background_number(convention, sample)),
      exact_below_(first_inexact(sample)),
      channel_(std::move(channel)) {}

PrimitiveId IdDecoder::id_of(std::int64_t number, SamplePlace place) const {
    if (number == background_) return PrimitiveId::none;
    constexpr std::int64_t largest_id = std::int64_t{std::uint32_t(PrimitiveId::none)} - 1;
    if (number < base_ || number > base_ + largest_id)
        refuse(std::to_string(number), place,
               "a triangle's number from " + std::to_string(base_) + " on" +
                   (background_ ? ", or " + std::to_string(*background_) + " for background" : "") +
                   "; id_base and id_background of --convention say which they are");
    return PrimitiveId{std::uint32_t(number - base_)};
}

PrimitiveId IdDecoder::id_of_real(double number, SamplePlace place) const {
    if (background_ && number == double(*background_)) return PrimitiveId::none;
    if (!(std::abs(number) < exact_below_) || number != std::trunc(number))
        refuse(with_digits(number, 17), place,
               "a whole number below " + std::to_string(std::int64_t(exact_below_)) +
                   ", up to which this type of float has each; write ids as uint32");
    return id_of(std::int64_t(number), place);
}

void IdDecoder::refuse(const std::string& number, SamplePlace place, const std::string& expected) const {
    throw FrameError(channel_ + " has " + number + " in column " + std::to_string(place.x) + ", row " +
                     std::to_string(place.y) + "; expected " + expected);
}

}  // namespace zproof::image_io
