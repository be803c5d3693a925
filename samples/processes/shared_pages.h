// Memory that a process shares with the workers that it forks afterwards. It has no name, so nothing of it is left when
// the last of them has ended.
#pragma once

#include <cstddef>
#include <cstdint>

namespace processes
{

class SharedPages
{
public:
    // Zero at first; pages take memory when they are first written. Throws std::runtime_error.
    explicit SharedPages(size_t bytes);
    ~SharedPages();
    SharedPages(const SharedPages &) = delete;
    SharedPages &operator=(const SharedPages &) = delete;

    uint8_t *data() const { return data_; }
    size_t size() const { return bytes_; }

private:
    uint8_t *data_ = nullptr;
    size_t bytes_;
};

}  // namespace processes
