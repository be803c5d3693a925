// claque stage --commands: lines that pause, step, save and restore a run while it goes, from a file or from standard
// input, so that a script in any language can lead it.
//
//     step [N]         shows N frames more, 1 if no number is given
//     to SECONDS       shows all frames up to a time
//     go               shows frames until another line pauses it (with --live), or to the end
//     pause            with --live: the clock stands still
//     save FILE        writes the state of the run
//     restore FILE     goes on from a state
//     send EVENT [X]   sends an event with a value to all, who hear it after the lead
//     end              ends the run
//
// Without --live a run waits for a line before each frame that it was not told to show. Where the lines end it goes on.
#pragma once

#include <optional>
#include <string>

namespace cli
{

struct StageCommand {
    enum class Kind { step, to, go, pause, save, restore, send, end };
    Kind kind = Kind::go;
    double number = 1;
    std::string text;  // the file, or the event
};

class StageCommands
{
public:
    // `file`: - is standard input. Throws scenes::Failure.
    explicit StageCommands(const std::string &file);
    ~StageCommands();
    StageCommands(const StageCommands &) = delete;
    StageCommands &operator=(const StageCommands &) = delete;

    // The next one; none where the lines have ended. Both throw scenes::Failure with the number of a line that is no
    // command, and go on behind it the next time.
    std::optional<StageCommand> wait();
    std::optional<StageCommand> poll();  // none, too, where no line has come yet
    bool have_ended() const { return ended_ && text_.empty(); }

private:
    bool read_more(bool waits);
    std::optional<std::string> line();
    std::optional<StageCommand> next(bool waits);

    std::string name_, text_;  // text_: what was read and is not yet obeyed
    int descriptor_;
    bool ended_ = false;
    int number_ = 0;
};

}  // namespace cli
