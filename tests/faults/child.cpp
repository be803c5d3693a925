#include "tests/faults/child.h"

#include <cerrno>
#include <cstring>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

namespace faults
{

Told in_child(const std::function<std::string()> &work)
{
    int ends[2];
    if (pipe(ends) != 0) return {"", std::string("no pipe: ") + std::strerror(errno)};
    const pid_t child = fork();
    if (child < 0) return {"", std::string("no process: ") + std::strerror(errno)};
    if (child == 0) {
        close(ends[0]);
        std::string text;
        try {
            text = work();
        } catch (const std::exception &thrown) {  // an exception that left a call must not end in this program's main()
            text = std::string("E thrown: ") + thrown.what();
        }
        if (testing::Test::HasFailure()) text = "E a check failed, see above";
        for (size_t done = 0; done < text.size();) {
            const ssize_t wrote = write(ends[1], text.data() + done, text.size() - done);
            if (wrote <= 0) break;
            done += static_cast<size_t>(wrote);
        }
        _exit(0);
    }
    close(ends[1]);
    Told told;
    char piece[65536];
    for (ssize_t got; (got = read(ends[0], piece, sizeof piece)) != 0;) {
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) break;
        told.text.append(piece, static_cast<size_t>(got));
    }
    close(ends[0]);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    if (WIFSIGNALED(status)) told.end = std::string("ended by ") + strsignal(WTERMSIG(status));
    else if (WEXITSTATUS(status) != 0) told.end = "ended with " + std::to_string(WEXITSTATUS(status));
    return told;
}

}  // namespace faults
