// How a window is served over VNC.
#pragma once

#include <string>

namespace view::serve
{

struct Options {
    std::string address = "127.0.0.1";  // a number of this machine; others do not reach the default
    int port = 5900;                    // 0: any free one
    std::string password;               // empty: one is made
    double refusal_s = 1;               // for which the answer to a wrong password is held back
    double handshake_s = 20;            // within which a viewer gives its password
};

// "PORT", "ADDRESS" or "ADDRESS:PORT", the address of IPv6 in brackets. Returns false, and changes nothing, for what is
// none of them.
bool read_place(const std::string &text, Options &out);

// As read_place() reads it.
std::string place_text(const std::string &address, int port);

// Whether the address is reached from this machine only.
bool is_loopback(const std::string &address);

// Eight letters and digits from the system's random numbers; VNC passes no more. Throws scenes::Failure.
std::string make_password();

}  // namespace view::serve
