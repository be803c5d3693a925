// Tracks as bytes: a header (base/file_header.h), the locomotion's hash, and the members of Track in their order.
#pragma once

#include "lib/track/track.h"

namespace claque::track
{

// A track whose feet stand on ground of known height has one more section, and the next version.
constexpr uint32_t track_file_version = 5, climbing_file_version = 6;

// Of what was measured: a track is shown by the locomotion that it was made for, or by an equal one.
uint64_t hash_of(const Locomotion &locomotion);

// Appends to `out`. Throws std::bad_alloc.
void save(const Track &track, Array<uint8_t> &out);

// The bytes may be anything. `out` is empty before, and must be discarded after a throw. Allocates no more than the
// bytes can fill. Throws base::Error (FORMAT; ARGUMENT: another locomotion) or std::bad_alloc.
void load(const uint8_t *bytes, size_t size, const Locomotion &locomotion, Track &out);

}  // namespace claque::track
