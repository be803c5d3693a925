// A mapped file whose pages may vanish: it becomes shorter, or its disk fails. The system then sends SIGBUS to the
// thread that reads them. The handler here ends the command with a sentence and with 1, and removes what is unfinished.
#pragma once

#include <cstddef>
#include <string>

namespace io
{

// At most eight files at a time. Pages of further files, and other bus errors, end the command by the signal.
class WatchedPages
{
public:
    // Where the file of this path lies in memory, while this object exists.
    WatchedPages(const std::string &path, const char *data, size_t size);
    ~WatchedPages();
    WatchedPages(const WatchedPages &) = delete;
    WatchedPages &operator=(const WatchedPages &) = delete;

private:
    int slot_;  // -1: none is free, or the path is too long
};

}  // namespace io
