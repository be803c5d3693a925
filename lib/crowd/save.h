// A crowd's state as bytes and back, so that a host can record and replay: everything that crowd.h keeps but the host's own
// callbacks, which stay with who lends them. Little-endian whatever the machine:
//   8 bytes magic, u32 version, u32 zero, u64 bytes that follow, u64 FNV-1a of them, which is the crowd's fingerprint;
//   then templates by name and structure, mechanisms, paths, gaits, masks, groups, actors, attached objects.
// Rows stand where their ids say, and free ones in the order in which they will be used again. What has no id (uses,
// commands, slots of colours) is written with its actor, wherever it lies in memory: equal states have equal bytes.
#pragma once

#include "lib/crowd/crowd.h"

#include <string_view>

namespace claque::crowd
{

constexpr uint8_t save_magic[8] = {'c', 'l', 'a', 'q', 'u', 'e', 'C', 0x1a};
constexpr uint32_t save_version = 3;

class Sink
{
public:
    virtual ~Sink() = default;
    virtual void take(const uint8_t *bytes, size_t count) = 0;  // in order; what it throws ends the saving
};

void save(const Crowd &crowd, Sink &sink);           // allocates nothing
void save_contents(const Crowd &crowd, Sink &sink);  // without what stands in front

// What a template must have for a saved crowd to fit it: nodes, degrees of freedom, clips, zones and levels, with their
// names and sizes; not where its vertices are or how it is painted.
uint64_t structure_hash(const model::Template &tmpl);

// What restoring needs and bytes cannot hold.
class Resolver
{
public:
    virtual ~Resolver() = default;
    // The template of this name and structure; another one at each call. Throws base::Error (CLQ_ARGUMENT).
    virtual const model::Template &find_template(std::string_view name, uint64_t structure) = 0;
    // Checks a description that may hold anything, and adds it to `out` as number `index`; a host's mechanism comes
    // without its callback. Throws base::Error (CLQ_FORMAT; CLQ_ARGUMENT where the host has no callback to lend).
    virtual void add(Behaviours &out, uint32_t index, Mechanism &&mechanism) = 0;
    virtual void add(Behaviours &out, uint32_t index, RootPath &&path) = 0;
};

// The bytes may be anything. `out` is empty and after a throw good for nothing but destruction. Memory is asked for in
// proportion to the bytes. Throws base::Error (CLQ_FORMAT: cut, changed, of another version, or no state that a crowd can
// be in; what the lender throws) or std::bad_alloc.
void restore(const uint8_t *bytes, size_t size, Resolver &resolver, Crowd &out);

}  // namespace claque::crowd
