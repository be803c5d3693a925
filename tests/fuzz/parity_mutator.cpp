// Mutates one file of a parity folder at a time: capture.json as a tree, arrays in their values or in their heads.
#include "tests/fuzz/files.h"
#include "tests/fuzz/json_mutator.h"
#include "tests/fuzz/parity_files.h"

namespace
{

using namespace fuzzing;

void mutate_range(Bytes &bytes, size_t first, size_t length)
{
    if (length > 0) LLVMFuzzerMutate(bytes.data() + first, length, length);
}

void mutate_file(uint8_t number, Bytes &bytes, Dice &dice)
{
    if (number % 128 % parity_file_count == 0 && !dice.one_in(8)) {
        Json json = parsed(bytes.data(), bytes.size());
        if (!json.is_discarded()) {
            mutate(json, dice);
            const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
            bytes.assign(text.begin(), text.end());
            return;
        }
    }
    const size_t head = bytes.size() < 10 ? 0 : std::min<size_t>(bytes.size(), size_t(10) + bytes[8] + 256u * bytes[9]);
    if (!dice.one_in(4)) return mutate_range(bytes, head, bytes.size() - head);
    if (!dice.one_in(3)) return mutate_range(bytes, 0, head);
    const size_t size = bytes.size();
    bytes.resize(size + 64);
    bytes.resize(LLVMFuzzerMutate(bytes.data(), size, size + 64));
}

}  // namespace

extern "C" size_t LLVMFuzzerCustomMutator(uint8_t *bytes, size_t size, size_t max_size, unsigned seed)
{
    Dice dice(seed);
    Files files = files_of(bytes, size);
    if (files.empty() || dice.one_in(30)) return LLVMFuzzerMutate(bytes, size, max_size);
    const size_t which = dice.below(files.size());
    if (dice.one_in(12)) files.erase(files.begin() + static_cast<std::ptrdiff_t>(which));
    else {
        // A file of the second result, which takes the first one's place there.
        if (files[which].first < 128 && dice.one_in(2)) {
            const auto copy = files[which];
            files.emplace_back(static_cast<uint8_t>(copy.first + 128), copy.second);
            mutate_file(files.back().first, files.back().second, dice);
        } else mutate_file(files[which].first, files[which].second, dice);
    }
    const Bytes out = packed(files);
    if (out.size() > max_size) return LLVMFuzzerMutate(bytes, size, max_size);
    if (!out.empty()) std::memcpy(bytes, out.data(), out.size());
    return out.size();
}
