#include "lib/asset/cache_folder.h"

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

// Makes missing folders, each for its owner alone. Reports nothing: opening the folder does.
const std::string &made(const std::string &path)
{
    for (size_t slash = path.find('/', 1); slash != std::string::npos; slash = path.find('/', slash + 1))
        mkdir(path.substr(0, slash).c_str(), 0700);
    mkdir(path.c_str(), 0700);
    return path;
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
// system has none.
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

CacheFolder::CacheFolder(const std::string &path)
    : folder_(made(path), Owners{geteuid(), geteuid(), "name another folder"})
{
}

void CacheFolder::write(const std::string &name, const std::vector<uint8_t> &bytes) const
{
    bool supported = false;
    if (write_nameless(folder_.number(), name, bytes, supported)) return;
    if (supported || !write_named(folder_.number(), name, bytes))
        base::fail(CLQ_IO, "'%s/%s' cannot be written: %s; repair that, or name another folder", folder_.path().c_str(),
                   name.c_str(), std::strerror(errno));
}

}  // namespace claque::asset
