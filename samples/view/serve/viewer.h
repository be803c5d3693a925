// One place for a viewer of a served window: a thread of its own that talks to one viewer after another. LibVNCServer
// waits where a connection is slow, and here only this viewer waits for it.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "samples/view/serve/descriptor.h"
#include "samples/view/serve/given.h"

namespace view::serve
{

class Screen;

class Viewer
{
public:
    explicit Viewer(const Given &given);
    ~Viewer();
    Viewer(const Viewer &) = delete;
    Viewer &operator=(const Viewer &) = delete;

    // The library's lists of what it offers are made by the first greeting and only read by later ones; this greets it
    // before there are threads. Of one viewer of the process.
    void greet_once();
    void start();
    // Takes over a connection. Returns false where the place is taken.
    bool take(int socket);
    // Since when its connection owes the password; the end of time where it owes none.
    std::chrono::steady_clock::time_point waits_since() const;
    // Takes over a connection in place of one that owes the password. Returns false where none does. One that gave a
    // wrong password stays until it is told: tries are not to be quicker for being many.
    bool take_from_waiting(int socket);

    bool watches() const { return watches_; }         // has given the password
    uint64_t frames_sent() const { return frames_; }  // since the beginning

private:
    bool answer(bool right);
    void run();
    bool lets_in(int socket, std::chrono::steady_clock::time_point deadline, bool &asked) const;
    void serve(int socket);
    void wait_for_end(double seconds);
    bool has_to_leave() const;
    bool owes() const { return busy_ && next_socket_ < 0 && !knows_ && !refused_; }

    const Given &given_;
    std::unique_ptr<Screen> screen_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::chrono::steady_clock::time_point taken_;
    int next_socket_ = -1;     // waits to be served
    Descriptor socket_again_;  // a second number of the socket that is served
    bool busy_ = false, ends_ = false;
    std::atomic<bool> knows_{false}, refused_{false};  // the password was right; was wrong
    std::atomic<bool> watches_{false};
    std::atomic<uint64_t> frames_{0};
    std::thread thread_;
};

}  // namespace view::serve
