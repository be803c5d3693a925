// The functions of LibVNCServer that serving a window needs. The library is opened when a window is served, so that the
// claque command needs none otherwise.
#pragma once

#include <rfb/rfb.h>
extern "C" {
#include <rfb/rfbregion.h>
}

namespace view::serve
{

#define CLAQUE_VIEW_VNC(FUNCTION)     \
    FUNCTION(rfbGetScreen)            \
    FUNCTION(rfbScreenCleanup)        \
    FUNCTION(rfbNewClient)            \
    FUNCTION(rfbProcessEvents)        \
    FUNCTION(rfbCloseClient)          \
    FUNCTION(rfbClientConnectionGone) \
    FUNCTION(rfbMarkRectAsModified)   \
    FUNCTION(rfbDefaultPtrAddEvent)   \
    FUNCTION(rfbMakeXCursor) FUNCTION(rfbLogEnable) FUNCTION(rfbEncryptBytes) FUNCTION(sraRgnEmpty)

struct Vnc {
#define CLAQUE_VIEW_VNC_MEMBER(name) decltype(&::name) name = nullptr;
    CLAQUE_VIEW_VNC(CLAQUE_VIEW_VNC_MEMBER)
#undef CLAQUE_VIEW_VNC_MEMBER
};

// Opened once for the process. Throws scenes::Failure.
const Vnc &vnc();

}  // namespace view::serve
