// Whole files. Interrupted and short operations are continued; an error is a sentence with the path and the system's
// reason, and no error is "".
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "samples/io/regular_file.h"

namespace io
{

// Reads a regular file. `bytes` is then empty, or the whole file.
std::string read_whole(const std::string &path, std::string &bytes, uint64_t most_bytes = most_text_bytes);

// The same, without holding more than a piece of 64 KiB. A signal ends a process later the more memory it holds: the
// system gives back about 10 MB in a millisecond.
std::string read_in_pieces(const std::string &path, uint64_t most_bytes,
                           const std::function<void(const char *piece, size_t size)> &take);

// Makes the file `draft`, which must not be there, to take the place of `path`: it has the owner and the mode of a file
// that is there. Returns its descriptor, or -1 with errno.
int open_draft(const std::string &draft, const std::string &path);

// Writes a draft, waits until it is on the disk, and renames it to `path` where it takes that place. A draft that could
// not be completed is removed. The sentence names `path`.
std::string write_new(const std::string &draft, const std::string &path, const void *bytes, size_t size_bytes,
                      bool takes_place);

// The place where a file or folder is made before it is moved to `path`: beside it, and of this process.
std::string draft_of(const std::string &path);

// Removes the drafts in a folder that no process writes: those of processes that were killed.
void remove_abandoned_drafts(const std::string &folder);

// "PATH could not be DOING: REASON", the reason of errno.
std::string why(const std::string &path, const char *doing);
std::string too_long(const std::string &path, uint64_t most_bytes);

}  // namespace io
