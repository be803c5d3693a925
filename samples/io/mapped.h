// A file as memory, of which the system reads what is looked at.
#pragma once

#include <cstddef>
#include <string>

namespace io
{

class Mapped
{
public:
    Mapped() = default;  // empty
    ~Mapped();
    Mapped(const Mapped &) = delete;
    Mapped &operator=(const Mapped &) = delete;

    // Once. Returns "" or a sentence, with the path and the reason. A file that gets shorter while it is mapped ends
    // the process where what is gone is looked at.
    std::string open(const std::string &path);

    const char *data() const { return data_; }
    size_t size() const { return size_; }

private:
    const char *data_ = "";
    size_t size_ = 0;
};

}  // namespace io
