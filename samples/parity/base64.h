// Bytes as text, for pages that contain their own pictures (RFC 4648).
#pragma once

#include <string>
#include <vector>

namespace parity
{

std::string base64(const std::vector<unsigned char> &bytes);

}  // namespace parity
