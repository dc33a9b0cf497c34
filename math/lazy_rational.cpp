#include "math/lazy_rational.h"

#include <optional>

namespace zproof {

/// What a number is the result of, until it was worked out.
struct LazyRational::Term {
    Operation operation;
    LazyRational a, b;
    std::optional<Rational> value{};
    int users = 0;

    const Rational& worked_out() {
        if (value) return *value;
        std::optional<Rational> number_a, number_b;
        const Rational &x = value_of(a, number_a), &y = value_of(b, number_b);
        switch (operation) {
            case Operation::add:
                value = x + y;
                break;
            case Operation::subtract:
                value = x - y;
                break;
            case Operation::multiply:
                value = x * y;
                break;
            case Operation::divide:
                value = x / y;
                break;
        }
        a = b = LazyRational();
        return *value;
    }

    /// What a term has is not copied; what is one number has its place in `number`.
    static const Rational& value_of(const LazyRational& of, std::optional<Rational>& number) {
        return of.term_ ? of.term_->worked_out() : number.emplace(of.range_.low());
    }
};

void intrusive_ptr_add_ref(LazyRational::Term* term) noexcept { ++term->users; }
void intrusive_ptr_release(LazyRational::Term* term) noexcept {
    if (--term->users == 0) delete term;
}

void LazyRational::remember(Operation operation, const LazyRational& a, const LazyRational& b) {
    term_.reset(new Term{operation, a, b});
}

int LazyRational::exact_sign() const { return sign(term_->worked_out()); }

Rational LazyRational::value() const { return term_ ? term_->worked_out() : Rational(range_.low()); }

}  // namespace zproof
