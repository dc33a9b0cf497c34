/// SHA-256 (FIPS 180-4) of what is fed to it, piece by piece.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace zproof {

class Sha256 {
  public:
    Sha256();
    ~Sha256();
    Sha256(const Sha256&) = delete;
    Sha256& operator=(const Sha256&) = delete;

    void add(std::span<const std::byte> bytes);
    void add(std::string_view text);
    void add(std::uint64_t number);  ///< as 8 bytes, the least significant first

    /// 64 hexadecimal digits in lower case. Ends the sum: to be called once.
    std::string hex();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The SHA-256 of one text: 64 hexadecimal digits in lower case.
std::string sha256_of(std::string_view text);

}  // namespace zproof
