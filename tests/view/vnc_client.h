// LibVNCClient's viewer, for tests.
#pragma once

#include <memory>
#include <string>
#include <vector>

struct _rfbClient;

namespace view_test
{

class VncClient
{
public:
    VncClient(int port, const std::string &password);
    ~VncClient();
    VncClient(const VncClient &) = delete;
    VncClient &operator=(const VncClient &) = delete;

    bool connected() const { return client_ != nullptr; }
    void pointer(int x, int y, int mask);
    void key(unsigned symbol, bool down);
    // Takes what has come within some milliseconds. Returns false where the connection has ended.
    bool listen(int milliseconds);
    std::vector<unsigned char> rgb() const;  // its picture
    int updates() const { return updates_; }

private:
    _rfbClient *client_ = nullptr;
    std::string password_;
    int updates_ = 0;
};

}  // namespace view_test
