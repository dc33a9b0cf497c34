#include "tests/reports/plane_decoder.h"

#include <zlib.h>

#include <bit>

#include "reports/report_error.h"

namespace zproof::planes {
namespace {

std::uint32_t unfolded(std::uint32_t folded) { return (folded >> 1) ^ (0u - (folded & 1)); }

template <class T>
std::vector<T> from_byte_planes(std::string_view deflated_bytes, std::size_t count) {
    const std::string bytes = inflated(deflated_bytes, sizeof(T) * count);
    if (count == 0 ? !bytes.empty() : bytes.size() % count != 0)
        throw ReportError("planes: a block is damaged: not a whole number of byte planes; run zproof again");
    std::vector<T> values(count);
    for (std::size_t at = 0; at < bytes.size(); ++at)
        values[at % count] |= T(std::uint8_t(bytes[at])) << (8 * (at / count));
    return values;
}

std::uint32_t guess_for(const std::uint32_t* values, std::size_t i, std::size_t width,
                        Prediction prediction) {
    const bool has_left = i % width > 0, has_upper = i >= width;
    if (prediction == Prediction::left) return has_left ? values[i - 1] : 0;
    if (has_left && has_upper) return values[i - 1] + values[i - width] - values[i - width - 1];
    return has_left ? values[i - 1] : has_upper ? values[i - width] : 0;
}

}  // namespace

std::string inflated(std::string_view bytes, std::size_t most) {
    std::string plain(most + 1, '\0');  // zlib refuses to write nothing into nothing
    uLongf size = plain.size();
    if (uncompress(reinterpret_cast<Bytef*>(plain.data()), &size,
                   reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()) != Z_OK ||
        size > most)
        throw ReportError("planes: a block is damaged: expected at most " + std::to_string(most) +
                          " bytes of deflated content; run zproof again");
    plain.resize(size);
    return plain;
}

std::vector<std::uint32_t> decode(std::string_view bytes, std::size_t count, std::size_t width,
                                  Prediction prediction) {
    std::vector<std::uint32_t> values = from_byte_planes<std::uint32_t>(bytes, count);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = unfolded(values[i]) + guess_for(values.data(), i, width, prediction);
    return values;
}

std::vector<std::uint32_t> decode(std::string_view bytes, std::span<const std::uint32_t> guess) {
    std::vector<std::uint32_t> values = from_byte_planes<std::uint32_t>(bytes, guess.size());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = unfolded(values[i]) + guess[i];
    return values;
}

std::vector<std::uint32_t> decode_sparse(std::string_view bytes, std::size_t count,
                                         std::span<const std::uint32_t> guess) {
    const std::vector<std::uint32_t> words =
        decode(bytes, 2 * count, std::max<std::size_t>(count, 1), Prediction::left);
    std::vector<std::uint32_t> values(guess.begin(), guess.end());
    for (std::size_t i = 0; i < count; ++i) {
        if (words[i] >= values.size())
            throw ReportError("planes: a block is damaged: a place beyond its plane; run zproof again");
        values[words[i]] = words[count + i];
    }
    return values;
}

std::string decode_runs(std::string_view bytes, std::size_t count) {
    constexpr std::size_t most_bytes_of_run = 10;
    const std::string runs = inflated(bytes, most_bytes_of_run * count);
    std::string values;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        std::size_t length = 0;
        for (int shift = 0; i < runs.size(); shift += 7) {
            length |= std::size_t(runs[i] & 127) << shift;
            if ((runs[i++] & 128) == 0) break;
        }
        if (i >= runs.size() || length > count - values.size())
            throw ReportError("planes: a block is damaged: a run beyond its plane; run zproof again");
        values.append(length, runs[i]);
    }
    if (values.size() != count)
        throw ReportError("planes: a block is damaged: its runs end early; run zproof again");
    return values;
}

std::vector<double> decode_doubles(std::string_view bytes, std::size_t count) {
    std::vector<double> values;
    for (const std::uint64_t bits : from_byte_planes<std::uint64_t>(bytes, count))
        values.push_back(std::bit_cast<double>(bits));
    return values;
}

}  // namespace zproof::planes
