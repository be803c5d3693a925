#include "lib/asset/cache_folder.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "lib/base/error.h"

namespace claque::asset
{

namespace
{

constexpr uint64_t largest_entry = uint64_t(1) << 32;
constexpr mode_t others_may_write = S_IWGRP | S_IWOTH;

// A file descriptor that is closed; negative: none.
class Handle
{
public:
    explicit Handle(int number) : number_(number) {}
    ~Handle()
    {
        if (number_ >= 0) close(number_);
    }
    Handle(const Handle &) = delete;
    Handle &operator=(const Handle &) = delete;
    int number() const { return number_; }
    bool is_open() const { return number_ >= 0; }

private:
    int number_;
};

// Makes missing folders, each for its owner alone. Reports nothing: opening the folder does.
void make_folders(const std::string &path)
{
    for (size_t slash = path.find('/', 1); slash != std::string::npos; slash = path.find('/', slash + 1))
        mkdir(path.substr(0, slash).c_str(), 0700);
    mkdir(path.c_str(), 0700);
}

// Links that another user has made lead where that user wants.
void check_link(std::string path)
{
    // The system follows a link whose name ends in a slash.
    while (path.size() > 1 && path.back() == '/') path.pop_back();
    struct stat facts = {};
    if (lstat(path.c_str(), &facts) == 0 && S_ISLNK(facts.st_mode) && facts.st_uid != geteuid() && facts.st_uid != 0)
        base::fail(CLQ_IO, "'%s' is a link that user %u made: remove it, or name another folder", path.c_str(),
                   static_cast<unsigned>(facts.st_uid));
}

void check_owner(const std::string &path, const struct stat &facts)
{
    if (facts.st_uid != geteuid())
        base::fail(CLQ_IO, "'%s' belongs to user %u and this program runs as user %u: name another folder",
                   path.c_str(), static_cast<unsigned>(facts.st_uid), static_cast<unsigned>(geteuid()));
    if (facts.st_mode & others_may_write)
        base::fail(CLQ_IO, "others may write there (mode %03o): 'chmod 700 %s' repairs that",
                   static_cast<unsigned>(facts.st_mode & 0777), path.c_str());
}

bool write_all(int file, const std::vector<uint8_t> &bytes)
{
    for (size_t done = 0; done < bytes.size();) {
        const ssize_t n = write(file, bytes.data() + done, bytes.size() - done);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return false;
        done += static_cast<size_t>(n);
    }
    return fsync(file) == 0;
}

// Makes a file under a name that none has yet. Different threads may write the same entry at once, and processes that
// were killed may have left parts.
template <class Make>
bool new_part(const std::string &name, std::string &part, const Make &make)
{
    static std::atomic<uint32_t> count{0};
    for (int tries = 0; tries < 100; ++tries) {
        part = name + "." + std::to_string(getpid()) + "-" + std::to_string(count++) + ".part";
        if (make()) return true;
        if (errno != EEXIST) return false;
    }
    return false;
}

bool rename_part(int folder, const std::string &part, const std::string &name)
{
    if (renameat(folder, part.c_str(), folder, name.c_str()) == 0) return true;
    const int reason = errno;
    unlinkat(folder, part.c_str(), 0);
    errno = reason;
    return false;
}

// A file without a name: nothing of it is left if the process is killed. False with EOPNOTSUPP or the like: the file
// system has no such files.
bool write_nameless(int folder, const std::string &name, const std::vector<uint8_t> &bytes, bool &supported)
{
    const Handle file(openat(folder, ".", O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600));
    const std::string itself = "/proc/self/fd/" + std::to_string(file.number());
    supported = file.is_open() && access(itself.c_str(), F_OK) == 0;
    if (!supported || !write_all(file.number(), bytes)) return false;
    if (linkat(AT_FDCWD, itself.c_str(), folder, name.c_str(), AT_SYMLINK_FOLLOW) == 0) return true;
    if (errno != EEXIST) return supported = false;
    std::string part;
    return new_part(name, part,
                    [&] { return linkat(AT_FDCWD, itself.c_str(), folder, part.c_str(), AT_SYMLINK_FOLLOW) == 0; }) &&
           rename_part(folder, part, name);
}

bool write_named(int folder, const std::string &name, const std::vector<uint8_t> &bytes)
{
    std::string part;
    int number = -1;
    const bool made = new_part(name, part, [&] {
        number = openat(folder, part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600);
        return number >= 0;
    });
    if (!made) return false;
    const Handle file(number);
    if (write_all(file.number(), bytes)) return rename_part(folder, part, name);
    const int reason = errno;
    unlinkat(folder, part.c_str(), 0);
    errno = reason;
    return false;
}

}  // namespace

CacheFolder::CacheFolder(const std::string &path) : path_(path)
{
    make_folders(path);
    check_link(path);
    number_ = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    struct stat facts = {};
    if (number_ < 0)
        base::fail(CLQ_IO, "the folder '%s' cannot be used: %s; repair that, or name another folder", path.c_str(),
                   std::strerror(errno));
    try {
        if (fstat(number_, &facts) != 0) fail("");
        check_owner(path, facts);
    } catch (...) {
        close(number_);
        throw;
    }
}

CacheFolder::~CacheFolder() { close(number_); }

void CacheFolder::fail(const std::string &name) const
{
    base::fail(CLQ_IO, "'%s/%s' cannot be written: %s; repair that, or name another folder", path_.c_str(),
               name.c_str(), std::strerror(errno));
}

std::vector<uint8_t> CacheFolder::read(const std::string &name) const
{
    const Handle file(openat(number_, name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    struct stat facts = {};
    if (!file.is_open() || fstat(file.number(), &facts) != 0 || !S_ISREG(facts.st_mode)) return {};
    if (facts.st_uid != geteuid() || (facts.st_mode & others_may_write)) return {};
    const uint64_t size = static_cast<uint64_t>(facts.st_size);
    if (size > largest_entry) return {};
    std::vector<uint8_t> bytes(size);
    for (size_t have = 0; have < bytes.size();) {
        const ssize_t got =
            ::read(file.number(), bytes.data() + have, std::min<size_t>(bytes.size() - have, size_t(1) << 30));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return {};
        have += static_cast<size_t>(got);
    }
    return bytes;
}

void CacheFolder::write(const std::string &name, const std::vector<uint8_t> &bytes) const
{
    bool supported = false;
    if (write_nameless(number_, name, bytes, supported)) return;
    if (supported || !write_named(number_, name, bytes)) fail(name);
}

}  // namespace claque::asset
