// Reads BVH, the usual format of motion capture: a skeleton of offsets and one clip. The result is a Model without
// parts. The bytes may be anything.
//
// The channels of a joint apply in the order of the file, from left to right as matrices. Position channels replace the
// joint's offset, as exporters that write them for every joint intend; root joints mostly have a zero offset, so there
// it makes no difference. An End Site becomes a node named after its joint with " end" appended.
#pragma once

#include "lib/asset/gltf.h"

namespace claque::asset
{

// True if the bytes begin like a BVH file: the word HIERARCHY, after blanks and lines that begin with #. The text may
// be UTF-16 with a byte order mark.
bool is_bvh(const uint8_t *bytes, size_t size);

// Of the options, motion_unit_m and memory_limit_bytes are used. The clip is called "motion". Throws base::Error
// (CLQ_FORMAT, CLQ_LIMIT) with the line number, and std::bad_alloc. A file with no frames or with a repeated joint name
// loads with a warning.
model::Model load_bvh(const uint8_t *bytes, size_t size, const LoadOptions &options);

}  // namespace claque::asset
