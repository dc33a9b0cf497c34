/// Results asked for lately, so that neighbouring pixels need not work them out again.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace zproof {

/// Keeps the latest result per place; a key's place is its hash modulo their number. What it answers never
/// depends on what it remembers. One thread at a time.
template <class Key, class Value>
class Memory {
  public:
    explicit Memory(std::size_t places) : places_(places) {}

    /// The value of the key, made by make() unless remembered. Holds until the next call.
    template <class Make>
    const Value& operator()(const Key& key, const Make& make) {
        Place& place = places_[std::hash<Key>{}(key) % places_.size()];
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
    std::vector<Place> places_;
};

}  // namespace zproof
