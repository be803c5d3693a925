// Compressed files that hold much in few bytes: a wavy sheet of about `count` triangles by each library, and a picture.
#pragma once

#include "../asset/maker.h"

namespace claque::testing
{

struct PackedFile {
    Bytes bytes;
    uint64_t unpacked = 0;  // bytes that come out of compression; texels are not among them
};

// Empty where this build lacks the library.
PackedFile meshopt_sheet(size_t count);
// `spare`: numbers that every vertex has besides and that the file asks for nowhere.
PackedFile draco_sheet(size_t count, bool edgebreaker, size_t spare = 0);
PackedFile webp_square(uint32_t side);

}  // namespace claque::testing
