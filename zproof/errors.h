/// The rooms' errors as those of the public interface.
#pragma once

#include "frame/frame_error.h"
#include "scenes/scene_error.h"
#include "zproof/zproof.h"

namespace zproof::api {

/// Does the work; what it says of a scene, a view or a frame that cannot be used becomes an InputError.
template <class Work>
auto told_as_input_error(const Work& work) {
    try {
        return work();
    } catch (const SceneError& e) {
        throw InputError{e.what()};
    } catch (const FrameError& e) {
        throw InputError{e.what()};
    }
}

}  // namespace zproof::api
