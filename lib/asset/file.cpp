#include "lib/asset/file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "lib/base/error.h"
#include "lib/base/near_files.h"

namespace claque::asset
{

using base::fail;

namespace
{

class Descriptor
{
public:
    // With O_NONBLOCK, opening a pipe that has no writer does not wait.
    explicit Descriptor(const std::string &path) : number_(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC))
    {
        if (number_ >= 0) return;
        const int error = errno;
        const std::string near = error == ENOENT ? base::near_files(path) : "";
        fail(CLQ_IO, "'%s' cannot be opened: %s%s", path.c_str(), std::strerror(error), near.c_str());
    }
    ~Descriptor() { close(number_); }
    Descriptor(const Descriptor &) = delete;
    Descriptor &operator=(const Descriptor &) = delete;
    int number() const { return number_; }

private:
    int number_;
};

}  // namespace

std::vector<uint8_t> read_file(const std::string &path, uint64_t limit_bytes)
{
    const Descriptor file(path);
    struct stat facts;
    if (fstat(file.number(), &facts) != 0) fail(CLQ_IO, "'%s': %s", path.c_str(), std::strerror(errno));
    if (!S_ISREG(facts.st_mode)) fail(CLQ_IO, "'%s' is not a regular file", path.c_str());
    const uint64_t size = static_cast<uint64_t>(facts.st_size);
    if (size > limit_bytes)
        fail(CLQ_LIMIT, "'%s' has %llu bytes: %llu are allowed", path.c_str(), static_cast<unsigned long long>(size),
             static_cast<unsigned long long>(limit_bytes));
    std::vector<uint8_t> bytes(size);
    size_t have = 0;
    while (have < bytes.size()) {
        const ssize_t got = read(file.number(), bytes.data() + have, std::min<size_t>(bytes.size() - have, 1 << 30));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail(CLQ_IO, "'%s' cannot be read: %s", path.c_str(), std::strerror(errno));
        if (got == 0) fail(CLQ_IO, "'%s' ended after %zu of %zu bytes", path.c_str(), have, bytes.size());
        have += static_cast<size_t>(got);
    }
    return bytes;
}

}  // namespace claque::asset
