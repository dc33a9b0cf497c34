#include "reports/planes/blocks.h"

#include "reports/planes/deflate.h"

namespace zproof::planes {

nlohmann::json plane_facts(std::string_view coding, std::string_view decoded) {
    return {{"coding", coding}, {"crc32", crc32_of(decoded)}};
}

Block predicted(const std::string& name, Words values, std::size_t width, Prediction prediction) {
    const bool planar = prediction == Prediction::planar;
    return {name, plane_facts(planar ? "planar" : "left", values.bytes()), encode(values, width, prediction)};
}

Block beside(const std::string& name, Words values, const Guess& guess) {
    const std::size_t missed = missed_by(values, guess.values);
    const bool sparse = missed < values.size() / 16;
    Block block{name, plane_facts(sparse ? "sparse" : "beside", values.bytes()),
                sparse ? encode_sparse(values, guess.values) : encode(values, guess.values)};
    if (sparse) block.facts["count"] = missed;
    block.facts["beside"] = guess.name;
    return block;
}

Block bytes_block(const std::string& name, std::string_view bytes) {
    return {name, plane_facts("bytes", bytes), deflated_side_by_side(bytes)};
}

Block runs_block(const std::string& name, std::string_view bytes) {
    return {name, plane_facts("runs", bytes), encode_runs(bytes)};
}

Block json_block(const std::string& name, const nlohmann::json& content) {
    const std::string text = content.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    return {name, {{"coding", "json"}, {"length", text.size()}}, deflated(text)};
}

}  // namespace zproof::planes
