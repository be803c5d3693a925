#include "samples/view/serve/screen.h"

#include <algorithm>
#include <cstring>

#include "samples/scenes/check.h"

namespace view::serve
{
namespace
{

constexpr size_t tile = 64;  // pixels on a side: what differs is sent by tiles

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

Screen::Screen(const Given &given, Told told) : given_(given), told_(std::move(told)), keys_(given.input)
{
    info_ = vnc().rfbGetScreen(nullptr, nullptr, given.width, given.height, 8, 3, 4);
    if (!info_) throw scenes::Failure("no memory for a viewer");
    info_->screenData = this;
    info_->desktopName = given.title.c_str();
    info_->alwaysShared = TRUE;
    info_->permitFileTransfer = FALSE;
    info_->deferUpdateTime = 0;
    info_->cursor = arrow();
    info_->authPasswdData = this;  // not null: there is a password
    info_->passwordCheck = password_is_right;
    info_->ptrAddEvent = [](int mask, int x, int y, rfbClientPtr client) {
        vnc().rfbDefaultPtrAddEvent(mask, x, y, client);
        of(client).keys_.pointer(mask, x, y);
    };
    info_->kbdAddEvent = [](rfbBool down, rfbKeySym symbol, rfbClientPtr client) {
        of(client).keys_.key(symbol, down != FALSE);
    };
    info_->displayFinishedHook = [](rfbClientPtr client, int done) {
        if (done != FALSE) of(client).told_.sent();
    };
}

void Screen::begin()
{
    pixels_.assign(4 * static_cast<size_t>(given_.width) * static_cast<size_t>(given_.height), 0);
    info_->frameBuffer = reinterpret_cast<char *>(pixels_.data());
    shown_ = 0;
}

// Most places wait, and need no picture.
void Screen::end()
{
    keys_.release();
    info_->frameBuffer = nullptr;
    pixels_ = {};
}

rfbBool Screen::password_is_right(rfbClientPtr client, const char *response, int size)
{
    Screen &screen = of(client);
    unsigned char expected[CHALLENGESIZE];
    std::memcpy(expected, client->authChallenge, sizeof expected);
    std::string password = screen.given_.options.password;
    vnc().rfbEncryptBytes(expected, password.data());
    // Where the system has no DES, the challenge stays as it was, and an echo of it must not do.
    bool right = size == CHALLENGESIZE && std::memcmp(expected, client->authChallenge, sizeof expected) != 0;
    unsigned differs = 0;
    for (int k = 0; right && k < CHALLENGESIZE; ++k) differs |= expected[k] ^ static_cast<unsigned char>(response[k]);
    return screen.told_.answer(right && differs == 0) ? TRUE : FALSE;
}

// Returns whether it differed.
bool Screen::take_tile(const uint8_t *rgb, size_t x, size_t y, size_t wide)
{
    const auto width = static_cast<size_t>(given_.width);
    bool differs = false;
    const uint8_t *from = rgb + 3 * (y * width + x);
    uint8_t *to = pixels_.data() + 4 * (y * width + x);
    for (size_t k = 0; k < wide; ++k, from += 3, to += 4) {
        differs = differs || to[0] != from[0] || to[1] != from[1] || to[2] != from[2];
        to[0] = from[0], to[1] = from[1], to[2] = from[2];
    }
    return differs;
}

void Screen::follow()
{
    const rfbClientPtr viewer = client();
    if (!viewer || viewer->state != rfbClientRec::RFB_NORMAL || vnc().sraRgnEmpty(viewer->requestedRegion)) return;
    const std::shared_ptr<const Frame> frame = given_.board.newest();
    if (!frame || frame->number == shown_) return;
    shown_ = frame->number;
    const auto width = static_cast<size_t>(given_.width), height = static_cast<size_t>(given_.height);
    for (size_t y0 = 0; y0 < height; y0 += tile) {
        const size_t y1 = std::min(height, y0 + tile);
        for (size_t x0 = 0; x0 < width; x0 += tile) {
            const size_t x1 = std::min(width, x0 + tile);
            bool differs = false;
            for (size_t y = y0; y < y1; ++y) differs = take_tile(frame->rgb.data(), x0, y, x1 - x0) || differs;
            if (differs)
                vnc().rfbMarkRectAsModified(info_, static_cast<int>(x0), static_cast<int>(y0), static_cast<int>(x1),
                                            static_cast<int>(y1));
        }
    }
}

}  // namespace view::serve
