/// Results asked for lately, so that neighbouring pixels need not work them out again.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace zproof {

/// Keeps the latest result per place; a key's place is given by the upper bits of its hash, mixed. What it
/// answers never depends on what it remembers. One thread at a time.
template <class Key, class Value>
class Memory {
  public:
    /// At least this many places.
    explicit Memory(std::size_t places)
        : count_(std::bit_ceil(std::max<std::size_t>(places, 2))),
          shift_(64 - int(std::bit_width(count_ - 1))) {}

    /// The value of the key, made by make() unless remembered. Holds until the next call.
    template <class Make>
    const Value& operator()(const Key& key, const Make& make) {
        if (places_.empty()) places_.resize(count_);  // many are never asked
        Place& place = places_[std::hash<Key>{}(key)*0x9E3779B97F4A7C15u >> shift_];
        if (!place.value || !(place.key == key)) {
            place.value.emplace(make());
            place.key = key;
        }
        return *place.value;
    }

  private:
    struct Place {
        Key key{};
        std::optional<Value> value;
    };
    std::size_t count_;
    std::vector<Place> places_;
    int shift_;
};

}  // namespace zproof
