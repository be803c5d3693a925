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

std::string read_in_pieces(const std::string &path, const std::function<void(const char *piece, size_t size)> &take)
{
    Descriptor file = {open(path.c_str(), O_RDONLY | O_CLOEXEC)};
    if (file.number < 0) return why(path, "opened");
    char piece[65536];
    while (true) {
        const ssize_t got = ::read(file.number, piece, sizeof piece);
        if (got == 0) return "";
        if (got > 0) take(piece, static_cast<size_t>(got));
        else if (errno != EINTR) return why(path, "read");
    }
}

std::string read_whole(const std::string &path, std::string &bytes)
{
    bytes.clear();
    return read_in_pieces(path, [&](const char *piece, size_t size) { bytes.append(piece, size); });
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
