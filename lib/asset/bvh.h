// BVH, the format that motion capture comes in: a skeleton of offsets and one clip over it, to a Model without parts.
// The bytes may be anything.
//
// A joint's channels act in the order that the file lists them, from left to right as matrices. Position channels stand
// in the place of the joint's offset, as the exporters that write them for every joint mean it; roots have mostly no
// offset, so that it makes no difference there. An End Site becomes a node named after its joint with " end".
#pragma once

#include "lib/asset/gltf.h"

namespace claque::asset
{

// Whether the bytes begin like a BVH file: the word HIERARCHY, after blanks.
bool is_bvh(const uint8_t *bytes, size_t size);

// Takes motion_unit_m and memory_limit_bytes of the options. The one clip is called "motion".
// Throws base::Error, with the number of the line: CLQ_FORMAT, CLQ_LIMIT; and std::bad_alloc. A file that says it has no
// frames, or repeats a joint's name, loads with a warning.
model::Model load_bvh(const uint8_t *bytes, size_t size, const LoadOptions &options);

}  // namespace claque::asset
