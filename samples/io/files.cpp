#include "samples/io/files.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace io
{
namespace
{

struct Descriptor {
    ~Descriptor()
    {
        if (number >= 0) ::close(number);
    }
    int close()
    {
        const int closed = ::close(number);
        number = -1;
        return closed;
    }
    int number;
};

bool write_all(int file, const void *bytes, size_t size_bytes)
{
    const char *at = static_cast<const char *>(bytes);
    while (size_bytes > 0) {
        const ssize_t wrote = ::write(file, at, size_bytes);
        if (wrote < 0 && errno == EINTR) continue;
        if (wrote <= 0) return false;
        at += wrote;
        size_bytes -= static_cast<size_t>(wrote);
    }
    return true;
}

}  // namespace

std::string why(const std::string &path, const char *doing)
{
    return path + " could not be " + doing + ": " + std::strerror(errno);
}

std::string too_long(const std::string &path, uint64_t most_bytes)
{
    return path + " has more than " + std::to_string(most_bytes) + " bytes, the most that is read of it";
}

// A file may grow while it is read, and those of /proc have no size.
std::string read_in_pieces(const std::string &path, uint64_t most_bytes,
                           const std::function<void(const char *piece, size_t size)> &take)
{
    const RegularFile file(path, most_bytes);
    if (!file.wrong().empty()) return file.wrong();
    char piece[65536];
    for (uint64_t have = 0;;) {
        const ssize_t got = ::read(file.number(), piece, sizeof piece);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return why(path, "read");
        if (got == 0) return "";
        have += static_cast<uint64_t>(got);
        if (have > most_bytes) return too_long(path, most_bytes);
        take(piece, static_cast<size_t>(got));
    }
}

std::string read_whole(const std::string &path, std::string &bytes, uint64_t most_bytes)
{
    bytes.clear();
    std::string wrong =
        read_in_pieces(path, most_bytes, [&](const char *piece, size_t size) { bytes.append(piece, size); });
    if (!wrong.empty()) bytes.clear();
    return wrong;
}

std::string write_new(const std::string &draft, const std::string &path, const void *bytes, size_t size_bytes)
{
    Descriptor file = {open(draft.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666)};
    if (file.number < 0) return why(path, "written");
    // A renamed file whose contents are not on the disk yet is empty after a power cut.
    if (write_all(file.number, bytes, size_bytes) && fsync(file.number) == 0 && file.close() == 0) return "";
    const std::string sentence = why(path, "written");
    unlink(draft.c_str());
    return sentence;
}

std::string draft_of(const std::string &path) { return path + ".part" + std::to_string(getpid()); }

}  // namespace io
