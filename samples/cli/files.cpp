#include "samples/cli/files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "samples/io/unfinished.h"
#include "samples/scenes/check.h"

namespace cli
{
namespace
{

[[noreturn]] void fail(const std::string &path, const char *doing)
{
    throw scenes::Failure(path + " could not be " + doing + ": " + std::strerror(errno));
}

std::string folder_of(const std::string &path)
{
    const size_t slash = path.find_last_of('/');
    return slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
}

// A temporary file that is removed unless it is kept.
class Draft
{
public:
    explicit Draft(const std::string &path)
        : path_(path), draft_(path + ".part" + std::to_string(getpid())), unfinished_(draft_)
    {
        unlink(draft_.c_str());  // of a process that was killed
        file_ = open(draft_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
        if (file_ < 0) fail(path_, "written");
    }
    ~Draft()
    {
        if (file_ >= 0) close(file_);
        if (!kept_) unlink(draft_.c_str());
    }
    Draft(const Draft &) = delete;
    Draft &operator=(const Draft &) = delete;

    void write(const void *bytes, size_t size_bytes)
    {
        const char *at = static_cast<const char *>(bytes);
        while (size_bytes > 0) {
            const ssize_t wrote = ::write(file_, at, size_bytes);
            if (wrote < 0 && errno == EINTR) continue;
            if (wrote <= 0) fail(path_, "written");
            at += wrote;
            size_bytes -= static_cast<size_t>(wrote);
        }
    }
    void keep()
    {
        const int closed = close(file_);
        file_ = -1;
        if (closed != 0 || std::rename(draft_.c_str(), path_.c_str()) != 0) fail(path_, "written");
        kept_ = true;
    }

private:
    std::string path_, draft_;
    io::Unfinished unfinished_;
    int file_ = -1;
    bool kept_ = false;
};

void write_to_stdout(const void *bytes, size_t size_bytes)
{
    if (std::fwrite(bytes, 1, size_bytes, stdout) != size_bytes || std::fflush(stdout) != 0)
        fail("standard output", "written");
}

bool is_device(const std::string &path)
{
    struct stat there = {};
    return stat(path.c_str(), &there) == 0 && !S_ISREG(there.st_mode) && !S_ISDIR(there.st_mode);
}

}  // namespace

std::vector<unsigned char> read_file(const std::string &path)
{
    struct Close {
        void operator()(std::FILE *file) const { std::fclose(file); }
    };
    const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rb"));
    if (!file) fail(path, "opened");
    std::vector<unsigned char> bytes;
    unsigned char piece[65536];
    for (size_t got; (got = std::fread(piece, 1, sizeof piece, file.get())) > 0;)
        bytes.insert(bytes.end(), piece, piece + got);
    if (std::ferror(file.get())) fail(path, "read");
    return bytes;
}

std::string text_of(const std::string &path)
{
    const std::vector<unsigned char> bytes = read_file(path);
    return std::string(bytes.begin(), bytes.end());
}

void write_whole(const std::string &path, const void *bytes, size_t size_bytes)
{
    if (path == "-") return write_to_stdout(bytes, size_bytes);
    if (is_device(path)) {  // /dev/null and pipes are written, never replaced
        const std::unique_ptr<std::FILE, int (*)(std::FILE *)> file(std::fopen(path.c_str(), "wb"), std::fclose);
        if (!file || std::fwrite(bytes, 1, size_bytes, file.get()) != size_bytes || std::fflush(file.get()) != 0)
            fail(path, "written");
        return;
    }
    Draft draft(path);
    draft.write(bytes, size_bytes);
    draft.keep();
}

void write_whole(const std::string &path, const std::string &text) { write_whole(path, text.data(), text.size()); }

void expect_writable(const std::string &path)
{
    if (path == "-") return;
    struct stat there = {};
    if (stat(path.c_str(), &there) == 0 && S_ISDIR(there.st_mode)) {
        errno = EISDIR;
        fail(path, "written");
    }
    const std::string folder = folder_of(path);
    if (stat(folder.c_str(), &there) == 0 && !S_ISDIR(there.st_mode))
        throw scenes::Failure(path + " could not be written: " + folder + " is not a folder");
    if (access(folder.c_str(), W_OK | X_OK) != 0) fail(path, "written");
}

}  // namespace cli
