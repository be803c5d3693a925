// URIs of glTF: data URIs, and paths relative to the file's folder. Everything else is refused.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace claque::asset
{

bool is_data_uri(std::string_view uri);

// The bytes of a data URI, base64 or percent-encoded. Throws base::Error (CLQ_FORMAT).
std::vector<uint8_t> decode_data_uri(std::string_view uri);

// An upper bound of the size of decode_data_uri's result.
uint64_t data_uri_bound(std::string_view uri);

// Returns a path below the folder, with percent-encoding decoded ('+' stays '+'). Throws base::Error: CLQ_UNSUPPORTED
// for other schemes (http:), CLQ_FORMAT for absolute paths, '..', backslashes and control characters.
std::string decode_relative_path(std::string_view uri);

}  // namespace claque::asset
