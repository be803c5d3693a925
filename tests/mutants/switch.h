// What a changed file includes first: which mutant this process runs, and which of the random ones it reached.
#pragma once

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <unistd.h>

inline const unsigned long claque_mutant_chosen = [] {
    const char *id = std::getenv("CLAQUE_MUTANT");
    return id ? std::strtoul(id, nullptr, 10) : 0ul;
}();

// The file to which each process appends a line with each number that it reaches, at once, as it may end in any way.
inline const char *const claque_mutants_reached = std::getenv("CLAQUE_MUTANTS_REACHED");

inline void claque_mutant_is_reached(unsigned long id)
{
    static std::atomic<bool> told[4096];
    if (id >= 4096 || told[id].load(std::memory_order_relaxed) || told[id].exchange(true)) return;
    const int error = errno;
    char line[24];
    const int length = std::snprintf(line, sizeof line, "%lu\n", id);
    const int file = open(claque_mutants_reached, O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
    if (file >= 0) {
        if (write(file, line, size_t(length)) != length) std::perror(claque_mutants_reached);
        close(file);
    }
    errno = error;
}

inline bool claque_mutant(unsigned long id)
{
    if (claque_mutants_reached) claque_mutant_is_reached(id);
    return claque_mutant_chosen == id;
}
