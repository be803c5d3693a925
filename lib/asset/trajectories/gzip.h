// Unpacks gzip, piece by piece.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "lib/asset/budget.h"

namespace claque::asset
{

bool is_gzip(const uint8_t *bytes, size_t size);

// Hands over pieces until the data end or `take` returns false. What is handed over counts as input of the budget.
// Throws base::Error: CLQ_FORMAT (damaged, cut off), CLQ_LIMIT (200 times what the file holds, and 1 MB),
// CLQ_UNSUPPORTED (built without zlib).
void unpack(const uint8_t *bytes, size_t size, Budget &budget, const std::function<bool(std::string_view)> &take);

// All of it at once; charged.
std::vector<uint8_t> unpack_all(const uint8_t *bytes, size_t size, Budget &budget);

}  // namespace claque::asset
