#include "tests/hosts/x_server.h"

#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdexcept>
#include <string>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace hosts_test
{
namespace
{

constexpr int longest_start_ms = 30000;

// The number that -displayfd writes, or "".
std::string read_number(int from)
{
    std::string text;
    for (pollfd ready = {from, POLLIN, 0}; poll(&ready, 1, longest_start_ms) > 0;) {
        char c = 0;
        if (read(from, &c, 1) != 1) return "";
        if (c == '\n') return text;
        text += c;
    }
    return "";
}

[[noreturn]] void become_server(int report)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // ends the server if a test crashes
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    const std::string number = std::to_string(report);
    execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "1024x768x24", "-nolisten", "tcp", "-noreset",
           static_cast<char *>(nullptr));
    _exit(127);
}

}  // namespace

// Only its absence is a reason to skip a test: an Xvfb that does not start fails it.
XServer::XServer()
{
    if (std::system("command -v Xvfb > /dev/null") != 0) {
        why_not_ = "no X server to run it in: Xvfb is not installed (Debian: xvfb)";
        return;
    }
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe for Xvfb");
    process_ = fork();
    if (process_ == 0) become_server(ends[1]);
    close(ends[1]);
    const std::string number = process_ > 0 ? read_number(ends[0]) : "";
    close(ends[0]);
    if (number.empty()) {
        if (process_ > 0) kill(process_, SIGKILL), waitpid(process_, nullptr, 0);
        throw std::runtime_error("Xvfb is installed and does not start");
    }
    setenv("DISPLAY", (":" + number).c_str(), 1);
}

XServer::~XServer()
{
    if (process_ <= 0) return;
    kill(process_, SIGTERM);
    waitpid(process_, nullptr, 0);
}

}  // namespace hosts_test
