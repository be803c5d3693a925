// How a window is served over VNC.
#pragma once

#include <string>
#include <vector>

namespace view::serve
{

struct Options {
    std::string address = "127.0.0.1";  // a number of this machine; others do not reach the default
    int port = 5900;                    // 0: any free one
    std::string password;               // empty: one is made
    std::vector<std::string> origins;   // of pages that may open the window besides those of the same host
    double refusal_s = 1;               // for which the answer to a wrong password is held back
    double handshake_s = 3;             // within which a viewer's program comes to the password
    double typing_s = 30;               // within which a person then types it
};

// "PORT", "ADDRESS" or "ADDRESS:PORT", the address of IPv6 in brackets. Returns false, and changes nothing, for what is
// none of them.
bool read_place(const std::string &text, Options &out);

// As read_place() reads it.
std::string place_text(const std::string &address, int port);

// Whether the address is reached from this machine only.
bool is_loopback(const std::string &address);

// VNC passes eight letters of a password, and pads shorter ones with nothing.
constexpr size_t password_letters = 8;

// What is wrong with a password, as "has 3 letters; ..."; "": nothing. It does not contain the password.
std::string wrong_password(const std::string &password);

// Letters and digits from the system's random numbers. Throws scenes::Failure.
std::string make_password();

}  // namespace view::serve
