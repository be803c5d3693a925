// Work in a child process, so that each fault meets the same memory, and a crash is a result.
#pragma once

#include <functional>
#include <string>

namespace faults
{

struct Told {
    std::string text;  // what the work returned
    std::string end;   // "" if it returned, else how the child ended
};
Told in_child(const std::function<std::string()> &work);

}  // namespace faults
