#include "tests/faults/failing_files.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace
{

using failing_files::Fault;
using failing_files::How;
using failing_files::Operation;

char watched_folder[1024];
Fault fault;
bool armed = false, reached = false;
uint64_t seen = 0;
bool watched[1024];  // by file descriptor
void (*when_reached)() = nullptr;

template <class Function>
Function next(const char *name)
{
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

bool is_watched(int folder, const char *path)
{
    if (!armed) return false;
    if (path[0] != '/') return folder >= 0 && folder < 1024 && watched[folder];
    return std::strncmp(path, watched_folder, std::strlen(watched_folder)) == 0 ||
           std::strncmp(path, "/proc/self/fd/", 14) == 0;
}

bool is_watched(int file) { return armed && file >= 0 && file < 1024 && watched[file]; }

// What happens to this operation.
How outcome(Operation operation)
{
    if (operation != fault.operation || fault.how == How::none) return How::none;
    ++seen;
    const bool hit = seen == fault.n || (fault.how == How::for_good && seen > fault.n);
    if (!hit) return How::none;
    if (!reached && when_reached) when_reached();
    reached = true;
    if (fault.how == How::signal) {
        raise(fault.error);
        return How::none;
    }
    errno = fault.error;
    return fault.how;
}

bool fails(Operation operation)
{
    const How how = outcome(operation);
    return how == How::error || how == How::for_good;
}

int noted(int file)
{
    if (file >= 0 && file < 1024) watched[file] = true;
    return file;
}

int open_below(int folder, const char *path, int flags, unsigned mode)
{
    static const auto real = next<int (*)(int, const char *, int, ...)>("openat");
    if (!is_watched(folder, path)) return real(folder, path, flags, mode);
    if (fault.without_nameless && (flags & O_TMPFILE) == O_TMPFILE) return errno = EOPNOTSUPP, -1;
    if (fails(Operation::open)) return -1;
    return noted(real(folder, path, flags, mode));
}

unsigned mode_of(int flags, va_list arguments)
{
    return (flags & O_CREAT) || (flags & O_TMPFILE) == O_TMPFILE ? va_arg(arguments, unsigned) : 0;
}

}  // namespace

namespace failing_files
{

void arm(const std::string &folder, const Fault &wanted, void (*at_fault)())
{
    when_reached = at_fault;
    std::memcpy(watched_folder, folder.c_str(), std::min(folder.size() + 1, sizeof watched_folder - 1));
    std::fill(std::begin(watched), std::end(watched), false);
    fault = wanted, seen = 0, reached = false, armed = true;
}

bool disarm()
{
    armed = false;
    return reached;
}

}  // namespace failing_files

#pragma GCC visibility push(default)
extern "C" {

int open(const char *path, int flags, ...)
{
    va_list arguments;
    va_start(arguments, flags);
    const unsigned mode = mode_of(flags, arguments);
    va_end(arguments);
    return open_below(AT_FDCWD, path, flags, mode);
}

int openat(int folder, const char *path, int flags, ...)
{
    va_list arguments;
    va_start(arguments, flags);
    const unsigned mode = mode_of(flags, arguments);
    va_end(arguments);
    return open_below(folder, path, flags, mode);
}

int open64(const char *path, int flags, ...)
{
    va_list arguments;
    va_start(arguments, flags);
    const unsigned mode = mode_of(flags, arguments);
    va_end(arguments);
    return open_below(AT_FDCWD, path, flags, mode);
}

int openat64(int folder, const char *path, int flags, ...)
{
    va_list arguments;
    va_start(arguments, flags);
    const unsigned mode = mode_of(flags, arguments);
    va_end(arguments);
    return open_below(folder, path, flags, mode);
}

ssize_t read(int file, void *bytes, size_t count)
{
    static const auto real = next<ssize_t (*)(int, void *, size_t)>("read");
    if (!is_watched(file)) return real(file, bytes, count);
    const How how = outcome(Operation::read);
    if (how == How::error || how == How::for_good) return -1;
    return real(file, bytes, how == How::shortened ? (count + 1) / 2 : count);
}

ssize_t write(int file, const void *bytes, size_t count)
{
    static const auto real = next<ssize_t (*)(int, const void *, size_t)>("write");
    if (!is_watched(file)) return real(file, bytes, count);
    const How how = outcome(Operation::write);
    if (how == How::error || how == How::for_good) return -1;
    return real(file, bytes, how == How::shortened ? (count + 1) / 2 : count);
}

int fsync(int file)
{
    static const auto real = next<int (*)(int)>("fsync");
    return is_watched(file) && fails(Operation::sync) ? -1 : real(file);
}

int close(int file)
{
    static const auto real = next<int (*)(int)>("close");
    const bool ours = is_watched(file);
    if (file >= 0 && file < 1024) watched[file] = false;
    const int closed = real(file);
    return ours && fails(Operation::close) ? -1 : closed;
}

FILE *fopen(const char *path, const char *mode)
{
    static const auto real = next<FILE *(*)(const char *, const char *)>("fopen");
    return is_watched(AT_FDCWD, path) && fails(Operation::open) ? nullptr : real(path, mode);
}

FILE *fopen64(const char *path, const char *mode)
{
    static const auto real = next<FILE *(*)(const char *, const char *)>("fopen64");
    return is_watched(AT_FDCWD, path) && fails(Operation::open) ? nullptr : real(path, mode);
}

int mkdir(const char *path, mode_t mode) noexcept
{
    static const auto real = next<int (*)(const char *, mode_t)>("mkdir");
    return is_watched(AT_FDCWD, path) && fails(Operation::make_folder) ? -1 : real(path, mode);
}

int rename(const char *from, const char *to) noexcept
{
    static const auto real = next<int (*)(const char *, const char *)>("rename");
    return is_watched(AT_FDCWD, to) && fails(Operation::rename) ? -1 : real(from, to);
}

int renameat2(int from_folder, const char *from, int to_folder, const char *to, unsigned flags) noexcept
{
    static const auto real = next<int (*)(int, const char *, int, const char *, unsigned)>("renameat2");
    if (is_watched(to_folder, to)) {
        if (fault.without_exchange && (flags & RENAME_EXCHANGE)) return errno = EINVAL, -1;
        if (fails(Operation::rename)) return -1;
    }
    return real(from_folder, from, to_folder, to, flags);
}

int renameat(int from_folder, const char *from, int to_folder, const char *to) noexcept
{
    static const auto real = next<int (*)(int, const char *, int, const char *)>("renameat");
    return is_watched(to_folder, to) && fails(Operation::rename) ? -1 : real(from_folder, from, to_folder, to);
}

int linkat(int from_folder, const char *from, int to_folder, const char *to, int flags) noexcept
{
    static const auto real = next<int (*)(int, const char *, int, const char *, int)>("linkat");
    return is_watched(to_folder, to) && fails(Operation::rename) ? -1 : real(from_folder, from, to_folder, to, flags);
}

}  // extern "C"
#pragma GCC visibility pop
