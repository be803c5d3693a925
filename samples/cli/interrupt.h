// Stopping between frames: SIGINT and SIGTERM are noticed, not obeyed at once, so that no half a file is left behind.
#pragma once

namespace cli
{

// Also ignores SIGPIPE: a reader that went away is an error to report, not a reason to die silently.
void watch_signals();

// Throws scenes::Failure where somebody asked to stop.
void stop_if_asked();

}  // namespace cli
