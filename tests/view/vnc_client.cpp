#include "tests/view/vnc_client.h"

#include <cstdlib>
#include <cstring>

#include <rfb/rfbclient.h>

namespace view_test
{
namespace
{

char tag;

void say_nothing(const char *, ...) {}

VncClient *of(rfbClient *client) { return static_cast<VncClient *>(rfbClientGetClientData(client, &tag)); }

}  // namespace

VncClient::VncClient(int port, const std::string &password) : password_(password)
{
    rfbClientLog = rfbClientErr = say_nothing;
    client_ = rfbGetClient(8, 3, 4);
    std::free(client_->serverHost);
    client_->serverHost = strdup("127.0.0.1");
    client_->serverPort = port;
    client_->appData.encodingsString = "raw";
    client_->appData.useRemoteCursor = TRUE;  // else it is drawn into the picture
    rfbClientSetClientData(client_, &tag, this);
    client_->GetPassword = [](rfbClient *client) { return strdup(of(client)->password_.c_str()); };
    client_->FinishedFrameBufferUpdate = [](rfbClient *client) { ++of(client)->updates_; };
    if (!rfbInitClient(client_, nullptr, nullptr)) client_ = nullptr;  // and it is freed
}

VncClient::~VncClient()
{
    if (!client_) return;
    // The library leaves these to its hosts, up to 0.9.14.
    for (uint8_t **left : {&client_->frameBuffer, &client_->rcSource, &client_->rcMask}) {
        std::free(*left);
        *left = nullptr;
    }
    rfbClientCleanup(client_);
}

void VncClient::pointer(int x, int y, int mask) { SendPointerEvent(client_, x, y, mask); }
void VncClient::key(unsigned symbol, bool down) { SendKeyEvent(client_, symbol, down ? TRUE : FALSE); }

bool VncClient::listen(int milliseconds)
{
    const int waits = WaitForMessage(client_, static_cast<unsigned>(milliseconds) * 1000);
    return waits == 0 || (waits > 0 && HandleRFBServerMessage(client_) != FALSE);
}

std::vector<unsigned char> VncClient::rgb() const
{
    std::vector<unsigned char> out;
    const auto pixels = static_cast<size_t>(client_->width) * static_cast<size_t>(client_->height);
    for (size_t k = 0; k < 4 * pixels; ++k)
        if (k % 4 != 3) out.push_back(client_->frameBuffer[k]);
    return out;
}

}  // namespace view_test
