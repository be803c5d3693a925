// Mutates glTF by its structure: the JSON as a tree, the buffer a range at a time; chunks keep true lengths.
#include "tests/fuzz/json_mutator.h"
#include "tests/support/gltf_maker.h"

namespace
{

using namespace fuzzing;

struct Parts {
    bool glb = false;
    Json json;
    Bytes binary;
};

uint32_t word_at(const uint8_t *bytes)
{
    uint32_t out = 0;
    std::memcpy(&out, bytes, sizeof out);
    return out;
}

// False if the input has no JSON to work on.
bool take_apart(const uint8_t *bytes, size_t size, Parts &out)
{
    out.glb = size >= 20 && std::memcmp(bytes, "glTF", 4) == 0;
    if (!out.glb) {
        out.json = parsed(bytes, size);
        return out.json.is_object();
    }
    const size_t head = word_at(bytes + 12);
    if (head > size - 20) return false;
    out.json = parsed(bytes + 20, head);
    if (20 + head + 8 < size) out.binary.assign(bytes + 20 + head + 8, bytes + size);
    return out.json.is_object();
}

// Returns the size, or 0 if there is no room.
size_t put_together(const Parts &parts, uint8_t *out, size_t max_size)
{
    const std::string head = parts.json.dump(-1, ' ', false, Json::error_handler_t::replace);
    Bytes bytes(head.begin(), head.end());
    if (parts.glb) {
        claque::testing::Maker maker;
        maker.binary = parts.binary;
        bytes = maker.glb_of(head);
    }
    if (bytes.size() > max_size) return 0;
    std::memcpy(out, bytes.data(), bytes.size());
    return bytes.size();
}

// What a buffer view covers, or all of it.
void mutate_buffer(Parts &parts, Dice &dice)
{
    size_t first = 0, length = parts.binary.size();
    const auto views = parts.json.find("bufferViews");
    if (views != parts.json.end() && views->is_array() && !views->empty() && !dice.one_in(6)) {
        const Json &view = (*views)[dice.below(views->size())];
        const auto number = [&](const char *key, size_t otherwise) {
            return view.is_object() && view.contains(key) && view[key].is_number_unsigned() ? view[key].get<size_t>()
                                                                                            : otherwise;
        };
        first = std::min(number("byteOffset", 0), length);
        length = std::min(number("byteLength", length), length - first);
    }
    if (length == 0) return;
    Bytes part(parts.binary.begin() + static_cast<std::ptrdiff_t>(first),
               parts.binary.begin() + static_cast<std::ptrdiff_t>(first + length));
    const uint32_t floats[] = {0x7f800000, 0x7fc00000, 0x00000001, 0x7f7fffff, 0xbf800000, 0, 0x3f800000, 0x4b800000};
    if (length >= 4 && dice.one_in(3)) std::memcpy(part.data() + 4 * dice.below(length / 4), &floats[dice.below(8)], 4);
    else LLVMFuzzerMutate(part.data(), length, length);
    std::copy(part.begin(), part.end(), parts.binary.begin() + static_cast<std::ptrdiff_t>(first));
}

}  // namespace

extern "C" size_t LLVMFuzzerCustomMutator(uint8_t *bytes, size_t size, size_t max_size, unsigned seed)
{
    Dice dice(seed);
    Parts parts;
    if (dice.one_in(16) || !take_apart(bytes, size, parts)) return LLVMFuzzerMutate(bytes, size, max_size);
    if (parts.binary.empty() || !dice.one_in(3))
        for (size_t changes = 1 + dice.below(3); changes > 0; --changes) mutate(parts.json, dice);
    else mutate_buffer(parts, dice);
    const size_t out = put_together(parts, bytes, max_size);
    return out ? out : LLVMFuzzerMutate(bytes, size, max_size);
}

// A list or element of the second file in the first one.
extern "C" size_t LLVMFuzzerCustomCrossOver(const uint8_t *one, size_t one_size, const uint8_t *two, size_t two_size,
                                            uint8_t *out, size_t max_size, unsigned seed)
{
    Dice dice(seed);
    Parts first, second;
    if (!take_apart(one, one_size, first) || !take_apart(two, two_size, second) || second.json.empty()) return 0;
    const auto from = std::next(second.json.begin(), static_cast<std::ptrdiff_t>(dice.below(second.json.size())));
    Json &to = first.json[from.key()];
    if (from->is_array() && !from->empty() && to.is_array() && !dice.one_in(4))
        to.push_back((*from)[dice.below(from->size())]);
    else to = *from;
    if (dice.one_in(3)) first.binary = second.binary, first.glb = second.glb;
    return put_together(first, out, max_size);
}
