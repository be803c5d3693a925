// Reads whole files into memory. Only regular files are read: a name from an untrusted file may be a folder, a pipe or
// a device.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace claque::asset
{

// Throws base::Error: CLQ_IO (missing, not readable, not a regular file), CLQ_LIMIT (larger than limit_bytes).
std::vector<uint8_t> read_file(const std::string &path, uint64_t limit_bytes);

}  // namespace claque::asset
