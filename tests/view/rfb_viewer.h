// A viewer of VNC on a socket, which says whatever a test wants.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "samples/view/serve/descriptor.h"

namespace view_test
{

using Bytes = std::vector<uint8_t>;

// A number as VNC sends it, the highest byte first.
void put16(Bytes &out, uint32_t value);
void put32(Bytes &out, uint32_t value);

class RfbViewer
{
public:
    // `receives`: bytes that the system keeps for it; 0: its own choice.
    explicit RfbViewer(int port, int receives = 0);

    // Each returns false where the other side has closed the connection, or says nothing for a minute.
    bool send(const Bytes &bytes) const;
    bool read(size_t size, Bytes &out) const;
    bool closed() const;  // waits for it

    // The kinds of security that the server offers to a viewer of version 3.8.
    bool greet(Bytes &offered) const;
    // Chooses a password, and answers the challenge by `answer`. Returns whether that was right.
    enum class Answer { right, wrong, echo, nothing };
    bool answer(Answer answer, const std::string &password) const;
    // All up to the first request. `width` and `height` are what the server says.
    bool log_in(const std::string &password, int &width, int &height) const;
    // All of the window, or what has changed of it.
    bool request(bool changes, int width, int height) const;

private:
    view::serve::Descriptor socket_;
};

}  // namespace view_test
