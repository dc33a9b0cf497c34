// Stand-in for TBB; see run_threads.h.
#pragma once

#include <atomic>
#include <concepts>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <utility>

namespace tbb {

namespace stand_in {

/// This thread's elements, by the number of what they belong to. Numbers are never used twice.
inline thread_local std::unordered_map<std::uint64_t, void*> elements_of_thread;

inline std::uint64_t unused_number() {
    static std::atomic<std::uint64_t> next = 0;
    return next.fetch_add(1, std::memory_order_relaxed);
}

}  // namespace stand_in

/// A list of elements, each made by the thread that it belongs to. Relaxed atomics do: other threads look at
/// them only after the loop, so that making them orders no bodies.
template <typename Element>
class enumerable_thread_specific {
    struct Node {
        Element element;
        Node* next = nullptr;
    };

  public:
    class iterator {
      public:
        explicit iterator(Node* node) : node_(node) {}
        Element& operator*() const { return node_->element; }
        iterator& operator++() {
            node_ = node_->next;
            return *this;
        }
        bool operator==(const iterator&) const = default;

      private:
        Node* node_;
    };

    enumerable_thread_specific() : enumerable_thread_specific([] { return Element(); }) {}
    template <std::invocable Make>
    explicit enumerable_thread_specific(Make make) : make_(std::move(make)) {}
    enumerable_thread_specific(const enumerable_thread_specific&) = delete;
    enumerable_thread_specific& operator=(const enumerable_thread_specific&) = delete;
    ~enumerable_thread_specific() {
        for (Node* node = head_.load(std::memory_order_relaxed); node != nullptr;)
            delete std::exchange(node, node->next);
    }

    Element& local() {
        void*& mine = stand_in::elements_of_thread[number_];
        if (mine == nullptr) mine = &added()->element;
        return *static_cast<Element*>(mine);
    }

    iterator begin() { return iterator(head_.load(std::memory_order_relaxed)); }
    iterator end() { return iterator(nullptr); }

  private:
    Node* added() {
        Node* const node = new Node{make_()};
        node->next = head_.load(std::memory_order_relaxed);
        while (!head_.compare_exchange_weak(node->next, node, std::memory_order_relaxed)) {
        }
        return node;
    }

    std::function<Element()> make_;
    const std::uint64_t number_ = stand_in::unused_number();
    std::atomic<Node*> head_ = nullptr;
};

}  // namespace tbb
