// Workers that answer tasks: processes of this machine (crew.h), or the ranks of an MPI job (rank_team.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace processes
{

// Where an answer's pixels lie in the pages that a team shares: `rows` rows of `bytes`, each `stride` after the last.
struct Pixels {
    size_t at = 0, bytes = 0, rows = 0, stride = 0;
};

struct Reply {
    Reply(std::string words, const Pixels &where = {}) : text(std::move(words)), pixels(where) {}
    Reply(const char *words) : text(words) {}

    std::string text;
    Pixels pixels;
};
using Answering = std::function<Reply(const std::string &task)>;

class Team
{
public:
    struct Answer {
        uint32_t worker;
        std::string text;
        bool ended = false;  // the worker, without an answer (Crew::Ends::told)
    };

    virtual ~Team() = default;
    virtual uint32_t size() const = 0;
    // How many tasks a worker may have at a time. It answers them in their order.
    virtual uint32_t depth() const = 0;
    virtual void send(uint32_t worker, const std::string &task) = 0;
    // Waits for the next answer, whose pixels are then in the pages; some worker must have a task. Throws
    // std::runtime_error.
    virtual Answer wait() = 0;
    virtual uint32_t replaced() const = 0;  // workers that ended and were replaced
};

}  // namespace processes
