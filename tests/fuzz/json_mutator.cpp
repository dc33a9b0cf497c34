// Mutates JSON as JSON: most changes of single bytes end in the parser. What follows the first 0 is no JSON.
#include <array>
#include <cstring>
#include <nlohmann/json.hpp>
#include <random>

#include "tests/fuzz/harness.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

using nlohmann::json;
using Random = std::minstd_rand;

void gather(json& value, std::vector<json*>& values) {
    values.push_back(&value);
    if (value.is_structured())
        for (json& inner : value) gather(inner, values);
}

json odd_value(Random& random) {
    const std::array odd{json(),           json(true),    json(0),      json(-1),         json(1),
                         json(2),          json(255),     json(65536),  json(2147483647), json(2147483648),
                         json(4294967295), json(1e-310),  json(1e-40),  json(0.5),        json(1e11),
                         json(1e39),       json(1e308),   json(-1e308), json(""),         json("a"),
                         json::array(),    json::object()};
    return odd[random() % odd.size()];
}

/// A text's bytes, or a number's digits, as libFuzzer changes them.
json with_other_bytes(const json& value) {
    std::string text = value.is_string() ? value.get<std::string>() : value.dump();
    const std::size_t size = text.size();
    text.resize(size + 16);
    text.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(text.data()), size, text.size()));
    if (value.is_string()) return text;
    json number = json::parse(text, nullptr, false);
    return number.is_number() ? number : json(0);
}

/// Puts a member or an element in, takes one out, or doubles one.
void reshape(json& value, const json& other, Random& random) {
    const std::size_t at = value.empty() ? 0 : random() % value.size();
    if (value.is_array()) {
        if (random() % 2 == 0 || value.empty()) return value.push_back(other);
        return void(value.erase(value.begin() + std::ptrdiff_t(at)));
    }
    if (value.empty()) return void(value["a"] = other);
    const auto member = std::next(value.begin(), std::ptrdiff_t(at));
    if (random() % 2 == 0) return void(value.erase(member));
    value[with_other_bytes(member.key()).get<std::string>()] = other;
}

void mutate(json& whole, Random& random) {
    std::vector<json*> values;
    gather(whole, values);
    json& value = *values[random() % values.size()];
    const json other = *values[random() % values.size()];
    switch (random() % 4) {
        case 0:
            return void(value = odd_value(random));
        case 1:
            return void(value = other);
        case 2:
            if (value.is_structured()) return reshape(value, other, random);
            [[fallthrough]];
        default:
            if (value.is_structured()) return reshape(value, odd_value(random), random);
            value = with_other_bytes(value);
    }
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
    Random random(seed);
    const auto [text, tail] = zproof::fuzz::split_at_zero({data, size});
    json whole = json::parse(text.begin(), text.end(), nullptr, false);
    if (whole.is_discarded() || random() % 8 == 0) return LLVMFuzzerMutate(data, size, most);
    for (unsigned left = 1 + random() % 3; left > 0; --left) mutate(whole, random);
    std::string mutated = whole.dump(-1, ' ', false, json::error_handler_t::replace);
    if (text.size() < size) mutated.append(1, '\0').append(tail.begin(), tail.end());
    if (mutated.size() > most) return LLVMFuzzerMutate(data, size, most);
    std::memcpy(data, mutated.data(), mutated.size());
    return mutated.size();
}
