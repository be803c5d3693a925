// Guards the JSON parser: a scan of the bytes first checks that the parsed document will be small and shallow enough.
#include "lib/asset/json_view.h"

namespace claque::asset
{

using base::fail;

namespace
{

constexpr uint32_t deepest = 128;
// The largest memory for one parsed value: a node of a member map, or an array's slot while the array grows.
constexpr uint64_t value_bytes = 200;

struct Scan {
    uint64_t values = 0;
    uint64_t string_bytes = 0;
};

// Counts the values that a parser would create. It need not detect wrong syntax, but wrong syntax may not mislead it.
Scan scan(const uint8_t *bytes, size_t size)
{
    Scan out;
    uint32_t depth = 0;
    bool quoted = false;
    for (size_t i = 0; i < size; ++i) {
        const uint8_t c = bytes[i];
        if (quoted) {
            ++out.string_bytes;
            if (c == '\\') ++i;
            if (c == '"') quoted = false;
        } else if (c == '"') {
            quoted = true;
        } else if (c == '[' || c == '{') {
            if (++depth > deepest) fail(CLQ_LIMIT, "the JSON is nested more than %u deep at byte %zu", deepest, i);
            ++out.values;
        } else if (c == ']' || c == '}') {
            if (depth > 0) --depth;
        } else if (c == ',') {
            ++out.values;
        }
    }
    return out;
}

// Frees a value from its leaves up, at most `deepest` levels deep.
void dismantle(nlohmann::json &value) noexcept
{
    if (auto *array = value.get_ptr<nlohmann::json::array_t *>()) {
        for (nlohmann::json &element : *array) dismantle(element);
        array->clear();
    } else if (auto *object = value.get_ptr<nlohmann::json::object_t *>()) {
        for (auto &member : *object) dismantle(member.second);
        object->clear();
    }
}

void parse(const uint8_t *bytes, size_t size, nlohmann::json &out)
{
    // The value outlives a failure; nlohmann::json::parse would destroy its own.
    nlohmann::detail::json_sax_dom_parser<nlohmann::json> builder(out, true);
    nlohmann::json::sax_parse(bytes, bytes + size, &builder);
}

}  // namespace

JsonDocument::JsonDocument(const uint8_t *bytes, size_t size, uint64_t memory_bytes)
{
    const Scan found = scan(bytes, size);
    const uint64_t estimate = found.values * value_bytes + 2 * found.string_bytes;
    if (estimate > memory_bytes)
        fail(CLQ_LIMIT, "the JSON of %zu bytes would take about %llu bytes of %llu allowed", size,
             static_cast<unsigned long long>(estimate), static_cast<unsigned long long>(memory_bytes));
    try {
        parse(bytes, size, root_);
    } catch (const nlohmann::json::exception &error) {
        dismantle(root_);
        // The text is "[json.exception.parse_error.101] parse error at line 1, ...": drop the part in brackets.
        std::string text = error.what();
        if (const size_t end = text.find("] "); text[0] == '[' && end != std::string::npos) text.erase(0, end + 2);
        fail(CLQ_FORMAT, "the JSON is broken: %.300s", text.c_str());
    } catch (...) {
        dismantle(root_);
        throw;
    }
}

JsonDocument::~JsonDocument() { dismantle(root_); }

}  // namespace claque::asset
