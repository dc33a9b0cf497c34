// Four doubles in one register; of AVX and wider.
class Colour {
  public:
    explicit Colour(const double* sum) : rgba_{_mm256_loadu_pd(sum)} {}
    void add(const float* texel, double weight) {
        const __m256d stored = _mm256_cvtps_pd(_mm_loadu_ps(texel));
        rgba_ = _mm256_add_pd(rgba_, _mm256_mul_pd(_mm256_set1_pd(weight), stored));
    }
    void to(double* sum) const { _mm256_storeu_pd(sum, rgba_); }

  private:
    __m256d rgba_;
};
