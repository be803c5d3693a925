// The floating-point settings that a host may have: rounding, flush to zero, precision and traps.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

namespace host_floats
{

struct Words {
    uint64_t control = 0, raised = 0;  // raised: flags of exceptions
    bool operator==(const Words &other) const { return control == other.control && raised == other.raised; }
    bool operator!=(const Words &other) const { return !(*this == other); }
};

Words now();  // of this thread
void set(const Words &wanted);

struct Setting {
    const char *name;
    Words words;
};

// Empty: this processor's settings are not known here.
const std::vector<Setting> &settings();

// A callback of a host under `expected`: notes what it meets, and computes as programs usually do.
class Callback
{
public:
    explicit Callback(const Words &expected);
    ~Callback() { set(found_); }
    Callback(const Callback &) = delete;
    Callback &operator=(const Callback &) = delete;

private:
    Words found_;
};

extern std::atomic<uint64_t> met, met_others;  // callbacks that met what they expected, and others

}  // namespace host_floats
