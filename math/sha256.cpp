#include "math/sha256.h"

#include <openssl/evp.h>

#include <array>
#include <new>

namespace zproof {

/// OpenSSL's sum, freed with it. It refuses only where memory runs out.
struct Sha256::State {
    EVP_MD_CTX* sum = EVP_MD_CTX_new();

    State() {
        if (sum == nullptr || EVP_DigestInit_ex(sum, EVP_sha256(), nullptr) != 1) throw std::bad_alloc{};
    }
    ~State() { EVP_MD_CTX_free(sum); }
    State(const State&) = delete;
    State& operator=(const State&) = delete;
};

Sha256::Sha256() : state_(std::make_unique<State>()) {}
Sha256::~Sha256() = default;

void Sha256::add(std::span<const std::byte> bytes) {
    if (EVP_DigestUpdate(state_->sum, bytes.data(), bytes.size()) != 1) throw std::bad_alloc{};
}

void Sha256::add(std::string_view text) { add(std::as_bytes(std::span{text})); }

void Sha256::add(std::uint64_t number) {
    std::array<std::byte, 8> bytes;
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = std::byte(number >> (8 * i) & 0xFF);
    add(bytes);
}

std::string Sha256::hex() {
    constexpr std::string_view digits = "0123456789abcdef";
    std::array<unsigned char, 32> sum;
    if (EVP_DigestFinal_ex(state_->sum, sum.data(), nullptr) != 1) throw std::bad_alloc{};
    std::string text;
    for (const unsigned char byte : sum) text += {digits[byte >> 4], digits[byte & 15]};
    return text;
}

std::string sha256_of(std::string_view text) {
    Sha256 sum;
    sum.add(text);
    return sum.hex();
}

}  // namespace zproof
