#include "samples/view/serve/server.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/select.h>
#include <sys/socket.h>
#include <unistd.h>

#include <arpa/inet.h>
#include <netdb.h>

#include "samples/scenes/check.h"

namespace view::serve
{
namespace
{

[[noreturn]] void fail(const Options &options, const char *doing)
{
    throw scenes::Failure("no window could be served at " + place_text(options.address, options.port) + ": " + doing +
                          ": " + std::strerror(errno));
}

Options with_password(Options options)
{
    if (options.password.empty()) options.password = make_password();
    const std::string wrong = wrong_password(options.password);
    if (!wrong.empty()) throw scenes::Failure("the password " + wrong);
    return options;
}

}  // namespace

Server::Server(Options options, const std::string &title, int width, int height, InputQueue &input)
    : given_{with_password(std::move(options)), title, width, height, board_, input, known_}
{
    for (auto &viewer : viewers_) viewer = std::make_unique<Viewer>(given_);
    viewers_[0]->greet_once();
    listen();
    for (auto &viewer : viewers_) viewer->start();
    thread_ = std::thread(&Server::accept_viewers, this);
}

Server::~Server()
{
    end_.reset();
    thread_.join();
}

void Server::listen()
{
    Options &options = given_.options;
    addrinfo hints = {}, *found = nullptr;
    hints.ai_flags = AI_NUMERICHOST | AI_NUMERICSERV;
    hints.ai_socktype = SOCK_STREAM;
    if (getaddrinfo(options.address.c_str(), std::to_string(options.port).c_str(), &hints, &found) != 0)
        throw scenes::Failure("'" + options.address + "' is no address of a machine, as 127.0.0.1 is");
    const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> list(found, freeaddrinfo);
    listening_ = Descriptor(socket(found->ai_family, SOCK_STREAM | SOCK_CLOEXEC, 0));
    const int socket = listening_.number();
    if (socket < 0) fail(options, "socket");
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    if (bind(socket, found->ai_addr, found->ai_addrlen) != 0) fail(options, "bind");
    if (::listen(socket, 8) != 0) fail(options, "listen");
    sockaddr_storage bound = {};
    socklen_t size = sizeof bound;
    if (getsockname(socket, reinterpret_cast<sockaddr *>(&bound), &size) != 0) fail(options, "getsockname");
    options.port = ntohs(bound.ss_family == AF_INET6 ? reinterpret_cast<const sockaddr_in6 *>(&bound)->sin6_port
                                                     : reinterpret_cast<const sockaddr_in *>(&bound)->sin_port);
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) fail(options, "pipe");
    ending_ = Descriptor(ends[0]), end_ = Descriptor(ends[1]);
}

void Server::accept_viewers()
{
    for (;;) {
        pollfd waiting[2] = {{ending_.number(), POLLIN, 0}, {listening_.number(), POLLIN, 0}};
        if (poll(waiting, 2, -1) < 0 && errno != EINTR) return;
        if (waiting[0].revents != 0) return;
        if ((waiting[1].revents & POLLIN) == 0) continue;
        const int socket = accept4(listening_.number(), nullptr, nullptr, SOCK_CLOEXEC);
        if (socket < 0) {
            poll(waiting, 1, 100);  // this process may have too many open files for a while
            continue;
        }
        // LibVNCServer keeps sockets in sets of FD_SETSIZE.
        if (socket >= FD_SETSIZE || known_ >= static_cast<int>(most_viewers) || !give_place(socket)) close(socket);
    }
}

// Gives a free place, or else the place of the longest wait for a password. Waiting connections lock no viewer out.
bool Server::give_place(int socket)
{
    for (auto &viewer : viewers_)
        if (viewer->take(socket)) return true;
    for (size_t tries = 0; tries < viewers_.size(); ++tries) {
        const auto longest = std::min_element(viewers_.begin(), viewers_.end(), [](const auto &a, const auto &b) {
            return a->waits_since() < b->waits_since();
        });
        if ((*longest)->take_from_waiting(socket)) return true;
    }
    return false;
}

void Server::show(std::vector<uint8_t> rgb)
{
    auto frame = std::make_shared<Frame>();
    frame->number = ++shown_;
    frame->rgb = std::move(rgb);
    board_.show(std::move(frame));
}

int Server::watching() const
{
    int count = 0;
    for (const auto &viewer : viewers_) count += viewer->watches();
    return count;
}

}  // namespace view::serve
