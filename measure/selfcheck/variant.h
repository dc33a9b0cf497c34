/// A picture told to a renderer in another way. Who is right draws it again.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "frame/frame.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::measure {

/// A picture of the variant's scene, and what the original's frame says of it.
struct VariantPicture {
    View view;                                    ///< to be rendered
    View judged_view;                             ///< by which the frame is judged
    std::function<Frame(const Frame&)> judged;    ///< what was rendered, as pixels of judged_view
    std::function<Frame(const Frame&)> expected;  ///< the original's frame, as pixels of judged_view
};

struct Variant {
    enum class Numbers {
        same,     ///< both pictures show the same real numbers, in other words
        rounded,  ///< corners or windows were rounded anew
    };
    std::string name;      ///< "reversed order"
    std::string sentence;  ///< what was done
    Numbers numbers;
    Scene (*scene)(const Scene& original);
    /// Empty where the view has no such pictures (too few pixels, or more than 16384 in a row).
    std::vector<VariantPicture> (*pictures)(const Scene& original, const View& view);
};

/// All there are, in the order in which they are tried.
std::span<const Variant> variants();

}  // namespace zproof::measure
