#include "samples/view/serve/options.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <sys/random.h>

#include <arpa/inet.h>

#include "samples/scenes/check.h"

namespace view::serve
{
namespace
{

bool read_port(const std::string &text, int &port)
{
    char *end = nullptr;
    const long value = std::strtol(text.c_str(), &end, 10);
    if (text.empty() || text.find_first_not_of("0123456789") != std::string::npos || *end != 0 || value > 65535)
        return false;
    port = static_cast<int>(value);
    return true;
}

bool is_v4(const std::string &text)
{
    in_addr out = {};
    return inet_pton(AF_INET, text.c_str(), &out) == 1;
}

bool is_v6(const std::string &text)
{
    in6_addr out = {};
    return inet_pton(AF_INET6, text.c_str(), &out) == 1;
}

}  // namespace

bool read_place(const std::string &text, Options &out)
{
    Options read = out;
    std::string rest;  // after the address
    if (!text.empty() && text[0] == '[') {
        const size_t end = text.find(']');
        if (end == std::string::npos) return false;
        read.address = text.substr(1, end - 1);
        if (!is_v6(read.address)) return false;
        rest = text.substr(end + 1);
    } else {
        if (read_port(text, read.port)) {
            out = read;
            return true;
        }
        const size_t colon = text.find(':');
        read.address = text.substr(0, colon);
        if (!is_v4(read.address)) return false;
        if (colon != std::string::npos) rest = text.substr(colon);
    }
    if (!rest.empty() && (rest[0] != ':' || !read_port(rest.substr(1), read.port))) return false;
    out = read;
    return true;
}

std::string place_text(const std::string &address, int port)
{
    const std::string number = std::to_string(port);
    return is_v6(address) ? "[" + address + "]:" + number : address + ":" + number;
}

bool is_loopback(const std::string &address) { return address == "::1" || address.rfind("127.", 0) == 0; }

std::string wrong_password(const std::string &password)
{
    for (const char letter : password)
        if (letter <= ' ' || letter > '~') return "has letters besides those of ASCII, which VNC does not pass";
    if (password.size() == password_letters) return "";
    return "has " + std::to_string(password.size()) + " letters; a password of VNC has exactly 8";
}

std::string make_password()
{
    // 32 that are not taken for each other: five bits each.
    static const char letters[] = "abcdefghijkmnpqrstuvwxyz23456789";
    unsigned char random[password_letters];
    if (getrandom(random, sizeof random, 0) != static_cast<ssize_t>(sizeof random))
        throw scenes::Failure(std::string("no password could be made: ") + std::strerror(errno));
    std::string password;
    for (const unsigned char byte : random) password += letters[byte % 32];
    return password;
}

}  // namespace view::serve
