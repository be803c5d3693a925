#include "samples/view/serve/viewer.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <string_view>
#include <sys/socket.h>
#include <unistd.h>

#include <netinet/in.h>

#include "samples/scenes/check.h"
#include "samples/view/serve/origin.h"
#include "samples/view/serve/screen.h"

namespace view::serve
{
namespace
{

using Clock = std::chrono::steady_clock;

constexpr long poll_us = 5000;       // between two looks at the newest frame
constexpr int most_wait_ms = 30000;  // for a viewer that neither reads nor writes in the middle of a message

Clock::duration of_seconds(double seconds)
{
    return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

Viewer::Viewer(const Given &given)
    : given_(given),
      screen_(std::make_unique<Screen>(
          given, Screen::Told{[this](bool right) { return answer(right); }, [this] { ++frames_; }}))
{
}

Viewer::~Viewer()
{
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        ends_ = true;
        if (socket_again_.number() >= 0) shutdown(socket_again_.number(), SHUT_RDWR);
    }
    changed_.notify_all();
    if (thread_.joinable()) thread_.join();
    if (next_socket_ >= 0) close(next_socket_);
}

void Viewer::greet_once()
{
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    auto *at = reinterpret_cast<sockaddr *>(&address);
    socklen_t size = sizeof address;
    const Descriptor listening(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    const Descriptor greeting(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    const bool connected = bind(listening.number(), at, size) == 0 && listen(listening.number(), 1) == 0 &&
                           getsockname(listening.number(), at, &size) == 0 && connect(greeting.number(), at, size) == 0;
    const int socket = connected ? accept4(listening.number(), nullptr, nullptr, SOCK_CLOEXEC) : -1;
    if (socket < 0) throw scenes::Failure("no window could be served: this machine has no connection to itself");
    const Vnc &v = vnc();
    static const char version[] = "RFB 003.008\n";
    const rfbClientPtr client = v.rfbNewClient(screen_->info(), socket);
    if (!client || write(greeting.number(), version, sizeof version - 1) < 0)
        throw scenes::Failure("no window could be served: LibVNCServer takes no viewer");
    while (screen_->client() && client->state == rfbClientRec::RFB_PROTOCOL_VERSION)
        v.rfbProcessEvents(screen_->info(), poll_us);
    if (!screen_->client()) return;
    v.rfbCloseClient(client);
    v.rfbClientConnectionGone(client);
}

void Viewer::start() { thread_ = std::thread(&Viewer::run, this); }

bool Viewer::take(int socket)
{
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (busy_) return false;
        busy_ = true;
        next_socket_ = socket;
        taken_ = Clock::now();
    }
    changed_.notify_all();
    return true;
}

Clock::time_point Viewer::waits_since() const
{
    const std::lock_guard<std::mutex> lock(mutex_);
    return owes() ? taken_ : Clock::time_point::max();
}

bool Viewer::take_from_waiting(int socket)
{
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!owes()) return false;
        next_socket_ = socket;
        taken_ = Clock::now();
        if (socket_again_.number() >= 0) shutdown(socket_again_.number(), SHUT_RDWR);
    }
    changed_.notify_all();
    return true;
}

bool Viewer::has_to_leave() const
{
    const std::lock_guard<std::mutex> lock(mutex_);
    return ends_ || (next_socket_ >= 0 && !knows_);
}

// Eight letters are not guessed by a few tries in a second.
bool Viewer::answer(bool right)
{
    if (right) {
        knows_ = true;
        ++given_.known;
        return true;
    }
    refused_ = true;
    wait_for_end(given_.options.refusal_s);
    return false;
}

void Viewer::wait_for_end(double seconds)
{
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return ends_; });
}

void Viewer::run()
{
    // Writing to a viewer that has gone is an error of a call here, and no signal that ends the command.
    sigset_t pipe;
    sigemptyset(&pipe);
    sigaddset(&pipe, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipe, nullptr);
    for (;;) {
        int socket = -1;
        {
            std::unique_lock<std::mutex> lock(mutex_);
            changed_.wait(lock, [this] { return ends_ || next_socket_ >= 0; });
            if (ends_) return;
            std::swap(socket, next_socket_);
            socket_again_ = Descriptor(fcntl(socket, F_DUPFD_CLOEXEC, 0));
        }
        serve(socket);
        const std::lock_guard<std::mutex> lock(mutex_);
        socket_again_.reset();
        busy_ = next_socket_ >= 0;
    }
}

// What a browser says before the library sees it. Returns false where it is the page of another host.
bool Viewer::lets_in(int socket, Clock::time_point deadline, bool &asked) const
{
    constexpr int library_ms = 100;  // for which the library itself waits for a browser's request
    constexpr size_t most = 4096;    // that it reads of one
    pollfd waiting = {socket, POLLIN, 0};
    poll(&waiting, 1, library_ms);
    for (std::string said(most, 0);;) {
        const ssize_t size = recv(socket, said.data(), most, MSG_PEEK | MSG_DONTWAIT);
        const std::string_view head(said.data(), static_cast<size_t>(std::max<ssize_t>(size, 0)));
        asked = !head.empty() && std::string_view("GET ").substr(0, head.size()) == head.substr(0, 4);
        if (!asked) return true;
        if (head.find("\r\n\r\n") != std::string_view::npos)
            return origin_is_allowed(std::string(head), given_.options.origins);
        if (has_to_leave() || head.size() == most || Clock::now() > deadline) return false;
        std::this_thread::sleep_for(std::chrono::microseconds(poll_us));
    }
}

void Viewer::serve(int socket)
{
    const Clock::time_point start = Clock::now(), deadline = start + of_seconds(given_.options.handshake_s);
    bool asked = false;
    if (!lets_in(socket, deadline, asked)) {
        static const char no[] = "HTTP/1.1 403 Forbidden\r\nConnection: close\r\n\r\n";
        send(socket, no, sizeof no - 1, MSG_NOSIGNAL | MSG_DONTWAIT);
        close(socket);
        return;
    }
    const Vnc &v = vnc();
    Screen &screen = *screen_;
    screen.begin();
    const auto handshake_ms = static_cast<int>(std::clamp(given_.options.handshake_s * 1000, 1.0, 1e6));
    screen.info()->maxClientWait = handshake_ms;
    // The library owns the socket from here on, also where it refuses.
    v.rfbNewClient(screen.info(), socket);
    while (rfbClientPtr client = screen.client()) {
        watches_ = client->state == rfbClientRec::RFB_NORMAL;
        const bool types = client->state == rfbClientRec::RFB_AUTHENTICATION;
        const bool late = !watches_ && Clock::now() > (types ? start + of_seconds(given_.options.typing_s) : deadline);
        // A browser sent its request late, so the origin of its page was not checked.
        if (has_to_leave() || late || (client->wsctx && !asked)) {
            v.rfbCloseClient(client);
            v.rfbClientConnectionGone(client);
            break;
        }
        screen.info()->maxClientWait = watches_ ? most_wait_ms : handshake_ms;
        screen.follow();
        v.rfbProcessEvents(screen.info(), poll_us);
    }
    screen.end();
    watches_ = false, refused_ = false;
    if (knows_.exchange(false)) --given_.known;
}

}  // namespace view::serve
