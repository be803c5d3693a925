// PNG files for tests: grey, one zlib stream of stored or fixed-code blocks.
#pragma once

#include "maker.h"

namespace claque::testing
{

// A grey PNG of `depth` bits whose data is `row` (filter byte first) repeated `rows` times, packed as well as a deflate
// stream of fixed codes can: a row of equal bytes costs a bit for about every 30 bytes.
Bytes make_png(uint32_t width, uint32_t height, uint8_t depth, const Bytes &row, size_t rows);

}  // namespace claque::testing
