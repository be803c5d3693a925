// A record on disk, and the characters that its names mean.
#pragma once

#include <claque/record.h>

#include <string>
#include <vector>

#include "samples/io/mapped.h"
#include "samples/scenes/walkers/cast.h"

namespace scenes::walkers
{

struct DestroyRecord {
    void operator()(clq_record *p) const { clq_record_destroy(p); }
};
using OwnRecord = std::unique_ptr<clq_record, DestroyRecord>;

// A file and the record in it, which is read where it is played. Throws Failure.
struct RecordFile {
    RecordFile(Library &library, const std::string &file);
    io::Mapped bytes;
    OwnRecord record;
    clq_record_info info = clq_record_info_init();
};
bool is_record(const std::string &file);

// Gives a record the characters of its names: built-in ones, with levels of detail where it was recorded with them and
// with heads that turn where people decided, and those of the user. Throws Failure.
class RecordCast
{
public:
    RecordCast(Library &library, const RecordFile &file, const std::vector<SocialClass> &characters);
    const std::vector<clq_template *> &templates() const { return templates_; }

private:
    clq_status give(clq_record *record) const;

    std::vector<Own<clq_template>> own_;
    std::vector<clq_template *> templates_;
};

}  // namespace scenes::walkers
