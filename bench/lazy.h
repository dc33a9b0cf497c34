/// Made when first asked for, shared by whoever copies it: most runs need a few of the scenes only.
#pragma once

#include <functional>
#include <memory>
#include <optional>

namespace zproof::bench {

template <class T>
class Lazy {
  public:
    explicit Lazy(std::function<T()> make) : state_(std::make_shared<State>(std::move(make))) {}

    T& operator*() const {
        if (!state_->value) state_->value.emplace(state_->make());
        return *state_->value;
    }
    T* operator->() const { return &**this; }

  private:
    struct State {
        explicit State(std::function<T()> m) : make(std::move(m)) {}
        std::function<T()> make;
        std::optional<T> value;
    };
    std::shared_ptr<State> state_;
};

}  // namespace zproof::bench
