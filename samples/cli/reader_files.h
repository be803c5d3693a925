// Files for `claque bench readers`: each has a number of one countable element of its format, and little else.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cli
{

struct ReaderElement {
    const char *format, *element;
    uint32_t limit;  // the most that a file may have, and at most 100 000
    std::string (*make)(uint32_t count);
};

const std::vector<ReaderElement> &reader_elements();

}  // namespace cli
