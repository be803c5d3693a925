#include "samples/processes/rank_team.h"

#include <cstring>

namespace processes
{
namespace
{

// An answer as one message: where its pixels lie, the length of its text, the text, and the pixels without gaps.
struct Head {
    Pixels pixels;
    size_t text_bytes;
};

std::string packed(const Reply &reply, const uint8_t *pages)
{
    const Pixels &p = reply.pixels;
    const Head head = {p, reply.text.size()};
    std::string message(sizeof head + reply.text.size() + p.bytes * p.rows, 0);
    char *out = message.data();
    std::memcpy(out, &head, sizeof head), out += sizeof head;
    std::memcpy(out, reply.text.data(), reply.text.size()), out += reply.text.size();
    for (size_t row = 0; row < p.rows; ++row, out += p.bytes) std::memcpy(out, pages + p.at + row * p.stride, p.bytes);
    return message;
}

std::string unpacked(const std::string &message, uint8_t *pages)
{
    Head head;
    std::memcpy(&head, message.data(), sizeof head);
    const Pixels &p = head.pixels;
    const char *in = message.data() + sizeof head + head.text_bytes;
    for (size_t row = 0; row < p.rows; ++row, in += p.bytes) std::memcpy(pages + p.at + row * p.stride, in, p.bytes);
    return message.substr(sizeof head, head.text_bytes);
}

}  // namespace

RankTeam::~RankTeam()
{
    for (int rank = 1; rank < ranks_.count(); ++rank) ranks_.send(rank, "");
}

void RankTeam::send(uint32_t worker, const std::string &task)
{
    if (worker == 0) tasks_.push_back(task);
    else ranks_.send(static_cast<int>(worker), task);
}

// Answers of others come first: they wait for their next tasks.
Team::Answer RankTeam::wait()
{
    if (!tasks_.empty() && !ranks_.has_message()) {
        const std::string task = std::move(tasks_.front());
        tasks_.pop_front();
        return {0, own_(task).text};
    }
    int from = 0;
    const std::string message = ranks_.receive(from);
    return {static_cast<uint32_t>(from), unpacked(message, pages_)};
}

void serve(Ranks &ranks, const Answering &answering, const uint8_t *pages)
{
    for (;;) {
        int from = 0;
        const std::string task = ranks.receive(from);
        if (task.empty()) return;
        ranks.send(0, packed(answering(task), pages));
    }
}

}  // namespace processes
