/// What is known of some triangles, each made when it is first asked for. Never forgets, so that what it
/// hands out stays where it is.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

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
        ++count_;
        return made;
    }

    std::size_t count() const { return count_; }

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
        if (blocks_.empty() || blocks_.back().size() == block_size)
            blocks_.emplace_back().reserve(block_size);
        return blocks_.back().emplace_back(Made<Make>{make});
    }

    void grow() {
        std::vector<Slot> old(slots_.empty() ? 64 : 2 * slots_.size());
        old.swap(slots_);
        for (const Slot& slot : old)
            if (slot.value) slot_of(slot.triangle) = slot;
    }

    static constexpr std::size_t block_size = 32;
    std::vector<Slot> slots_;
    std::size_t count_ = 0;
    std::vector<std::vector<Value>> blocks_;
};

}  // namespace zproof
