#include "samples/view/film.h"

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "samples/io/files.h"
#include "samples/io/unfinished.h"
#include "samples/scenes/check.h"

extern char **environ;

namespace view
{
namespace
{

constexpr int film_rate = 25;

[[noreturn]] void refuse_film(const std::string &path, const std::string &why)
{
    throw scenes::Failure("no film " + path + ": " + why);
}

constexpr int draft_number = 3;  // of ffmpeg's open files

// The encoder needs even numbers of pixels. ffmpeg writes a file that is open already: by its name it could make the
// draft again after a signal has removed it.
std::vector<std::string> words_for(int width, int height)
{
    return {"ffmpeg",
            "-loglevel",
            "error",
            "-nostats",
            "-y",
            "-f",
            "rawvideo",
            "-pix_fmt",
            "rgb24",
            "-s",
            std::to_string(width) + "x" + std::to_string(height),
            "-r",
            std::to_string(film_rate),
            "-i",
            "-",
            "-vf",
            "pad=ceil(iw/2)*2:ceil(ih/2)*2",
            "-c:v",
            "libx264",
            "-crf",
            "21",
            "-preset",
            "fast",
            "-pix_fmt",
            "yuv420p",
            "-movflags",
            "+faststart",
            "-f",
            "mp4",
            "/dev/fd/" + std::to_string(draft_number)};
}

// The error of starting; 0: none.
int start_ffmpeg(std::vector<std::string> words, int input, int draft, pid_t &process)
{
    std::vector<char *> list;
    for (std::string &word : words) list.push_back(word.data());
    list.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, draft, draft_number);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    const int error = posix_spawnp(&process, "ffmpeg", &actions, nullptr, list.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

}  // namespace

Film::Film(const std::string &path, int width, int height)
    : path_(path), draft_(path.substr(0, path.rfind('.')) + ".part.mp4"), width_(width), height_(height)
{
    unfinished_ = std::make_unique<io::Unfinished>(draft_);
    // A socket, as writing to a pipe that nothing reads is a signal.
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) refuse_film(path_, std::strerror(errno));
    std::remove(draft_.c_str());
    const int draft = io::open_draft(draft_, path_);
    const int error = draft < 0 ? errno : start_ffmpeg(words_for(width, height), ends[1], draft, process_);
    if (draft >= 0) close(draft);
    close(ends[1]);
    socket_ = ends[0];
    if (error == 0) return;
    process_ = -1;
    close(socket_);
    if (draft >= 0) std::remove(draft_.c_str());
    refuse_film(path_, error == ENOENT && draft >= 0 ? "there is no ffmpeg (Debian: ffmpeg)" : std::strerror(error));
}

Film::~Film()
{
    if (status_ == 0) return;
    stop();
    std::remove(draft_.c_str());
}

void Film::stop()
{
    if (socket_ >= 0) close(socket_);
    socket_ = -1;
    int status = 0;
    if (process_ > 0)
        while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {}
    process_ = -1;
    status_ = status;
}

void Film::add(const std::vector<uint8_t> &rgb, double elapsed_s)
{
    time_s_ += std::fmin(elapsed_s, 1);  // of a view that stood still, one second
    for (const auto due = static_cast<uint64_t>(std::lround(time_s_ * film_rate)); frames_ < due; ++frames_)
        for (size_t at = 0; at < rgb.size();) {
            const ssize_t sent = send(socket_, rgb.data() + at, rgb.size() - at, MSG_NOSIGNAL);
            if (sent < 0 && errno == EINTR) continue;
            if (sent < 0) refuse_film(path_, "ffmpeg has ended early");
            at += static_cast<size_t>(sent);
        }
}

void Film::end()
{
    stop();
    if (status_ != 0) refuse_film(path_, "ffmpeg failed");
    if (std::rename(draft_.c_str(), path_.c_str()) == 0) return;
    status_ = 1;
    refuse_film(path_, std::strerror(errno));
}

}  // namespace view
