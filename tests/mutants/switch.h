// What run.py includes in each file that it changes: which mutant this process runs.
#pragma once

#include <cstdlib>

inline const unsigned long claque_mutant_chosen = [] {
    const char *id = std::getenv("CLAQUE_MUTANT");
    return id ? std::strtoul(id, nullptr, 10) : 0ul;
}();

inline bool claque_mutant(unsigned long id) { return claque_mutant_chosen == id; }
