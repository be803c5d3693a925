// A crowd's state as bytes and back, so that a host can record and replay: everything in crowd.h except callbacks,
// which the host supplies again. A header (base/file_header.h), whose hash is the crowd's, then templates by name and
// structure, mechanisms, paths, gaits, masks, groups, actors, attached objects. Rows are at the positions of their ids,
// and free rows in the order in which they will be reused. State without an id (attachments, commands, slots of
// colours) is written with its actor, wherever it is in memory, so equal states have equal bytes.
#pragma once

#include <string_view>

#include "lib/base/file_header.h"
#include "lib/crowd/crowd.h"

namespace claque::crowd
{

constexpr base::FileForm save_form = {{'c', 'l', 'a', 'q', 'u', 'e', 'C', 0x1a}, 6, "a saved crowd"};

using Writer = base::ArchiveWriter<>;
using Reader = base::ArchiveReader<>;

void save(const Crowd &crowd, base::Sink &sink);           // allocates nothing
void save_contents(const Crowd &crowd, base::Sink &sink);  // without the header

// A hash of what a saved crowd requires of a template: nodes, degrees of freedom, clips, zones and levels, with their
// names and sizes; not vertices and images.
uint64_t structure_hash(const model::Template &tmpl);

// Supplies what restoring needs and the bytes cannot hold.
class Resolver
{
public:
    virtual ~Resolver() = default;
    // The template of this name and structure; called once per template. Throws base::Error (CLQ_ARGUMENT).
    virtual const model::Template &find_template(std::string_view name, uint64_t structure) = 0;
    // Checks a description of any content and adds it to `out` as number `index`; a host mechanism comes without its
    // callback. Throws base::Error (CLQ_FORMAT; CLQ_ARGUMENT if the host supplies no callback).
    virtual void add(Behaviours &out, uint32_t index, Mechanism &&mechanism) = 0;
    virtual void add(Behaviours &out, uint32_t index, RootPath &&path) = 0;
};

// The bytes may have any content. `out` is empty before, and must be discarded after a throw. Allocations are
// proportional to the number of bytes. Throws base::Error (CLQ_FORMAT: truncated, changed, of another version, or an
// impossible state; or an error of the resolver) or std::bad_alloc.
void restore(const uint8_t *bytes, size_t size, Resolver &resolver, Crowd &out);

}  // namespace claque::crowd
