// claque's task hook on oneTBB, with a stated number of threads, which may exceed the number of cores.
#pragma once

#include <claque/base.h>

#include <memory>

namespace scenes
{

class TbbTasks
{
public:
    explicit TbbTasks(int threads);  // [1, 256]
    ~TbbTasks();
    TbbTasks(const TbbTasks &) = delete;
    TbbTasks &operator=(const TbbTasks &) = delete;

    // Valid while this object lives. All zero for one thread: claque then works on the calling thread.
    clq_tasks hook();

private:
    struct Arena;
    std::unique_ptr<Arena> arena_;
};

}  // namespace scenes
