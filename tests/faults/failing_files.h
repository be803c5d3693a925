// File operations that fail on request: calls of this program for files below one folder share one countdown.
#pragma once

#include <cstdint>
#include <string>

namespace failing_files
{

enum class Operation { open, read, write, sync, rename, close, make_folder };
enum class How {
    error,      // the n-th operation fails with `error`
    for_good,   // and all later ones of its kind
    shortened,  // the n-th read or write does half of what was asked
    signal,     // before the n-th operation, which is then made, the signal `error` arrives
    none
};

struct Fault {
    Operation operation = Operation::open;
    uint64_t n = 0;
    How how = How::none;
    int error = 0;
    bool without_nameless = false;  // the file system has no O_TMPFILE
    bool without_exchange = false;  // nor RENAME_EXCHANGE
};

// `at_fault`, if any, is called when the fault is reached for the first time.
void arm(const std::string &folder, const Fault &fault, void (*at_fault)() = nullptr);
bool disarm();  // true: the fault was reached

}  // namespace failing_files
