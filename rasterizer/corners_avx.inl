// For AVX2 and AVX-512.

/// Sixteen vertices of 16 bytes each, four at a time: x0 y0 N0, x1 y1 N1 ... into x0 x1 ..., y0 y1 ..., N0 N1
/// ...
void put_side_by_side(const SnappedVertex* const (&vertex)[16], std::int32_t* x, std::int32_t* y,
                      double* nearness) {
    const auto load_one = [&](int i) { return _mm_loadu_pd(reinterpret_cast<const double*>(vertex[i])); };
    const __m256i even_then_odd = _mm256_setr_epi32(0, 2, 4, 6, 1, 3, 5, 7);
    for (int i = 0; i < 16; i += 4) {
        const __m256d even = _mm256_set_m128d(load_one(i + 2), load_one(i));
        const __m256d odd = _mm256_set_m128d(load_one(i + 3), load_one(i + 1));
        const __m256i points = _mm256_castpd_si256(_mm256_unpacklo_pd(even, odd));
        const __m256i x_then_y = _mm256_permutevar8x32_epi32(points, even_then_odd);
        _mm_store_si128(reinterpret_cast<__m128i*>(x + i), _mm256_castsi256_si128(x_then_y));
        _mm_store_si128(reinterpret_cast<__m128i*>(y + i), _mm256_extracti128_si256(x_then_y, 1));
        _mm256_store_pd(nearness + i, _mm256_unpackhi_pd(even, odd));
    }
}

/// The other way.
void put_one_by_one(const std::int32_t* x, const std::int32_t* y, const double* nearness,
                    SnappedVertex* vertex) {
    for (int i = 0; i < 16; i += 4) {
        const __m128i xs = _mm_load_si128(reinterpret_cast<const __m128i*>(x + i));
        const __m128i ys = _mm_load_si128(reinterpret_cast<const __m128i*>(y + i));
        const __m128d first_points = _mm_castsi128_pd(_mm_unpacklo_epi32(xs, ys));
        const __m128d last_points = _mm_castsi128_pd(_mm_unpackhi_epi32(xs, ys));
        const __m128d first_nearness = _mm_load_pd(nearness + i),
                      last_nearness = _mm_load_pd(nearness + i + 2);
        auto* const to = reinterpret_cast<double*>(vertex + i);
        _mm_storeu_pd(to, _mm_unpacklo_pd(first_points, first_nearness));
        _mm_storeu_pd(to + 2, _mm_unpackhi_pd(first_points, first_nearness));
        _mm_storeu_pd(to + 4, _mm_unpacklo_pd(last_points, last_nearness));
        _mm_storeu_pd(to + 6, _mm_unpackhi_pd(last_points, last_nearness));
    }
}
