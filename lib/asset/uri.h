// URIs as glTF uses them: data URIs, and paths relative to the file's folder. Anything else is refused.
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

// How many bytes decode_data_uri gives at most.
uint64_t data_uri_bound(std::string_view uri);

// A path below the folder, percent-encoding decoded ('+' stays '+'). Throws base::Error: CLQ_UNSUPPORTED for other
// schemes (http:), CLQ_FORMAT for absolute paths, '..', backslashes and control characters.
std::string decode_relative_path(std::string_view uri);

}  // namespace claque::asset
