// One place for a viewer of a served window: a thread of its own that talks to one viewer after another. LibVNCServer
// waits where a connection is slow, and here only this viewer waits for it.
#pragma once

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "samples/view/input_queue.h"
#include "samples/view/serve/board.h"
#include "samples/view/serve/descriptor.h"
#include "samples/view/serve/options.h"

namespace view::serve
{

struct Given {
    Options options;
    std::string title;
    int width = 0, height = 0;
    const Board &board;
    InputQueue &input;
};

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

    bool watches() const { return watches_; }         // has given the password
    uint64_t frames_sent() const { return frames_; }  // since the beginning

private:
    struct Screen;
    void run();
    void serve(int socket);
    void wait_for_end(double seconds);

    const Given &given_;
    std::unique_ptr<Screen> screen_;
    std::mutex mutex_;
    std::condition_variable changed_;
    int next_socket_ = -1;     // waits to be served
    Descriptor socket_again_;  // a second number of the socket that is served
    bool busy_ = false, ends_ = false;
    std::atomic<bool> watches_{false};
    std::atomic<uint64_t> frames_{0};
    std::thread thread_;
};

}  // namespace view::serve
