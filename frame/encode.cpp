#include "frame/encode.h"

#include <OpenImageIO/filesystem.h>

#include <memory>

#include "frame/frame_error.h"

namespace zproof {
namespace {

constexpr int largest_side = 32768;

[[noreturn]] void refuse(const std::string& place, const std::string& what) {
    throw FrameError(place + ": cannot be encoded: " + what);
}

std::unique_ptr<OIIO::ImageOutput> writer_of(const std::string& format, const std::string& place) {
    std::unique_ptr<OIIO::ImageOutput> writer = OIIO::ImageOutput::create(format);
    if (!writer) refuse(place, OIIO::geterror());
    if (!writer->supports("ioproxy")) refuse(place, "this OpenImageIO writes " + format + " to files only");
    return writer;
}

}  // namespace

void refuse_bad_size(Resolution size, const std::string& place) {
    const auto allowed = [](int side) { return side >= 1 && side <= largest_side; };
    if (allowed(size.width) && allowed(size.height)) return;
    throw FrameError(place + ": size " + std::to_string(size.width) + " x " + std::to_string(size.height) +
                     "; expected 1 to " + std::to_string(largest_side) + " pixels on either side");
}

std::vector<std::byte> encode(const Encoding& encoding, const void* pixels, const std::string& place) {
    refuse_bad_size({encoding.spec.width, encoding.spec.height}, place);
    const std::unique_ptr<OIIO::ImageOutput> writer = writer_of(encoding.format, place);
    OIIO::Filesystem::IOVecOutput memory;
    const std::string name = "memory." + encoding.format;
    const bool written = writer->set_ioproxy(&memory) && writer->open(name, encoding.spec) &&
                         writer->write_image(OIIO::TypeUnknown, pixels) && writer->close();
    if (!written) refuse(place, writer->geterror());
    const std::vector<unsigned char>& buffer = memory.buffer();
    const auto* first = reinterpret_cast<const std::byte*>(buffer.data());
    return {first, first + buffer.size()};
}

}  // namespace zproof
