// A window served over VNC: it listens, and gives each viewer a place.
#pragma once

#include <array>

#include "samples/view/serve/descriptor.h"
#include "samples/view/serve/viewer.h"

namespace view::serve
{

constexpr size_t most_viewers = 8;
constexpr size_t waiting_places = 8;  // for those that have not given the password yet, besides

class Server
{
public:
    // Viewers' input goes into `input`. Throws scenes::Failure.
    Server(Options options, const std::string &title, int width, int height, InputQueue &input);
    ~Server();
    Server(const Server &) = delete;
    Server &operator=(const Server &) = delete;

    const std::string &password() const { return given_.options.password; }
    int port() const { return given_.options.port; }

    // Shows a picture to all: three bytes a pixel, top row first. Waits for no viewer.
    void show(std::vector<uint8_t> rgb);
    int watching() const;  // viewers that have given the password
    uint64_t frames_shown() const { return shown_; }
    uint64_t frames_sent(size_t place) const { return viewers_.at(place)->frames_sent(); }

private:
    void listen();
    void accept_viewers();
    bool give_place(int socket);

    Board board_;
    std::atomic<int> known_{0};  // viewers that have given the password
    Given given_;
    uint64_t shown_ = 0;
    Descriptor listening_, ending_, end_;  // closing end_ is seen at ending_
    std::array<std::unique_ptr<Viewer>, most_viewers + waiting_places> viewers_;
    std::thread thread_;
};

}  // namespace view::serve
