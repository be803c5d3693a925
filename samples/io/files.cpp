#include "samples/io/files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace io
{
namespace
{

constexpr const char *draft_ending = ".part";

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

// The lock says that a process writes the draft. remove_abandoned_drafts() may take it before.
int new_locked(const std::string &draft, mode_t mode)
{
    for (;;) {
        const int file = open(draft.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
        struct stat made = {};
        if (file < 0 || flock(file, LOCK_EX) != 0 || fstat(file, &made) != 0 || made.st_nlink > 0) return file;
        close(file);
    }
}

bool is_draft(const std::string &name)
{
    const size_t at = name.rfind(draft_ending);
    const size_t number = at + std::strlen(draft_ending);
    return at != std::string::npos && number < name.size() &&
           name.find_first_not_of("0123456789", number) == std::string::npos;
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

int open_draft(const std::string &draft, const std::string &path)
{
    struct stat older = {};
    const bool replaces = stat(path.c_str(), &older) == 0 && S_ISREG(older.st_mode);
    const int file = new_locked(draft, replaces ? 0600 : 0666);
    if (file < 0 || !replaces) return file;
    // Only root may give a file away. Without its owner the older mode may give a group what is not meant for it.
    const bool is_own = fchown(file, older.st_uid, older.st_gid) == 0;
    (void)fchmod(file, older.st_mode & (is_own ? 07777 : 0707));
    return file;
}

std::string write_new(const std::string &draft, const std::string &path, const void *bytes, size_t size_bytes,
                      bool takes_place)
{
    Descriptor file = {open_draft(draft, path)};
    if (file.number < 0) return why(path, "written");
    const Descriptor locked = {fcntl(file.number, F_DUPFD_CLOEXEC, 0)};  // until it has its place
    // A renamed file whose contents are not on the disk yet is empty after a power cut.
    if (write_all(file.number, bytes, size_bytes) && fsync(file.number) == 0 && file.close() == 0 &&
        (!takes_place || std::rename(draft.c_str(), path.c_str()) == 0))
        return "";
    const std::string sentence = why(path, "written");
    unlink(draft.c_str());
    return sentence;
}

std::string draft_of(const std::string &path) { return path + draft_ending + std::to_string(getpid()); }

void remove_abandoned_drafts(const std::string &folder)
{
    std::error_code none;
    for (const auto &entry : std::filesystem::directory_iterator(folder, none)) {
        if (!is_draft(entry.path().filename().string())) continue;
        const Descriptor file = {open(entry.path().c_str(), O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC)};
        if (file.number >= 0 && flock(file.number, LOCK_EX | LOCK_NB) == 0) unlink(entry.path().c_str());
    }
}

}  // namespace io
