// Complete files: read at once; written beside their destination and renamed into it, so that a reader sees all or
// nothing.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "samples/io/regular_file.h"

namespace cli
{

// Throws scenes::Failure, naming the path and the system's reason.
std::vector<unsigned char> read_file(const std::string &path);
std::string text_of(const std::string &path);

// `path` "-" is standard output. An existing file stays as it was unless the write succeeds.
void write_whole(const std::string &path, const void *bytes, size_t size_bytes);
void write_whole(const std::string &path, const std::string &text);

// Fails early where read_file would fail late.
void expect_readable(const std::string &path, uint64_t most_bytes = io::most_file_bytes);

// Fails early where write_whole would fail late: the folder of `path` must exist and be writable.
void expect_writable(const std::string &path);

}  // namespace cli
