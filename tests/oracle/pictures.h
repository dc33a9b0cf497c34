/// Tiny scenes and views, and frames as text.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "frame/frame.h"
#include "scenes/view.h"

namespace zproof::oracle {

using Corners = std::vector<glm::vec3>;

/// Ids as one character per pixel: '.' = background.
std::string picture(const Frame& frame);

/// One unit per pixel on the plane at depth 1; x runs right, y up, from the image's middle.
View unit_pixels(int width, int height);

/// A triangle at this depth that covers everything unit_pixels sees of images up to 16 pixels wide.
Corners wall(float depth);

Corners together(std::initializer_list<Corners> parts);

bool same_bits(const Frame& a, const Frame& b);

}  // namespace zproof::oracle
