// A claque command that runs while the test goes on: signals, its processor time, and how it ends.
#pragma once

#include <string>
#include <sys/types.h>
#include <vector>

namespace cli_test
{

using Words = std::vector<std::string>;

// How a command ended, and what it did after the signal that was to end it.
struct Ended {
    int state = 0;        // of waitpid
    double cpu_s = 0;     // of all its threads, since the signal
    double most_s = 0;    // what they may take: a tenth of a second on each processor that they can run on
    double wall_ms = 0;   // since the signal: for reports, since other programs change it
    bool killed = false;  // it took far more, or far too long, and was ended by SIGKILL
};

class Running
{
public:
    // out, err: file descriptors for its standard output and error; -1: /dev/null.
    explicit Running(const Words &words, int out = -1, int err = -1);
    ~Running();
    Running(const Running &) = delete;
    Running &operator=(const Running &) = delete;

    pid_t process() const { return child_; }
    bool has_ended();
    void send(int number) const;
    int wait_for_end();

    double cpu_s() const;                          // 0: it has ended
    std::vector<pid_t> threads() const;            // the main one first
    bool work_until(double cpu_s, double wall_s);  // whether it takes so much processor time, and has not ended

    // Stops the command, sends the signal to the process or to one of its threads, and lets it go on. What it then
    // takes depends little on the machine's load, unlike the time until it ends.
    Ended end_by(int number, pid_t thread = 0);

private:
    bool stop() const;
    bool is_over() const;  // ended, but not waited for

    pid_t child_ = 0;
    int state_ = 0;
};

}  // namespace cli_test
