// Where pixels that follow each other stand.

/// 0, 1, 2 and so on.
struct Counted {
    double values[width];
};
constexpr Counted counted = [] {
    Counted all{};
    for (int i = 0; i < width; ++i) all.values[i] = i;
    return all;
}();

/// The x of each of as many pixels.
struct Columns {
    Doubles first;

    explicit Columns(int x) : first(all(double(x))) {}

    Doubles from(int i) const { return first + loaded(counted.values + i); }
};
