#include "samples/processes/shared_pages.h"

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>
#include <sys/mman.h>

namespace processes
{

SharedPages::SharedPages(size_t bytes) : bytes_(bytes > 0 ? bytes : 1)
{
    void *there = mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (there == MAP_FAILED)
        throw std::runtime_error("no " + std::to_string(bytes_) +
                                 " bytes of memory that processes share: " + std::strerror(errno));
    data_ = static_cast<uint8_t *>(there);
}

SharedPages::~SharedPages() { munmap(data_, bytes_); }

}  // namespace processes
