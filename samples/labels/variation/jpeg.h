// What compression makes of a picture.
#pragma once

#include <cstdint>
#include <vector>

namespace labels
{

// Whether this build can, which needs the writer of the stb package.
bool can_compress();

// The picture as it is after JPEG of this quality, [1, 100]. Throws scenes::Failure.
void compress(std::vector<uint8_t> &rgb, int width, int height, int quality);

}  // namespace labels
