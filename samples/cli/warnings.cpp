#include "samples/cli/warnings.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <iostream>
#include <new>
#include <unistd.h>

#include "samples/cli/terminal.h"
#include "samples/processes/shared_pages.h"
#include "samples/scenes/library.h"

namespace cli
{
namespace
{

// Hashes of what was printed, in pages that all processes of a command share. What finds no place is printed again.
using Printed = std::array<std::atomic<uint64_t>, 1024>;
Printed *printed = nullptr;
bool silent = false;

bool is_first(const std::string &sentence)
{
    uint64_t hash = 14695981039346656037u;  // FNV-1a
    for (const char c : sentence) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
    if (hash == 0) hash = 1;
    for (size_t i = 0; printed && i < printed->size(); ++i) {
        uint64_t found = 0;
        std::atomic<uint64_t> &place = (*printed)[(hash + i) % printed->size()];
        if (place.compare_exchange_strong(found, hash)) return true;
        if (found == hash) return false;
    }
    return true;
}

}  // namespace

void print_warnings()
{
    static const auto *const pages = new processes::SharedPages(sizeof(Printed));  // until the process has ended
    printed = new (pages->data()) Printed;                                         // of zeros
    scenes::Library::hear_warnings(print_warning);
}

void silence_warnings() { silent = true; }

void print_warning(const std::string &sentence)
{
    if (silent || !is_first(sentence)) return;
    if (isatty(STDERR_FILENO) == 1) std::fputs("\r\033[K", raw_errors());  // a line of progress
    std::cerr << "claque: warning: " + sentence + (sentence.empty() || sentence.back() == '.' ? "\n" : ".\n");
}

}  // namespace cli
