// A record as bytes. Little-endian on every machine:
//   8 bytes magic, u32 version, u32 zero; then blocks.
//   A block: u32 size of its contents, u32 check of this header and of the block's number, u64 checksum of the
//   contents; the contents are whole entries.
//   An entry: u32 size of what follows, u8 kind, its fields.
// A block that is not all there ends the record: what came before is played. A block that was changed, left out or
// moved is refused.
//
// Entries come in the order of the calls. Templates, locomotions and tracks are numbered from 0 in their order, and
// come before the first entry that names them. The first entry is the definition of the crowd, and a state comes
// before all calls.
//
// From version 2 on a record that was ended has an index (index.h) and its end in a last block of their own; the end
// says where that block is: its offset in 8 bytes, then its number in 4.
#pragma once

#include "lib/base/hash.h"

namespace claque::record
{

constexpr uint8_t magic[8] = {'c', 'l', 'a', 'q', 'u', 'e', 'R', 0x1a};
constexpr uint32_t version = 2, first_version = 1;
constexpr uint32_t file_header_bytes = 16, block_header_bytes = 16, entry_header_bytes = 5;
constexpr uint32_t max_locomotions = 256;  // each is measured before the record is played

// Numbers are never reused. Those from first_call on are calls of the C API.
enum class Kind : uint8_t {
    crowd_def = 1,
    tmpl = 2,
    locomotion = 3,
    track = 4,
    state = 5,      // replaces the crowd's state: where the record begins, and clq_crowd_restore
    key_state = 6,  // the same as the state that the calls before it lead to; only for seeking
    step = 7,       // clq_crowd_update
    end = 8,
    index = 9,
    first_call = 16,
    actor_create = 16,
    actor_destroy = 17,
    actor_clone = 18,
    actor_play = 19,
    actor_fade_to = 20,
    actor_set_gait_share = 21,
    actor_add_layer = 22,
    actor_end_layer = 23,
    actor_set_watched = 24,
    actor_colours = 25,  // however they were chosen
    actor_set_texture_set = 26,
    actor_set_priority = 27,
    actor_attach = 28,
    actor_detach = 29,
    actor_join = 30,
    actor_follow_track = 31,
    actor_fade_to_track = 32,
    actor_leave_track = 33,
    actor_attach_mechanism = 34,
    actor_detach_mechanism = 35,
    actor_gaze = 36,
    actor_express = 37,
    actor_say = 38,
    actor_play_root_path = 39,
    actor_follow_ground = 40,
    crowd_set_transforms = 41,
    crowd_add_mechanism = 42,
    crowd_add_root_path = 43,
    crowd_add_gait = 44,
    crowd_add_mask = 45,
    group_create = 46,
    group_destroy = 47,
    group_set_transform = 48,
    group_set_enabled = 49,
    crowd_set_speeds = 50,
    group_set_speed = 51,
    after_calls = 52
};

inline bool is_call(Kind kind) { return kind >= Kind::first_call && kind < Kind::after_calls; }

inline uint64_t checksum_of(const uint8_t *contents, uint32_t size, uint64_t number)
{
    return base::fnv_words(base::mix(base::fnv_start + number), contents, size);
}

inline uint32_t check_of_header(uint32_t size, uint64_t checksum, uint64_t number)
{
    return static_cast<uint32_t>(base::mix(base::mix(size + (number << 32) + 1) ^ checksum));
}

}  // namespace claque::record
