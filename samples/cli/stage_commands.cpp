#include "samples/cli/stage_commands.h"

#include <cerrno>
#include <cmath>
#include <fcntl.h>
#include <poll.h>
#include <sstream>
#include <unistd.h>

#include "samples/io/files.h"
#include "samples/scenes/check.h"

namespace cli
{
namespace
{

constexpr size_t longest_line = 4096;

struct Word {
    const char *word;
    StageCommand::Kind kind;
    bool has_number, needs_number, has_text;
};
constexpr Word known_words[] = {{"step", StageCommand::Kind::step, true, false, false},
                                {"to", StageCommand::Kind::to, true, true, false},
                                {"go", StageCommand::Kind::go, false, false, false},
                                {"pause", StageCommand::Kind::pause, false, false, false},
                                {"save", StageCommand::Kind::save, false, false, true},
                                {"restore", StageCommand::Kind::restore, false, false, true},
                                {"send", StageCommand::Kind::send, true, false, true},
                                {"end", StageCommand::Kind::end, false, false, false}};

// Returns what is wrong, or "".
std::string read_command(const std::string &line, StageCommand &out)
{
    std::istringstream words(line);
    std::string word, rest;
    words >> word;
    for (const Word &known : known_words) {
        if (word != known.word) continue;
        out.kind = known.kind;
        if (known.has_text && !(words >> out.text)) return "'" + word + "' needs a name behind it";
        if (known.has_number && !(words >> out.number)) {
            if (!words.eof() || known.needs_number) return "'" + word + "' needs a number";
            words.clear();
            out.number = 1;
        }
        if (!std::isfinite(out.number)) return "'" + word + "' needs a number";
        if (known.kind == StageCommand::Kind::step && !(out.number >= 1 && out.number <= 1e6))
            return "'step' needs a number of frames from 1 to 1000000";
        if (words >> rest) return "there is '" + rest + "' behind '" + word + "'";
        return "";
    }
    return "'" + word + "' is no command; known are step, to, go, pause, save, restore, send, end";
}

}  // namespace

StageCommands::StageCommands(const std::string &file)
    : name_(file == "-" ? "standard input" : file),
      descriptor_(file == "-" ? STDIN_FILENO : ::open(file.c_str(), O_RDONLY | O_CLOEXEC))
{
    if (descriptor_ < 0) throw scenes::Failure(io::why(file, "read"));
}

StageCommands::~StageCommands()
{
    if (descriptor_ != STDIN_FILENO) ::close(descriptor_);
}

// Whether there is anything new.
bool StageCommands::read_more(bool waits)
{
    pollfd wanted = {descriptor_, POLLIN, 0};
    const int ready = ::poll(&wanted, 1, waits ? -1 : 0);
    if (ready < 0 && errno == EINTR) return waits;
    if (ready <= 0) return false;
    char some[1024];
    const ssize_t count = ::read(descriptor_, some, sizeof some);
    if (count < 0) throw scenes::Failure(io::why(name_, "read"));
    if (count == 0) ended_ = true;
    text_.append(some, static_cast<size_t>(count));
    return true;
}

std::optional<std::string> StageCommands::line()
{
    const size_t end = text_.find('\n');
    if (end == std::string::npos && text_.size() > longest_line)
        throw scenes::Failure(name_ + ": line " + std::to_string(number_ + 1) + " is longer than 4096 characters");
    if (end == std::string::npos && !(ended_ && !text_.empty())) return std::nullopt;
    std::string found = text_.substr(0, end);
    text_.erase(0, end == std::string::npos ? end : end + 1);
    ++number_;
    return found;
}

std::optional<StageCommand> StageCommands::next(bool waits)
{
    for (;;) {
        const std::optional<std::string> found = line();
        if (!found) {
            if (ended_ || !read_more(waits)) return std::nullopt;
            continue;
        }
        const size_t first = found->find_first_not_of(" \t\r");
        if (first == std::string::npos || (*found)[first] == '#') continue;
        StageCommand command;
        const std::string wrong = read_command(*found, command);
        if (wrong.empty()) return command;
        throw scenes::Failure(name_ + ", line " + std::to_string(number_) + ": " + wrong);
    }
}

std::optional<StageCommand> StageCommands::wait() { return next(true); }
std::optional<StageCommand> StageCommands::poll() { return next(false); }

}  // namespace cli
