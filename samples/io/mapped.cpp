#include "samples/io/mapped.h"

#include <sys/mman.h>

#include "samples/io/files.h"

namespace io
{

std::string Mapped::open(const std::string &path)
{
    const RegularFile file(path, most_record_bytes);
    if (!file.wrong().empty() || file.size() == 0) return file.wrong();
    void *data = mmap(nullptr, static_cast<size_t>(file.size()), PROT_READ, MAP_PRIVATE, file.number(), 0);
    if (data == MAP_FAILED) return why(path, "read");
    data_ = static_cast<const char *>(data), size_ = static_cast<size_t>(file.size());
    pages_.emplace(path, data_, size_);
    return "";
}

Mapped::~Mapped()
{
    if (size_ > 0) munmap(const_cast<char *>(data_), size_);
}

}  // namespace io
