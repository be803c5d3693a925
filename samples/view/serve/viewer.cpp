#include "samples/view/serve/viewer.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <netinet/in.h>

#include "samples/scenes/check.h"
#include "samples/view/serve/keys.h"
#include "samples/view/serve/vnc.h"

namespace view::serve
{
namespace
{

using Clock = std::chrono::steady_clock;

constexpr long poll_us = 5000;       // between two looks at the newest frame
constexpr int most_wait_ms = 30000;  // for a viewer that neither reads nor writes in the middle of a message
constexpr size_t tile = 64;          // pixels on a side: what differs is sent by tiles

// An arrow; a viewer that draws no cursor gets it in the picture.
rfbCursorPtr arrow()
{
    static char dark[] =
        "x       "
        "xx      "
        "x x     "
        "x  x    "
        "x   x   "
        "x    x  "
        "x xxxxx "
        "xx      "
        "x       ";
    static char inside[] =
        "x       "
        "xx      "
        "xxx     "
        "xxxx    "
        "xxxxx   "
        "xxxxxx  "
        "xxxxxxx "
        "xx      "
        "x       ";
    return vnc().rfbMakeXCursor(8, 9, dark, inside);
}

}  // namespace

// LibVNCServer's screen: it has one viewer at a time, and only this thread touches it.
struct Viewer::Screen {
    Screen(Viewer &viewer, const Given &given);
    ~Screen() { vnc().rfbScreenCleanup(info); }

    static Screen &of(rfbClientPtr client) { return *static_cast<Screen *>(client->screen->screenData); }
    static rfbBool password_is_right(rfbClientPtr client, const char *response, int size);
    bool wants_a_frame() const;
    void take_newest();
    bool take_tile(const uint8_t *rgb, size_t x, size_t y, size_t wide);

