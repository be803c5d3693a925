// The people of a record (docs/records.md), on a ground of their own and seen by cameras that the record does not have.
#pragma once

#include <claque/record.h>

#include "samples/io/mapped.h"
#include "samples/scenes/walkers/walkers.h"

namespace scenes::walkers
{

struct DestroyRecord {
    void operator()(clq_record *p) const { clq_record_destroy(p); }
};
using OwnRecord = std::unique_ptr<clq_record, DestroyRecord>;

struct ReplayOptions {
    std::string file;
    std::vector<SocialClass> characters;  // for templates that no built-in character has the name of
    std::string follow;                   // the number of the actor that the camera follows; empty: it stands
};

// A file and the record in it, which is read where it is played. Throws Failure.
struct RecordFile {
    RecordFile(Library &library, const std::string &file);
    io::Mapped bytes;
    OwnRecord record;
    clq_record_info info = clq_record_info_init();
};
bool is_record(const std::string &file);

// Times are those of the recorded run. Throws Failure.
std::unique_ptr<Scene> make_replay(Library &library, const CrowdOptions &crowd_options, const ReplayOptions &options);

}  // namespace scenes::walkers
