// Frames of a film by several processes of this machine, or by the ranks of an MPI job: whole frames in turn, or each
// frame in tiles.
#pragma once

#include <functional>
#include <memory>

#include "samples/cli/frame_drawer.h"
#include "samples/processes/ranks.h"

namespace cli
{

class FrameCrew
{
public:
    // Starts the processes, or has the ranks of a job (rank 0 calls it). To be made where no thread and no GL context
    // is; `arguments` must live as long as this. Throws std::runtime_error, as the next calls do.
    explicit FrameCrew(const RenderArguments &arguments, processes::Ranks *ranks = nullptr);
    ~FrameCrew();

    const Subject &subject();
    // Calls done(index, report, bytes, size) once for each frame: in any order for files, in the order of `frames` for
    // standard output.
    using Done = std::function<void(size_t index, Json report, const unsigned char *bytes, size_t size)>;
    void draw(const std::vector<Frame> &frames, const Done &done);

    uint32_t replaced() const;  // processes that ended and were replaced
    const std::vector<std::string> &warnings() const;

    // What the other ranks do: draws until rank 0 has all frames.
    static void serve(const RenderArguments &arguments, processes::Ranks &ranks);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace cli
