// Preloaded into a program: its environment says which of its file operations fails (tests/faults/command_test.cpp).
//   CLAQUE_FAULT="FOLDER\nOPERATION N HOW ERROR WITHOUT_EXCHANGE": of the files below FOLDER; numbers but for that
//   CLAQUE_FAULT_REACHED=PATH: a file that is made when the fault is reached
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <sys/syscall.h>
#include <unistd.h>

#include "tests/faults/failing_files.h"

namespace
{

void note_the_fault()
{
    const char *path = std::getenv("CLAQUE_FAULT_REACHED");
    if (path) syscall(SYS_close, syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_CREAT, 0600));
}

__attribute__((constructor)) void arm_by_the_environment()
{
    const char *words = std::getenv("CLAQUE_FAULT");
    if (!words) return;
    const std::string text = words;
    const size_t line = text.find('\n');
    int operation = 0, how = 0, error = 0, without_exchange = 0;
    unsigned long long n = 0;
    if (line == std::string::npos ||
        std::sscanf(text.c_str() + line, "%d %llu %d %d %d", &operation, &n, &how, &error, &without_exchange) != 5)
        std::abort();
    failing_files::Fault fault;
    fault.operation = static_cast<failing_files::Operation>(operation), fault.n = n;
    fault.how = static_cast<failing_files::How>(how), fault.error = error;
    fault.without_exchange = without_exchange != 0;
    failing_files::arm(text.substr(0, line), fault, note_the_fault);
}

}  // namespace
