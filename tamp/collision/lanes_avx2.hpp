// Eight floats at a time, for processors with AVX2 and FMA. Included by one translation unit only.
#pragma once

#include <immintrin.h>

namespace praxis::tamp::kernel {
namespace {

struct Lanes {
    __m256 v;

    Lanes() = default;
    Lanes(__m256 x) : v(x) {}                 // NOLINT
    Lanes(float x) : v(_mm256_set1_ps(x)) {}  // NOLINT: a number stands for eight of it
    static Lanes load(const float* from) { return _mm256_load_ps(from); }
    void store(float* to) const { _mm256_store_ps(to, v); }
    /// 0, 1, ... 7
    static Lanes ascending() { return _mm256_setr_ps(0, 1, 2, 3, 4, 5, 6, 7); }
    /// For every lane the number of `table` at x + width * (y + height * z).
    static Lanes gather(const float* table, const Lanes& x, const Lanes& y, const Lanes& z, int width,
                        int height) {
        const __m256i slabs = _mm256_mullo_epi32(_mm256_cvttps_epi32(z.v), _mm256_set1_epi32(height));
        const __m256i rows = _mm256_add_epi32(_mm256_cvttps_epi32(y.v), slabs);
        const __m256i before = _mm256_mullo_epi32(rows, _mm256_set1_epi32(width));
        return _mm256_i32gather_ps(table, _mm256_add_epi32(_mm256_cvttps_epi32(x.v), before), 4);
    }
};

inline Lanes operator+(const Lanes& a, const Lanes& b) {
    return _mm256_add_ps(a.v, b.v);
}
inline Lanes operator-(const Lanes& a, const Lanes& b) {
    return _mm256_sub_ps(a.v, b.v);
}
inline Lanes operator*(const Lanes& a, const Lanes& b) {
    return _mm256_mul_ps(a.v, b.v);
}
inline Lanes operator/(const Lanes& a, const Lanes& b) {
    return _mm256_div_ps(a.v, b.v);
}
/// a * b + c
inline Lanes multiply_add(const Lanes& a, const Lanes& b, const Lanes& c) {
    return _mm256_fmadd_ps(a.v, b.v, c.v);
}
/// c - a * b
inline Lanes multiply_subtract(const Lanes& a, const Lanes& b, const Lanes& c) {
    return _mm256_fnmadd_ps(a.v, b.v, c.v);
}
inline Lanes maximum(const Lanes& a, const Lanes& b) {
    return _mm256_max_ps(a.v, b.v);
}
inline Lanes minimum(const Lanes& a, const Lanes& b) {
    return _mm256_min_ps(a.v, b.v);
}
/// The least of the eight numbers, in every lane.
inline Lanes lowest(const Lanes& a) {
    const __m256 halves = _mm256_min_ps(a.v, _mm256_permute2f128_ps(a.v, a.v, 1));
    const __m256 quarters = _mm256_min_ps(halves, _mm256_permute_ps(halves, 0x4e));
    return _mm256_min_ps(quarters, _mm256_permute_ps(quarters, 0xb1));
}
/// The greatest of the eight numbers, in every lane.
inline Lanes highest(const Lanes& a) {
    const __m256 halves = _mm256_max_ps(a.v, _mm256_permute2f128_ps(a.v, a.v, 1));
    const __m256 quarters = _mm256_max_ps(halves, _mm256_permute_ps(halves, 0x4e));
    return _mm256_max_ps(quarters, _mm256_permute_ps(quarters, 0xb1));
}
inline Lanes absolute(const Lanes& a) {
    return _mm256_andnot_ps(_mm256_set1_ps(-0.0F), a.v);
}
inline Lanes root(const Lanes& a) {
    return _mm256_sqrt_ps(a.v);
}
/// To the nearest integer.
inline Lanes rounded(const Lanes& a) {
    return _mm256_round_ps(a.v, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
}
/// Bit i: not a > b in lane i (so a number that is none counts as collision).
inline unsigned not_greater(const Lanes& a, const Lanes& b) {
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_NGT_UQ)));
}
/// In every lane: x where a < b, else y.
inline Lanes where_less(const Lanes& a, const Lanes& b, const Lanes& x, const Lanes& y) {
    return _mm256_blendv_ps(y.v, x.v, _mm256_cmp_ps(a.v, b.v, _CMP_LT_OQ));
}
/// In every lane: where quadrant (an integer) is odd `odd`, else `even`; negated where `quadrant + turn` has
/// bit 1.
inline Lanes by_quadrant(const Lanes& quadrant, int turn, const Lanes& even, const Lanes& odd) {
    const __m256i q = _mm256_cvtps_epi32(quadrant.v);
    const __m256 value = _mm256_blendv_ps(even.v, odd.v, _mm256_castsi256_ps(_mm256_slli_epi32(q, 31)));
    const __m256i turned = _mm256_add_epi32(q, _mm256_set1_epi32(turn));
    const __m256i sign = _mm256_slli_epi32(_mm256_srli_epi32(turned, 1), 31);
    return _mm256_xor_ps(value, _mm256_castsi256_ps(sign));
}

}  // namespace
}  // namespace praxis::tamp::kernel
