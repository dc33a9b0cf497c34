// A store of vertices for AVX2 and AVX-512.

/// Sixteen vertices of 16 bytes each: x0 x1 ..., y0 y1 ..., N0 N1 ... into x0 y0 N0, x1 y1 N1 ...
void put_one_by_one(const std::int32_t* x, const std::int32_t* y, const double* inverse_depth,
                    SnappedVertex* vertex) {
    for (int i = 0; i < 16; i += 4) {
        const __m128i xs = _mm_load_si128(reinterpret_cast<const __m128i*>(x + i));
        const __m128i ys = _mm_load_si128(reinterpret_cast<const __m128i*>(y + i));
        const __m128d first_points = _mm_castsi128_pd(_mm_unpacklo_epi32(xs, ys));
        const __m128d last_points = _mm_castsi128_pd(_mm_unpackhi_epi32(xs, ys));
        const __m128d first_inverse_depth = _mm_load_pd(inverse_depth + i),
                      last_inverse_depth = _mm_load_pd(inverse_depth + i + 2);
        auto* const to = reinterpret_cast<double*>(vertex + i);
        _mm_storeu_pd(to, _mm_unpacklo_pd(first_points, first_inverse_depth));
        _mm_storeu_pd(to + 2, _mm_unpackhi_pd(first_points, first_inverse_depth));
        _mm_storeu_pd(to + 4, _mm_unpacklo_pd(last_points, last_inverse_depth));
        _mm_storeu_pd(to + 6, _mm_unpackhi_pd(last_points, last_inverse_depth));
    }
}
