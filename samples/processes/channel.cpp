#include "samples/processes/channel.h"

#include <cerrno>
#include <sys/socket.h>
#include <unistd.h>
#include <utility>

namespace processes
{
namespace
{

// MSG_NOSIGNAL: a process that ended must not end this one by SIGPIPE.
bool put(int socket, const char *bytes, size_t size)
{
    while (size > 0) {
        const ssize_t sent = ::send(socket, bytes, size, MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) return false;
        bytes += sent, size -= static_cast<size_t>(sent);
    }
    return true;
}

bool take(int socket, char *bytes, size_t size)
{
    while (size > 0) {
        const ssize_t got = ::recv(socket, bytes, size, 0);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        bytes += got, size -= static_cast<size_t>(got);
    }
    return true;
}

}  // namespace

Channel &Channel::operator=(Channel &&other) noexcept
{
    if (this != &other) close(), socket_ = std::exchange(other.socket_, -1);
    return *this;
}

bool Channel::send(const std::string &message)
{
    const uint32_t size = static_cast<uint32_t>(message.size());
    return message.size() <= max_bytes && put(socket_, reinterpret_cast<const char *>(&size), sizeof size) &&
           put(socket_, message.data(), message.size());
}

bool Channel::receive(std::string &message)
{
    uint32_t size = 0;
    if (!take(socket_, reinterpret_cast<char *>(&size), sizeof size) || size > max_bytes) return false;
    message.resize(size);
    return take(socket_, message.data(), size);
}

void Channel::close()
{
    if (socket_ >= 0) ::close(std::exchange(socket_, -1));
}

}  // namespace processes
