// The ways in which an operation on a file fails.
#pragma once

#include <cerrno>

#include "tests/faults/failing_files.h"

namespace command_faults
{

using failing_files::How;
using failing_files::Operation;

struct Kind {
    const char *name;
    Operation operation;
    How how;
    int error;
    bool is_fault;  // false: the command has to go on as if nothing had been
};

constexpr Kind kinds[] = {{"open", Operation::open, How::error, EIO, true},
                          {"open, no descriptors", Operation::open, How::for_good, EMFILE, true},
                          {"read", Operation::read, How::error, EIO, true},
                          {"read, interrupted", Operation::read, How::error, EINTR, false},
                          {"read, short", Operation::read, How::shortened, 0, false},
                          {"write", Operation::write, How::error, EIO, true},
                          {"write, disk full", Operation::write, How::for_good, ENOSPC, true},
                          {"write, interrupted", Operation::write, How::error, EINTR, false},
                          {"write, short", Operation::write, How::shortened, 0, false},
                          {"fsync", Operation::sync, How::error, EIO, true},
                          {"rename", Operation::rename, How::error, EIO, true},
                          {"rename, disk full", Operation::rename, How::for_good, ENOSPC, true},
                          {"close", Operation::close, How::error, EIO, false},
                          {"mkdir", Operation::make_folder, How::error, EIO, true}};

}  // namespace command_faults
