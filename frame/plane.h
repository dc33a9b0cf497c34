/// A rectangle of per-pixel values: one AOV, or one map.
#pragma once

#include <cassert>
#include <cstddef>
#include <new>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "math/bulk.h"

namespace zproof {

/// Size of an image in pixels. Valid: 1 to 32768 on either side.
struct Resolution {
    int width = 0, height = 0;

    std::size_t pixel_count() const { return std::size_t(width) * std::size_t(height); }
    bool operator==(const Resolution&) const = default;
};

inline constexpr std::size_t cache_line_bytes = 64;

/// Begins a cache line, and touches no memory before it is asked to; many values stand in huge pages. One
/// that is lent memory gives that out, once, with the values that stand there; copies of a plane have memory
/// of their own.
template <class T>
struct PlaneAllocator {
    using value_type = T;
    using propagate_on_container_move_assignment = std::true_type;
    using propagate_on_container_swap = std::true_type;
    using is_always_equal = std::false_type;

    PlaneAllocator() = default;
    explicit PlaneAllocator(T* lent_values) : lent(lent_values) {}
    template <class U>
    constexpr PlaneAllocator(const PlaneAllocator<U>&) noexcept {}

    T* allocate(std::size_t count) {
        return lent ? lent : static_cast<T*>(allocate_bulk(count * sizeof(T), cache_line_bytes));
    }
    void deallocate(T* values, std::size_t count) noexcept {
        if (!lent) free_bulk(values, count * sizeof(T));
    }
    PlaneAllocator select_on_container_copy_construction() const { return {}; }
    bool operator==(const PlaneAllocator&) const = default;

    template <class U, class... Arguments>
    void construct(U* at, Arguments&&... arguments) {
        ::new (static_cast<void*>(at)) U(std::forward<Arguments>(arguments)...);
    }
    template <class U>
    void construct(U* at) noexcept {
        if (!lent) ::new (static_cast<void*>(at)) U;
    }

    T* lent = nullptr;
};

/// Row-major values, row 0 at the top; at(x, y) is pixel (x, y) of raster space. The first begins a cache
/// line, unless the memory is lent.
template <class T>
class Plane {
  public:
    Plane() = default;
    explicit Plane(Resolution size, T fill = T{}) : size_(size), values_(size.pixel_count(), fill) {}

    /// Numbers and the like have no value yet: each is to be written before it is read.
    static Plane unwritten(Resolution size) {
        Plane plane;
        plane.size_ = size;
        plane.values_.resize(size.pixel_count());
        return plane;
    }

    /// A plane of somebody else's memory, without a copy: size.pixel_count() values that must outlive it.
    /// They are only read where the plane is const.
    static Plane lent(Resolution size, const T* values) {
        Plane plane;
        plane.size_ = size;
        plane.values_ = Values(PlaneAllocator<T>{const_cast<T*>(values)});
        plane.values_.resize(size.pixel_count());
        return plane;
    }

    Resolution size() const { return size_; }
    T& at(int x, int y) { return values_[index(x, y)]; }
    const T& at(int x, int y) const { return values_[index(x, y)]; }
    std::span<T> row(int y) { return pixels().subspan(index(0, y), std::size_t(size_.width)); }
    std::span<const T> row(int y) const { return pixels().subspan(index(0, y), std::size_t(size_.width)); }
    std::span<T> pixels() { return values_; }
    std::span<const T> pixels() const { return values_; }

  private:
    std::size_t index(int x, int y) const {
        assert(x >= 0 && x < size_.width && y >= 0 && y < size_.height);
        return std::size_t(y) * std::size_t(size_.width) + std::size_t(x);
    }

    using Values = std::vector<T, PlaneAllocator<T>>;

    Resolution size_;
    Values values_;
};

}  // namespace zproof
