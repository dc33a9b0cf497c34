/// Bin entries, one after the other.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace zproof::rasterizer {

/// A list in lent memory for as long as that has room, and then in its own, which it keeps.
class BinEntries {
  public:
    BinEntries() = default;
    BinEntries(BinEntries&&) = default;  // a copy would look into this one's memory
    BinEntries& operator=(BinEntries&&) = default;

    /// Begins anew. What is lent must outlive the list, or its next beginning.
    void begin_in(std::span<std::uint32_t> lent) {
        room_ = lent;
        size_ = 0;
    }

    void push_back(std::uint32_t entry) { *add(1) = entry; }
    /// The place where `count` more entries are to be written.
    std::uint32_t* add(std::size_t count) {
        if (room_.size() - size_ < count) move_to_own(size_ + count);
        return &room_[std::exchange(size_, size_ + count)];
    }

    std::size_t size() const { return size_; }
    const std::uint32_t* data() const { return room_.data(); }

  private:
    void move_to_own(std::size_t needed) {
        const bool is_there = room_.data() == own_.data();
        own_.resize(std::max({own_.size(), 2 * room_.size(), needed}));
        if (!is_there) std::copy_n(room_.begin(), size_, own_.begin());
        room_ = own_;
    }

    std::span<std::uint32_t> room_;
    std::size_t size_ = 0;
    std::vector<std::uint32_t> own_;
};

}  // namespace zproof::rasterizer
