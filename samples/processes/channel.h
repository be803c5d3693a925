// Messages between two processes over one end of a socket: texts with their length in front.
#pragma once

#include <cstdint>
#include <string>

namespace processes
{

class Channel
{
public:
    explicit Channel(int socket = -1) : socket_(socket) {}
    ~Channel() { close(); }
    Channel(Channel &&other) noexcept : socket_(other.socket_) { other.socket_ = -1; }
    Channel &operator=(Channel &&other) noexcept;

    // Of a message.
    static constexpr uint32_t max_bytes = 1u << 30;

    // Both wait. They return false if the other process has ended or closed its end; a part of a message counts as
    // none.
    bool send(const std::string &message);
    bool receive(std::string &message);

    int socket() const { return socket_; }
    bool is_open() const { return socket_ >= 0; }
    void close();

private:
    int socket_;
};

}  // namespace processes
