/// What is known along a tile's rows.
#pragma once

#include <memory>
#include <optional>

#include "compare/tile_mask.h"

namespace zproof {

/// A value for each row, made when it is first asked for; it stays where it is.
template <class Value>
class ByRow {
  public:
    template <class Make>
    const Value& operator()(int y, const Make& make) {
        if (!rows_) rows_ = std::make_unique<Rows>();
        std::optional<Value>& row = (*rows_)[std::size_t(y)];
        if (!row) row.emplace(make());
        return *row;
    }

  private:
    using Rows = std::array<std::optional<Value>, TileMask::rows>;
    std::unique_ptr<Rows> rows_;
};

}  // namespace zproof
