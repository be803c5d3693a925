#include "samples/cli/files.h"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <sys/stat.h>
#include <unistd.h>

#include "samples/cli/terminal.h"
#include "samples/io/files.h"
#include "samples/io/unfinished.h"
#include "samples/scenes/check.h"

namespace cli
{
namespace
{

[[noreturn]] void fail(const std::string &path, const char *doing) { throw scenes::Failure(io::why(path, doing)); }

std::string folder_of(const std::string &path)
{
    const size_t slash = path.find_last_of('/');
    return slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
}

void write_to_stdout(const void *bytes, size_t size_bytes)
{
    std::fflush(stdout);
    if (std::fwrite(bytes, 1, size_bytes, raw_output()) != size_bytes || std::fflush(raw_output()) != 0)
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
    std::vector<unsigned char> bytes;
    const std::string wrong = io::read_in_pieces(path, io::most_file_bytes, [&](const char *piece, size_t size) {
        bytes.insert(bytes.end(), piece, piece + size);
    });
    if (!wrong.empty()) throw scenes::Failure(wrong);
    return bytes;
}

std::string text_of(const std::string &path)
{
    std::string bytes;
    const std::string wrong = io::read_whole(path, bytes);
    if (!wrong.empty()) throw scenes::Failure(wrong);
    return bytes;
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
    const std::string draft = io::draft_of(path);
    const io::Unfinished unfinished(draft);
    unlink(draft.c_str());  // of a process that was killed
    const std::string wrong = io::write_new(draft, path, bytes, size_bytes, true);
    if (!wrong.empty()) throw scenes::Failure(wrong);
}

void write_whole(const std::string &path, const std::string &text) { write_whole(path, text.data(), text.size()); }

void expect_readable(const std::string &path, uint64_t most_bytes)
{
    const io::RegularFile file(path, most_bytes);
    if (!file.wrong().empty()) throw scenes::Failure(file.wrong());
}

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
