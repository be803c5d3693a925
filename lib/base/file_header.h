// The header of the files that the library writes itself. Little-endian:
//   8 bytes magic, u32 version, u32 zero, u64 size of the contents, u64 FNV-1a of the contents.
#pragma once

#include <array>

#include "lib/base/archive.h"

namespace claque::base
{

struct FileForm {
    uint8_t magic[8];
    uint32_t version;
    const char *subject;  // "a saved track"
};

constexpr size_t file_header_bytes = 32;

std::array<uint8_t, file_header_bytes> file_header(const FileForm &form, uint64_t size, uint64_t hash);

// Checks a header, the size and the hash of what follows it, and returns the size of the contents: they begin at
// bytes + file_header_bytes. Throws Error (CLQ_FORMAT).
size_t check_file_header(const FileForm &form, const uint8_t *bytes, size_t size);

template <class Count = uint32_t>
ArchiveReader<Count> open_file(const FileForm &form, const uint8_t *bytes, size_t size)
{
    const size_t contents = check_file_header(form, bytes, size);
    return ArchiveReader<Count>(form.subject, bytes + file_header_bytes, contents);
}

// Writes a header and the contents that `write(archive)` writes, at the end of `out`.
template <class Count = uint32_t, class Write>
void append_file(const FileForm &form, std::pmr::vector<uint8_t> &out, const Write &write)
{
    const size_t start = out.size();
    out.resize(start + file_header_bytes);
    ArraySink sink(out);
    ArchiveWriter<Count> archive(sink);
    write(archive);
    archive.flush();
    const uint8_t *contents = out.data() + start + file_header_bytes;
    const size_t size = out.size() - start - file_header_bytes;
    const auto header = file_header(form, size, fnv(fnv_start, contents, size));
    std::memcpy(out.data() + start, header.data(), header.size());
}

}  // namespace claque::base
