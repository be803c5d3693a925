// An X server without a screen, for tests of programs that need one.
#pragma once

#include <string>
#include <sys/types.h>

namespace hosts_test
{

// Runs during this object's lifetime; sets DISPLAY.
class XServer
{
public:
    XServer();
    ~XServer();
    XServer(const XServer &) = delete;
    XServer &operator=(const XServer &) = delete;

    // Empty, or the reason why there is no server.
    const std::string &why_not() const { return why_not_; }

private:
    pid_t process_ = -1;
    std::string why_not_;
};

}  // namespace hosts_test
