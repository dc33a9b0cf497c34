#include "oracle/convention/frame_bytes.h"

#include <cstring>
#include <span>

#include "frame/frame_error.h"

namespace zproof::oracle {
namespace {

void append(Bytes& bytes, std::span<const std::byte> more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
}

template <class T>
void append(Bytes& bytes, const Plane<T>& plane) {
    const Resolution size = plane.size();
    append(bytes, std::as_bytes(std::span{&size, 1}));
    append(bytes, std::as_bytes(plane.pixels()));
}

class Reader {
  public:
    Reader(const Bytes& bytes, const std::string& name) : left_(bytes), name_(name) {}

    template <class T>
    void take(Plane<T>& plane) {
        Resolution size;
        take(std::as_writable_bytes(std::span{&size, 1}));
        plane = Plane<T>::unwritten(size);
        take(std::as_writable_bytes(plane.pixels()));
    }

  private:
    void take(std::span<std::byte> to) {
        if (left_.size() < to.size()) throw FrameError(name_ + ": cannot be read: its reader ended early");
        if (!to.empty()) std::memcpy(to.data(), left_.data(), to.size());
        left_ = left_.subspan(to.size());
    }

    std::span<const std::byte> left_;
    const std::string& name_;
};

}  // namespace

Bytes bytes_of(const Frame& frame) {
    Bytes bytes;
    append(bytes, frame.primitive);
    append(bytes, frame.camera_depth);
    for (const Plane<float>& plane : frame.attributes.planes) append(bytes, plane);
    return bytes;
}

Frame frame_from(const Bytes& bytes, const std::string& name) {
    Reader reader(bytes, name);
    Frame frame;
    reader.take(frame.primitive);
    reader.take(frame.camera_depth);
    for (Plane<float>& plane : frame.attributes.planes) reader.take(plane);
    return frame;
}

}  // namespace zproof::oracle
