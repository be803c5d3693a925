// LibVNCServer's screen: it has one viewer at a time, and only that viewer's thread touches it.
#pragma once

#include <functional>
#include <vector>

#include "samples/view/serve/given.h"
#include "samples/view/serve/keys.h"
#include "samples/view/serve/vnc.h"

namespace view::serve
{

class Screen
{
public:
    struct Told {
        std::function<bool(bool right)> answer;  // the password was right; returns whether the viewer is let in
        std::function<void()> sent;              // a frame
    };

    Screen(const Given &given, Told told);
    ~Screen() { vnc().rfbScreenCleanup(info_); }
    Screen(const Screen &) = delete;
    Screen &operator=(const Screen &) = delete;

    rfbScreenInfoPtr info() const { return info_; }
    rfbClientPtr client() const { return info_->clientHead; }  // null: it has gone

    void begin();  // with a black picture, for the next viewer
    void end();    // lets go what the viewer still holds
    // Takes the newest frame if the viewer wants one.
    void follow();

private:
    static Screen &of(rfbClientPtr client) { return *static_cast<Screen *>(client->screen->screenData); }
    static rfbBool password_is_right(rfbClientPtr client, const char *response, int size);
    bool take_tile(const uint8_t *rgb, size_t x, size_t y, size_t wide);

    const Given &given_;
    Told told_;
    Keys keys_;
    std::vector<uint8_t> pixels_;  // four bytes each
    uint64_t shown_ = 0;           // the number of the frame in them
    rfbScreenInfoPtr info_ = nullptr;
};

}  // namespace view::serve
