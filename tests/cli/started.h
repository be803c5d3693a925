// The claque command while it runs, for tests that send signals to it or to its workers.
#pragma once

#include <string>
#include <sys/types.h>
#include <vector>

namespace cli_test
{

// Starts the command in a process group of its own, as a shell does. 0: it could not be started, and the test fails.
pid_t start_claque(const std::vector<std::string> &arguments);

std::vector<pid_t> children_of(pid_t process);

}  // namespace cli_test
