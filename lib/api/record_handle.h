// The struct behind clq_record: its contents, and what the host has given to play them. Nothing of it changes while it
// is played.
#pragma once

#include <claque/record.h>

#include <mutex>

#include "lib/api/host_resolver.h"
#include "lib/api/track_handle.h"

struct clq_record {
    explicit clq_record(clq_context *owner)
        : context(owner),
          contents(&owner->memory),
          names(&owner->memory),
          templates(&owner->memory),
          tracks(&owner->memory),
          walks(&owner->memory),
          lent(&owner->memory)
    {
    }
    ~clq_record();

    clq_context *context;
    claque::record::Contents contents;
    clq_crowd_def crowd_def = clq_crowd_def_init();
    std::pmr::vector<std::pmr::string> names;    // of the templates
    std::pmr::vector<clq_template *> templates;  // by number; empty until they are given
    // By number. Of a record that is read in parts they are null until they are needed.
    mutable std::pmr::vector<clq_track *> tracks;
    mutable std::mutex making;                       // of those
    std::pmr::vector<const clq_locomotion *> walks;  // by number
    claque::api::LentMechanisms lent;
    uint64_t id = 0;  // of no other record of this process
};

namespace claque::api
{

// Makes the calls of a crowd's record up to a place. Throws base::Error; the crowd is then in a state between.
void play_to(const clq_record &played, clq_crowd *crowd, const record::Cursor &target);

// The track of a number, loaded, and held by the crowd. Throws base::Error.
const clq_track &borrow_track(const clq_record &played, clq_crowd *crowd, uint32_t number);

// Makes one call. Throws base::Error.
void apply(const clq_record &played, clq_crowd *crowd, const record::Entry &entry);

}  // namespace claque::api
