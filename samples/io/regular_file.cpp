#include "samples/io/regular_file.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "lib/base/near_files.h"
#include "samples/io/files.h"

namespace io
{

// With O_NONBLOCK, opening a pipe that has no writer does not wait.
RegularFile::RegularFile(const std::string &path, uint64_t most_bytes)
    : number_(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC))
{
    struct stat facts = {};
    if (number_ < 0 || fstat(number_, &facts) != 0) {
        const bool missing = errno == ENOENT;
        wrong_ = why(path, "opened");
        if (missing) wrong_ += claque::base::near_files(path);
        return;
    }
    size_ = static_cast<uint64_t>(facts.st_size);
    if (!S_ISREG(facts.st_mode)) wrong_ = path + " is not a regular file";
    else if (size_ > most_bytes) wrong_ = too_long(path, most_bytes);
}

RegularFile::~RegularFile()
{
    if (number_ >= 0) close(number_);
}

bool RegularFile::read(uint64_t at, void *bytes, size_t size) const
{
    for (size_t have = 0; have < size;) {
        const ssize_t got =
            pread(number_, static_cast<char *>(bytes) + have, size - have, static_cast<off_t>(at + have));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        have += static_cast<size_t>(got);
    }
    return true;
}

}  // namespace io
