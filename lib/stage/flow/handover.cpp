#include "lib/stage/flow/handover.h"

#include <utility>

#include "lib/stage/hash.h"

namespace claque::stage
{

uint64_t sum(uint64_t h, const Command &command)
{
    h = sum(sum(h, command.at_s), (uint64_t(command.agent) << 32) + uint64_t(command.kind));
    h = sum(h, (uint64_t(command.clip) << 32) + (uint64_t(command.curve) << 8) + command.adds);
    for (const float number :
         {command.speed, command.phase_s, command.weight, command.loops, command.fade_s, command.fade_out_s})
        h = sum(h, static_cast<double>(number));
    h = sum(sum(h, (uint64_t(command.mask) << 32) + command.gaze.index1), command.value);
    h = sum(h, command.start_s);
    for (const double coordinate : command.point) h = sum(h, coordinate);
    if (!command.track) return h;
    clq_track_info info = clq_track_info_init();
    clq_track_get_info(command.track, &info);
    return sum(h, info.hash);
}

namespace
{

void release(std::vector<Command> &commands, size_t from)
{
    for (size_t i = from; i < commands.size(); ++i) clq_track_destroy(commands[i].track);
}

}  // namespace

Handover::Handover(double start_s) : decided_s_(start_s) { head_ = tail_ = new Block; }

Handover::~Handover()
{
    size_t from = read_;
    for (Block *block = head_; block;) {
        release(block->commands, from);
        from = 0;
        Block *next = block->next.load(std::memory_order_relaxed);
        delete block;
        block = next;
    }
    for (Block *block = used_.load(std::memory_order_relaxed); block;) {
        Block *next = block->next.load(std::memory_order_relaxed);
        delete block;
        block = next;
    }
}

// A block that was read, or a new one.
Handover::Block *Handover::fresh()
{
    Block *all = used_.exchange(nullptr, std::memory_order_acquire);
    if (!all) return new Block;
    // The rest goes back; the reader may have put others there meanwhile.
    for (Block *rest = all->next.load(std::memory_order_relaxed); rest;) {
        Block *next = rest->next.load(std::memory_order_relaxed);
        give_back(rest);
        rest = next;
    }
    all->next.store(nullptr, std::memory_order_relaxed);
    all->commands.clear();
    return all;
}

void Handover::give_back(Block *block)
{
    Block *top = used_.load(std::memory_order_relaxed);
    do block->next.store(top, std::memory_order_relaxed);
    while (!used_.compare_exchange_weak(top, block, std::memory_order_release, std::memory_order_relaxed));
}

void Handover::publish(std::vector<Command> &commands, double decided_s)
{
    if (!commands.empty()) {
        Block *block = fresh();
        block->commands.swap(commands);
        written_ += block->commands.size();
        tail_->next.store(block, std::memory_order_release);
        tail_ = block;
    }
    decided_s_.store(decided_s, std::memory_order_release);
}

Command *Handover::front(double time_s)
{
    while (read_ == head_->commands.size()) {
        Block *next = head_->next.load(std::memory_order_acquire);
        if (!next) return nullptr;
        give_back(std::exchange(head_, next));
        read_ = 0;
    }
    Command &command = head_->commands[read_];
    return command.at_s <= time_s ? &command : nullptr;
}

std::vector<Command> Handover::left() const
{
    std::vector<Command> all;
    size_t from = read_;
    for (const Block *block = head_; block; block = block->next.load(std::memory_order_relaxed)) {
        all.insert(all.end(), block->commands.begin() + static_cast<std::ptrdiff_t>(from), block->commands.end());
        from = 0;
    }
    return all;
}

void Handover::replace(std::vector<Command> &commands, double decided_s) noexcept
{
    release(head_->commands, read_);
    for (Block *block = head_->next.load(std::memory_order_relaxed); block;) {
        release(block->commands, 0);
        Block *next = block->next.load(std::memory_order_relaxed);
        give_back(block);
        block = next;
    }
    head_->next.store(nullptr, std::memory_order_relaxed);
    tail_ = head_;
    read_ = 0;
    head_->commands.swap(commands);
    written_ = head_->commands.size();
    read_in_all_.store(0, std::memory_order_relaxed);
    commands.clear();
    decided_s_.store(decided_s, std::memory_order_release);
}

}  // namespace claque::stage
