// The list of commands between decisions and drawing: a block for each tick in a queue with one writer and one reader,
// neither of which ever waits. Blocks that were read go back to the writer, so the reader frees nothing.
#pragma once

#include <atomic>
#include <vector>

#include "lib/stage/flow/command.h"

namespace claque::stage
{

// How many commands may wait for the reader.
constexpr size_t most_commands(size_t agents) { return (size_t(1) << 20) + 4096 * agents; }

class Handover
{
public:
    explicit Handover(double start_s);
    Handover(const Handover &) = delete;
    Handover &operator=(const Handover &) = delete;
    ~Handover();

    // The writer. If it throws, nothing has changed; otherwise `commands` is empty afterwards.
    void publish(std::vector<Command> &commands, double decided_s);

    // The reader: the oldest command up to a time; NULL: there is none. pop() ends it, and its hold of a track goes to
    // the caller.
    Command *front(double time_s);
    void pop()
    {
        ++read_;
        read_in_all_.fetch_add(1, std::memory_order_relaxed);
    }

    // The writer: commands that the reader has not ended yet.
    size_t held() const { return static_cast<size_t>(written_ - read_in_all_.load(std::memory_order_relaxed)); }

    double decided_s() const { return decided_s_.load(std::memory_order_acquire); }

    // Both sides at rest.
    std::vector<Command> left() const;                                        // without holds of their own
    void replace(std::vector<Command> &commands, double decided_s) noexcept;  // takes their holds

private:
    struct Block {
        std::vector<Command> commands;
        std::atomic<Block *> next{nullptr};
    };
    Block *fresh();
    void give_back(Block *block);

    std::atomic<double> decided_s_;
    std::atomic<Block *> used_{nullptr};
    Block *tail_ = nullptr;  // the writer's
    uint64_t written_ = 0;
    alignas(64) Block *head_ = nullptr;  // the reader's
    size_t read_ = 0;
    std::atomic<uint64_t> read_in_all_{0};
};

}  // namespace claque::stage
