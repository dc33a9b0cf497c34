/// Exact rational numbers that are worked out only where a sign asks for more than double precision (lazy
/// evaluation: Pion and Fabri, Science of Computer Programming 76, 2011).
#pragma once

#include <boost/smart_ptr/intrusive_ptr.hpp>

#include "math/interval.h"
#include "math/rational.h"

namespace zproof {

/// An interval, and how the number in it came to be. For one thread at a time.
class LazyRational {
  public:
    LazyRational(double exact = 0) : range_(exact) {}

    friend LazyRational operator-(const LazyRational& a) { return {-a.range_, Operation::subtract, {}, a}; }
    friend LazyRational operator+(const LazyRational& a, const LazyRational& b) {
        return {a.range_ + b.range_, Operation::add, a, b};
    }
    friend LazyRational operator-(const LazyRational& a, const LazyRational& b) {
        return {a.range_ - b.range_, Operation::subtract, a, b};
    }
    friend LazyRational operator*(const LazyRational& a, const LazyRational& b) {
        return {a.range_ * b.range_, Operation::multiply, a, b};
    }
    /// b is not 0.
    friend LazyRational operator/(const LazyRational& a, const LazyRational& b) {
        return {quotient(a.range_, b.range_), Operation::divide, a, b};
    }

    /// -1, 0 or +1; never undecided.
    friend int sign(const LazyRational& a) { return a.is_decided() ? sign(a.range_) : a.exact_sign(); }
    friend bool is_certainly_zero(const LazyRational& a) { return sign(a) == 0; }
    friend LazyRational magnitude(const LazyRational& a) { return sign(a) < 0 ? -a : a; }

    /// The number itself.
    Rational value() const;

  private:
    enum class Operation { add, subtract, multiply, divide };
    struct Term;
    friend void intrusive_ptr_add_ref(Term* term) noexcept;
    friend void intrusive_ptr_release(Term* term) noexcept;

    /// A range that is one number says all.
    LazyRational(const Interval& range, Operation operation, const LazyRational& a, const LazyRational& b)
        : range_(range) {
        if (!is_number()) remember(operation, a, b);
    }
    void remember(Operation operation, const LazyRational& a, const LazyRational& b);

    static Interval quotient(const Interval& a, const Interval& b) {
        const bool may_be_0 = !(b.low() > 0) && !(b.high() < 0);
        return may_be_0 ? Interval(-HUGE_VAL, HUGE_VAL) : a / b;
    }
    bool is_number() const { return range_.low() == range_.high(); }
    int exact_sign() const;
    bool is_decided() const { return is_number() || range_.low() > 0 || range_.high() < 0; }

    Interval range_;
    boost::intrusive_ptr<Term> term_;  ///< none where the range is one number
};

}  // namespace zproof
