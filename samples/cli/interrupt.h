// Stops between frames: SIGINT and SIGTERM are recorded and acted on later, so that no partial file is left behind.
#pragma once

namespace cli
{

// Also ignores SIGPIPE: a closed reader is an error to report, not a reason to die silently.
void watch_signals();

// Throws scenes::Failure if a signal asked the process to stop.
void stop_if_asked();

}  // namespace cli
