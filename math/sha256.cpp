#include "math/sha256.h"

#include <nettle/base16.h>
#include <nettle/sha2.h>

#include <array>

namespace zproof {

struct Sha256::State {
    sha256_ctx sum;

    State() { sha256_init(&sum); }
};

Sha256::Sha256() : state_(std::make_unique<State>()) {}
Sha256::~Sha256() = default;

void Sha256::add(std::span<const std::byte> bytes) {
    sha256_update(&state_->sum, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
}

void Sha256::add(std::string_view text) { add(std::as_bytes(std::span{text})); }

void Sha256::add(std::uint64_t number) {
    std::array<std::byte, 8> bytes;
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = std::byte(number >> (8 * i) & 0xFF);
    add(bytes);
}

std::string Sha256::hex() {
    std::array<std::uint8_t, SHA256_DIGEST_SIZE> sum;
    sha256_digest(&state_->sum, sum.size(), sum.data());
    std::string text(BASE16_ENCODE_LENGTH(sum.size()), '\0');
    base16_encode_update(text.data(), sum.size(), sum.data());
    return text;
}

std::string sha256_of(std::string_view text) {
    Sha256 sum;
    sum.add(text);
    return sum.hex();
}

}  // namespace zproof
