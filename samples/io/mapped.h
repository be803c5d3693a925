// A file as memory, of which the system reads what is looked at.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "samples/io/watched_pages.h"

namespace io
{

class Mapped
{
public:
    Mapped() = default;  // empty
    ~Mapped();
    Mapped(const Mapped &) = delete;
    Mapped &operator=(const Mapped &) = delete;

    // Once. Returns "" or a sentence, with the path and the reason. What cannot be read later, because the file became
    // shorter or its disk failed, ends the process with a sentence and with 1; what is unfinished is removed.
    std::string open(const std::string &path);

    const char *data() const { return data_; }
    size_t size() const { return size_; }

private:
    const char *data_ = "";
    size_t size_ = 0;
    std::optional<WatchedPages> pages_;
};

}  // namespace io
