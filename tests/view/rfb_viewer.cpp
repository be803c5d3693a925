#include "tests/view/rfb_viewer.h"

#include <sys/socket.h>

#include <arpa/inet.h>
#include <netinet/in.h>

// Of LibVNCClient, which no header of it declares: DES with VNC's order of bits.
extern "C" void rfbClientEncryptBytes(unsigned char *challenge, char *password);

namespace view_test
{

void put16(Bytes &out, uint32_t value)
{
    out.push_back(static_cast<uint8_t>(value >> 8));
    out.push_back(static_cast<uint8_t>(value));
}

void put32(Bytes &out, uint32_t value)
{
    put16(out, value >> 16);
    put16(out, value & 0xffff);
}

RfbViewer::RfbViewer(int port, int receives) : socket_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0))
{
    const timeval minute = {60, 0};
    setsockopt(socket_.number(), SOL_SOCKET, SO_RCVTIMEO, &minute, sizeof minute);
    setsockopt(socket_.number(), SOL_SOCKET, SO_SNDTIMEO, &minute, sizeof minute);
    if (receives > 0) setsockopt(socket_.number(), SOL_SOCKET, SO_RCVBUF, &receives, sizeof receives);
    sockaddr_in at = {};
    at.sin_family = AF_INET;
    at.sin_port = htons(static_cast<uint16_t>(port));
    at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (connect(socket_.number(), reinterpret_cast<const sockaddr *>(&at), sizeof at) != 0) socket_.reset();
}

bool RfbViewer::send(const Bytes &bytes) const
{
    for (size_t at = 0; at < bytes.size();) {
        const ssize_t sent = ::send(socket_.number(), bytes.data() + at, bytes.size() - at, MSG_NOSIGNAL);
        if (sent <= 0) return false;
        at += static_cast<size_t>(sent);
    }
    return true;
}

bool RfbViewer::read(size_t size, Bytes &out) const
{
    out.assign(size, 0);
    for (size_t at = 0; at < size;) {
        const ssize_t got = recv(socket_.number(), out.data() + at, size - at, 0);
        if (got <= 0) return false;
        at += static_cast<size_t>(got);
    }
    return true;
}

bool RfbViewer::closed() const
{
    uint8_t bytes[4096];
    ssize_t got = 0;
    do got = recv(socket_.number(), bytes, sizeof bytes, 0);
    while (got > 0);
    return got == 0 || errno == ECONNRESET;
}

bool RfbViewer::greet(Bytes &offered) const
{
    Bytes version, count;
    static const char ours[] = "RFB 003.008\n";
    return read(12, version) && send(Bytes(ours, ours + 12)) && read(1, count) && read(count[0], offered);
}

bool RfbViewer::answer(Answer answer, const std::string &password) const
{
    Bytes challenge, result;
    if (!send({2}) || !read(16, challenge)) return false;
    std::string letters = answer == Answer::wrong ? "wrong" : password;
    letters.resize(9);
    if (answer == Answer::right || answer == Answer::wrong) rfbClientEncryptBytes(challenge.data(), letters.data());
    if (answer == Answer::nothing) challenge.assign(16, 0);
    return send(challenge) && read(4, result) && result == Bytes({0, 0, 0, 0});
}

bool RfbViewer::log_in(const std::string &password, int &width, int &height) const
{
    Bytes offered, start, name;
    if (!greet(offered) || !answer(Answer::right, password) || !send({1}) || !read(24, start)) return false;
    width = start[0] << 8 | start[1], height = start[2] << 8 | start[3];
    return read(static_cast<size_t>(start[22] << 8 | start[23]), name);
}

bool RfbViewer::request(bool changes, int width, int height) const
{
    Bytes message = {3, static_cast<uint8_t>(changes)};
    for (const int number : {0, 0, width, height}) put16(message, static_cast<uint32_t>(number));
    return send(message);
}

}  // namespace view_test
