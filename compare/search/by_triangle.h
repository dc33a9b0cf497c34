/// What is known of some triangles, each made when it is first asked for. What it hands out stays where it
/// is until it forgets.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "math/bulk.h"

namespace zproof {

/// A table with open addressing; values stand in blocks. One thread at a time.
template <class Value>
class ByTriangle {
  public:
    ByTriangle() = default;
    ByTriangle(ByTriangle&&) noexcept = default;  // a copy's slots would point at this one's values
    ByTriangle& operator=(ByTriangle&&) noexcept = default;

    /// make() gives the value where the triangle was not asked for yet. It must not ask this table.
    template <class Make>
    const Value& operator()(std::uint32_t triangle, const Make& make) {
        if (2 * (count_ + 1) > slots_.size()) grow();
        Slot& slot = slot_of(triangle);
        if (slot.value) return *slot.value;
        const Value& made = add(make);
        slot = {triangle, &made};
        return made;
    }

    std::size_t count() const { return count_; }

    /// All, but for the room that it took.
    void forget() {
        std::ranges::fill(slots_, Slot{});
        for (Bulk<Value>& block : blocks_) block.clear();
        count_ = filling_ = 0;
    }

  private:
    struct Slot {
        std::uint32_t triangle = 0;
        const Value* value = nullptr;
    };

    /// Its own, or the empty one where it belongs.
    Slot& slot_of(std::uint32_t triangle) {
        const std::size_t mask = slots_.size() - 1;
        std::size_t at = (triangle * 0x9E3779B97F4A7C15u >> 32) & mask;
        while (slots_[at].value && slots_[at].triangle != triangle) at = (at + 1) & mask;
        return slots_[at];
    }

    /// Becomes what make() gives, so that a block's place is where that is made.
    template <class Make>
    struct Made {
        const Make& make;
        operator Value() const { return make(); }
    };
    template <class Make>
    const Value& add(const Make& make) {
        ++count_;
        return block_with_room().emplace_back(Made<Make>{make});
    }
    Bulk<Value>& block_with_room() {
        const auto is_full = [](const Bulk<Value>& block) { return block.size() == block.capacity(); };
        if (filling_ < blocks_.size() && is_full(blocks_[filling_])) ++filling_;
        if (filling_ == blocks_.size())
            blocks_.emplace_back().reserve(std::clamp(count_, least_in_block, most_in_block));
        return blocks_[filling_];
    }

    void grow() {
        Bulk<Slot> old(slots_.empty() ? 64 : 2 * slots_.size(), Slot{});
        old.swap(slots_);
        for (const Slot& slot : old)
            if (slot.value) slot_of(slot.triangle) = slot;
    }

    /// A block of the most takes so much memory that it is kept from one verdict to the next.
    static constexpr std::size_t least_in_block = 32, most_in_block = 256;
    Bulk<Slot> slots_;
    std::size_t count_ = 0;
    std::vector<Bulk<Value>> blocks_;
    std::size_t filling_ = 0;  ///< of blocks_: those before it are full, those after it empty
};

}  // namespace zproof
