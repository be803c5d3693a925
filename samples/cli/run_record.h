// A record that takes its place when it is whole: it is written beside it until then.
#pragma once

#include <claque/record.h>

#include <cstdio>
#include <optional>
#include <string>

#include "samples/io/unfinished.h"

namespace cli
{

// "", or a sentence that says how a record is named.
std::string check_record_name(const std::string &name);

class RunRecord
{
public:
    explicit RunRecord(const std::string &path);
    ~RunRecord();
    RunRecord(const RunRecord &) = delete;
    RunRecord &operator=(const RunRecord &) = delete;

    void begin(clq_crowd *crowd);
    // Throws Failure; nothing is at the path then.
    clq_recording_info end();
    // For a crowd that was destroyed before the end: no record is kept of it.
    void forget_crowd() { crowd_ = nullptr; }

private:
    static int write(void *user, const void *bytes, size_t size);

    std::string path_, draft_;
    io::Unfinished unfinished_;
    std::FILE *file_;
    clq_crowd *crowd_ = nullptr;
    bool kept_ = false;
};

}  // namespace cli
