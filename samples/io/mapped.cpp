#include "samples/io/mapped.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "samples/io/files.h"

namespace io
{

std::string Mapped::open(const std::string &path)
{
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return why(path, "read");
    struct stat there = {};
    const bool known = fstat(file, &there) == 0;
    if (known && there.st_size > 0) {
        void *data = mmap(nullptr, static_cast<size_t>(there.st_size), PROT_READ, MAP_PRIVATE, file, 0);
        if (data != MAP_FAILED) data_ = static_cast<const char *>(data), size_ = static_cast<size_t>(there.st_size);
    }
    const std::string wrong = known && (there.st_size == 0 || size_ > 0) ? "" : why(path, "read");
    close(file);
    if (size_ > 0) pages_.emplace(path, data_, size_);
    return wrong;
}

Mapped::~Mapped()
{
    if (size_ > 0) munmap(const_cast<char *>(data_), size_);
}

}  // namespace io