    Viewer &viewer;
    const Given &given;
    Keys keys;
    std::vector<uint8_t> pixels;  // four bytes each
    uint64_t shown = 0;           // the number of the frame in them
    rfbScreenInfoPtr info = nullptr;
};

Viewer::Screen::Screen(Viewer &of_viewer, const Given &all) : viewer(of_viewer), given(all), keys(all.input)
{
    info = vnc().rfbGetScreen(nullptr, nullptr, given.width, given.height, 8, 3, 4);
    if (!info) throw scenes::Failure("no memory for a viewer");
    pixels.assign(4 * static_cast<size_t>(given.width) * static_cast<size_t>(given.height), 0);
    info->frameBuffer = reinterpret_cast<char *>(pixels.data());
    info->screenData = this;
    info->desktopName = given.title.c_str();
    info->alwaysShared = TRUE;
    info->permitFileTransfer = FALSE;
    info->deferUpdateTime = 0;
    info->maxClientWait = most_wait_ms;
    info->cursor = arrow();
    info->authPasswdData = this;  // not null: there is a password
    info->passwordCheck = password_is_right;
    info->ptrAddEvent = [](int mask, int x, int y, rfbClientPtr client) {
        vnc().rfbDefaultPtrAddEvent(mask, x, y, client);
        of(client).keys.pointer(mask, x, y);
    };
    info->kbdAddEvent = [](rfbBool down, rfbKeySym symbol, rfbClientPtr client) {
        of(client).keys.key(symbol, down != FALSE);
    };
    info->displayFinishedHook = [](rfbClientPtr client, int done) {
        if (done != FALSE) ++of(client).viewer.frames_;
    };
}

rfbBool Viewer::Screen::password_is_right(rfbClientPtr client, const char *response, int size)
{
    Screen &screen = of(client);
    unsigned char expected[CHALLENGESIZE];
    std::memcpy(expected, client->authChallenge, sizeof expected);
    std::string password = screen.given.options.password;
    vnc().rfbEncryptBytes(expected, password.data());
    // Where the system has no DES, the challenge stays as it was, and an echo of it must not do.
    bool right = size == CHALLENGESIZE && std::memcmp(expected, client->authChallenge, sizeof expected) != 0;
    unsigned differs = 0;
    for (int k = 0; right && k < CHALLENGESIZE; ++k) differs |= expected[k] ^ static_cast<unsigned char>(response[k]);
    right = right && differs == 0;
    // Eight letters are not guessed by a few tries in a second.
    if (!right) screen.viewer.wait_for_end(screen.given.options.refusal_s);
    return right ? TRUE : FALSE;
}

bool Viewer::Screen::wants_a_frame() const
{
    const rfbClientPtr client = info->clientHead;
    return client && client->state == rfbClientRec::RFB_NORMAL && !vnc().sraRgnEmpty(client->requestedRegion);
}

// Returns whether it differed.
bool Viewer::Screen::take_tile(const uint8_t *rgb, size_t x, size_t y, size_t wide)
{
    const auto width = static_cast<size_t>(given.width);
    bool differs = false;
    const uint8_t *from = rgb + 3 * (y * width + x);
    uint8_t *to = pixels.data() + 4 * (y * width + x);
    for (size_t k = 0; k < wide; ++k, from += 3, to += 4) {
        differs = differs || to[0] != from[0] || to[1] != from[1] || to[2] != from[2];
        to[0] = from[0], to[1] = from[1], to[2] = from[2];
    }
    return differs;
}

void Viewer::Screen::take_newest()
{
    const std::shared_ptr<const Frame> frame = given.board.newest();
    if (!frame || frame->number == shown) return;
    shown = frame->number;
    const auto width = static_cast<size_t>(given.width), height = static_cast<size_t>(given.height);
    for (size_t y0 = 0; y0 < height; y0 += tile) {
        const size_t y1 = std::min(height, y0 + tile);
        for (size_t x0 = 0; x0 < width; x0 += tile) {
            const size_t x1 = std::min(width, x0 + tile);
            bool differs = false;
            for (size_t y = y0; y < y1; ++y) differs = take_tile(frame->rgb.data(), x0, y, x1 - x0) || differs;
            if (differs)
                vnc().rfbMarkRectAsModified(info, static_cast<int>(x0), static_cast<int>(y0), static_cast<int>(x1),
                                            static_cast<int>(y1));
        }
    }
}

Viewer::Viewer(const Given &given) : given_(given), screen_(std::make_unique<Screen>(*this, given)) {}

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
    const rfbClientPtr client = v.rfbNewClient(screen_->info, socket);
    if (!client || write(greeting.number(), version, sizeof version - 1) < 0)
        throw scenes::Failure("no window could be served: LibVNCServer takes no viewer");
    while (screen_->info->clientHead && client->state == rfbClientRec::RFB_PROTOCOL_VERSION)
        v.rfbProcessEvents(screen_->info, poll_us);
    if (!screen_->info->clientHead) return;
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
    }
    changed_.notify_all();
    return true;
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
        busy_ = false;
    }
}

void Viewer::serve(int socket)
{
    const Vnc &v = vnc();
    Screen &screen = *screen_;
    const auto ends = [this] {
        const std::lock_guard<std::mutex> lock(mutex_);
        return ends_;
    };
    const Clock::time_point deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                                          std::chrono::duration<double>(given_.options.handshake_s));
    // The library owns the socket from here on, also where it refuses.
    v.rfbNewClient(screen.info, socket);
    while (rfbClientPtr client = screen.info->clientHead) {
        watches_ = client->state == rfbClientRec::RFB_NORMAL;
        if (ends() || (!watches_ && Clock::now() > deadline)) {
            v.rfbCloseClient(client);
            v.rfbClientConnectionGone(client);
            break;
        }
        const double handshake_ms = std::clamp(given_.options.handshake_s * 1000, 1.0, 1e6);
        screen.info->maxClientWait = watches_ ? most_wait_ms : static_cast<int>(handshake_ms);
        if (screen.wants_a_frame()) screen.take_newest();
        v.rfbProcessEvents(screen.info, poll_us);
    }
    watches_ = false;
    screen.keys.release();
}

}  // namespace view::serve
