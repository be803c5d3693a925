// Signals that end the command: all that can be caught end it at once, wherever it is, by their default action, so that
// a shell sees which signal it was. What is not complete is removed first. SIGXFSZ is ignored: the write fails.
#pragma once

#include <csignal>
#include <string>

namespace io
{

// To be called by the main thread, which is the one that writes files. Signals that are ignored or handled stay so.
void watch_signals();

// In a child that was forked: signals end it by their default action, and what is unfinished stays the parent's.
void leave_files_to_parent();

// All three may be called in a signal handler. Ends the process by the signal of the handler, and leaves nothing.
void end_by(int number);
// Sends the signal to the main thread, unless this is the main thread; returns
// whether it was sent.
bool passed_to_main_thread(int number);
// The main thread may call this. It removes every Unfinished.
void remove_unfinished();

// The watched signals wait while this object of the main thread exists.
class SignalsHeld
{
public:
    SignalsHeld();
    ~SignalsHeld();
    SignalsHeld(const SignalsHeld &) = delete;
    SignalsHeld &operator=(const SignalsHeld &) = delete;

private:
    sigset_t before_;
};

// A file, or a folder that is then empty, that a signal removes while this object exists. At most 64 at a time; those
// beyond are not removed.
class Unfinished
{
public:
    explicit Unfinished(const std::string &path);  // to be made before the file
    ~Unfinished();
    Unfinished(const Unfinished &) = delete;
    Unfinished &operator=(const Unfinished &) = delete;

private:
    int slot_;
};

}  // namespace io
