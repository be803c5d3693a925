// One line of progress, on a terminal only; a pipe or a log gets none.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace cli
{

class Progress
{
public:
    explicit Progress(std::string doing);
    ~Progress();  // leaves the line empty

    void phase(const std::string &what);
    void step(size_t done, size_t of);
    // Prints a last line that stays.
    void conclude(const std::string &sentence);

private:
    void show(const std::string &text, bool at_once);

    std::string doing_;
    bool terminal_;
    bool shown_ = false;
    std::chrono::steady_clock::time_point start_, last_;
};

// For work that says nothing of its steps: shows for how many seconds it has lasted, until this is destroyed.
class Waiting
{
public:
    explicit Waiting(const std::string &doing);
    ~Waiting();

private:
    std::mutex mutex_;
    std::condition_variable wake_;
    bool is_over_ = false;
    std::thread shows_;
};

}  // namespace cli
