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
