// A film of what a view shows, written by ffmpeg.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <sys/types.h>
#include <vector>

namespace io
{
class Unfinished;
}

namespace view
{

class Film
{
public:
    // Throws scenes::Failure if there is no ffmpeg.
    Film(const std::string &path, int width, int height);
    ~Film();  // what is not complete is removed
    Film(const Film &) = delete;
    Film &operator=(const Film &) = delete;

    int width() const { return width_; }
    int height() const { return height_; }
    uint64_t frames() const { return frames_; }

    // A picture that is shown for this time: three bytes a pixel, top row first. It may become several frames of the
    // film, or none. Throws scenes::Failure if ffmpeg has ended.
    void add(const std::vector<uint8_t> &rgb, double elapsed_s);
    // The file is there, whole, when this returns. Throws scenes::Failure if ffmpeg failed.
    void end();

private:
    void stop();

    std::string path_, draft_;
    std::unique_ptr<io::Unfinished> unfinished_;
    int width_, height_, socket_ = -1, status_ = -1;
    pid_t process_ = -1;
    double time_s_ = 0;
    uint64_t frames_ = 0;
};

}  // namespace view
