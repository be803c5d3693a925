// What the files for `claque bench readers` are made and timed with.
#pragma once

#include <string>

#include "samples/cli/reader_files.h"

namespace cli
{

// A clq_write that appends to a std::string.
int append_bytes(void *text, const void *bytes, size_t size_bytes);

// Of a glTF file.
scenes::Own<clq_asset> asset_of(const scenes::Library &library, const std::string &bytes);
scenes::Own<clq_template> template_of(const scenes::Library &library, const std::string &bytes);

inline std::string digits(uint32_t number) { return std::to_string(number); }

// `count` of what `one` says of each number, after `head` and before `tail`.
template <class One>
std::string repeated(const std::string &head, uint32_t count, const One &one, const std::string &tail = "")
{
    std::string text = head;
    for (uint32_t i = 0; i < count; ++i) text += one(i);
    return text + tail;
}

template <class Work>
Reading timed(const Work &work)
{
    Reading out;
    const double begin = processor_ms();
    out.loaded = work();
    out.load_ms = processor_ms() - begin;
    return out;
}

}  // namespace cli
