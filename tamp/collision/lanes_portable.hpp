// Eight floats at a time, for any processor. Included by one translation unit only.
#pragma once

namespace praxis::tamp::kernel {
namespace {

struct Lanes {
    float v[8];

    Lanes() = default;
    Lanes(float x) {  // NOLINT: a number stands for eight of it
        for (float& lane : v) lane = x;
    }
    static Lanes load(const float* from) {
        Lanes lanes;
        for (int i = 0; i < 8; ++i) lanes.v[i] = from[i];
        return lanes;
    }
    void store(float* to) const {
        for (int i = 0; i < 8; ++i) to[i] = v[i];
    }
    /// 0, 1, ... 7
    static Lanes ascending() {
        Lanes lanes;
        for (int i = 0; i < 8; ++i) lanes.v[i] = static_cast<float>(i);
        return lanes;
    }
    /// For every lane the number of `table` at x + width * (y + height * z).
    static Lanes gather(const float* table, const Lanes& x, const Lanes& y, const Lanes& z, int width,
                        int height) {
        Lanes lanes;
        for (int i = 0; i < 8; ++i) {
            const int row = static_cast<int>(y.v[i]) + height * static_cast<int>(z.v[i]);
            lanes.v[i] = table[static_cast<int>(x.v[i]) + width * row];
        }
        return lanes;
    }
};

template <class F>
inline Lanes each(const Lanes& a, const Lanes& b, F f) {
    Lanes c;
    for (int i = 0; i < 8; ++i) c.v[i] = f(a.v[i], b.v[i]);
    return c;
}

inline Lanes operator+(const Lanes& a, const Lanes& b) {
    return each(a, b, [](float x, float y) { return x + y; });
}
inline Lanes operator-(const Lanes& a, const Lanes& b) {
    return each(a, b, [](float x, float y) { return x - y; });
}
inline Lanes operator*(const Lanes& a, const Lanes& b) {
    return each(a, b, [](float x, float y) { return x * y; });
}
inline Lanes operator/(const Lanes& a, const Lanes& b) {
    return each(a, b, [](float x, float y) { return x / y; });
}
/// a * b + c
inline Lanes multiply_add(const Lanes& a, const Lanes& b, const Lanes& c) {
    return a * b + c;
}
/// c - a * b
inline Lanes multiply_subtract(const Lanes& a, const Lanes& b, const Lanes& c) {
    return c - a * b;
}
inline Lanes maximum(const Lanes& a, const Lanes& b) {
    return each(a, b, [](float x, float y) { return x > y ? x : y; });
}
inline Lanes minimum(const Lanes& a, const Lanes& b) {
    return each(a, b, [](float x, float y) { return x < y ? x : y; });
}
/// The least of the eight numbers, in every lane.
inline Lanes lowest(const Lanes& a) {
    float least = a.v[0];
    for (float lane : a.v) least = lane < least ? lane : least;
    return least;
}
/// The greatest of the eight numbers, in every lane.
inline Lanes highest(const Lanes& a) {
    float greatest = a.v[0];
    for (float lane : a.v) greatest = lane > greatest ? lane : greatest;
    return greatest;
}
inline Lanes absolute(const Lanes& a) {
    return each(a, a, [](float x, float) { return x < 0 ? -x : x; });
}
inline Lanes root(const Lanes& a) {
    return each(a, a, [](float x, float) { return __builtin_sqrtf(x); });
}
/// To the nearest integer.
inline Lanes rounded(const Lanes& a) {
    return each(a, a, [](float x, float) {
        return static_cast<float>(static_cast<int>(x + (x < 0 ? -0.5F : 0.5F)));
    });
}
/// Bit i: not a > b in lane i (so a number that is none counts as collision).
inline unsigned not_greater(const Lanes& a, const Lanes& b) {
    unsigned mask = 0;
    for (int i = 0; i < 8; ++i) mask |= (a.v[i] > b.v[i] ? 0U : 1U) << i;
    return mask;
}
/// In every lane: x where a < b, else y.
inline Lanes where_less(const Lanes& a, const Lanes& b, const Lanes& x, const Lanes& y) {
    Lanes c;
    for (int i = 0; i < 8; ++i) c.v[i] = a.v[i] < b.v[i] ? x.v[i] : y.v[i];
    return c;
}
/// In every lane: where quadrant (an integer) is odd `odd`, else `even`; negated where `quadrant + turn` has
/// bit 1.
inline Lanes by_quadrant(const Lanes& quadrant, int turn, const Lanes& even, const Lanes& odd) {
    Lanes c;
    for (int i = 0; i < 8; ++i) {
        const int q = static_cast<int>(quadrant.v[i]);
        const float value = (q & 1) != 0 ? odd.v[i] : even.v[i];
        c.v[i] = ((q + turn) & 2) != 0 ? -value : value;
    }
    return c;
}

}  // namespace
}  // namespace praxis::tamp::kernel
