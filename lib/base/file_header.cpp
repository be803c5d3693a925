#include "lib/base/file_header.h"

namespace claque::base
{

std::array<uint8_t, file_header_bytes> file_header(const FileForm &form, uint64_t size, uint64_t hash)
{
    std::array<uint8_t, file_header_bytes> header = {};
    std::memcpy(header.data(), form.magic, sizeof form.magic);
    const auto put = [&](size_t at, uint64_t v, size_t count) {
        for (size_t i = 0; i < count; ++i) header[at + i] = static_cast<uint8_t>(v >> (8 * i));
    };
    put(8, form.version, 4);
    put(16, size, 8);
    put(24, hash, 8);
    return header;
}

size_t check_file_header(const FileForm &form, const uint8_t *bytes, size_t size)
{
    if (size < file_header_bytes || std::memcmp(bytes, form.magic, sizeof form.magic) != 0)
        fail(CLQ_FORMAT, "%zu bytes that are not %s", size, form.subject);
    ArchiveReader<> header(form.subject, bytes + sizeof form.magic, file_header_bytes - sizeof form.magic);
    uint32_t version = 0, zero = 0;
    uint64_t contents = 0, hash = 0;
    header.value(version), header.value(zero), header.value(contents), header.value(hash);
    if (version != form.version)
        fail(CLQ_FORMAT, "%s of version %u: this library reads version %u", form.subject, version, form.version);
    if (zero != 0 || contents != size - file_header_bytes)
        fail(CLQ_FORMAT, "%s is %zu bytes long, but its header says %llu", form.subject, size - file_header_bytes,
             big(contents));
    if (hash != fnv(fnv_start, bytes + file_header_bytes, size - file_header_bytes))
        fail(CLQ_FORMAT, "%s has been changed since it was saved: its hash differs", form.subject);
    return size - file_header_bytes;
}

}  // namespace claque::base
