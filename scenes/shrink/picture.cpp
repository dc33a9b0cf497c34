#include <algorithm>

#include "scenes/shrink/attempts.h"

namespace zproof::shrinking {
namespace {

/// Columns and rows that go on each side.
struct Margins {
    int left = 0, right = 0, top = 0, bottom = 0;
};

/// The view of the pixels that are left: their rays stay, to the rounding of the window.
View cropped(const View& view, const Margins& off) {
    View rest = view;
    rest.width -= off.left + off.right;
    rest.height -= off.top + off.bottom;
    const Window& w = view.camera.window;
    const double across = (w.right - w.left) / view.width, down = (w.top - w.bottom) / view.height;
    rest.camera.window = {w.left + across * off.left, w.right - across * off.right,
                          w.bottom + down * off.bottom, w.top - down * off.top};
    return rest;
}

bool keep_cropped(Attempts& attempts, const Margins& off) {
    return attempts.keep({attempts.least().scene, cropped(attempts.least().view, off)});
}

/// Takes as much as can be taken on one side, first half of what is there.
void crop_side(Attempts& attempts, int View::*size, int Margins::*side) {
    for (int step = attempts.least().view.*size / 2; step >= 1 && !attempts.are_over(); step /= 2)
        while (attempts.least().view.*size > step) {
            Margins off;
            off.*side = step;
            if (!keep_cropped(attempts, off)) break;
        }
}

}  // namespace

void crop_picture(Attempts& attempts) {
    crop_side(attempts, &View::width, &Margins::left);
    crop_side(attempts, &View::width, &Margins::right);
    crop_side(attempts, &View::height, &Margins::top);
    crop_side(attempts, &View::height, &Margins::bottom);
}

}  // namespace zproof::shrinking
