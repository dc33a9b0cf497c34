#pragma once

#include <functional>

namespace zproof {

/// Does the work in an arena of so many threads, and lets no library take more.
void on_threads(int count, const std::function<void()>& work);

}  // namespace zproof
