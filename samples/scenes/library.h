// One clq_context with threads, its warnings collected.
#pragma once

#include "samples/scenes/check.h"
#include "samples/scenes/tasks_tbb.h"

#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace scenes
{

class Library
{
public:
    explicit Library(int threads);

    clq_context *context() const { return context_.get(); }
    // A built-in figure, made when it is first asked for; lives as long as the library. From one thread at a time.
    clq_template *builtin(const std::string &name);
    // The same with coarser levels of detail of about so many triangles, descending; empty: claque's usual ones
    // (claque/levels.h). Kept in the user's cache folder (claque/prepare.h).
    clq_template *builtin(const std::string &name, const std::vector<uint32_t> &levels);
    std::vector<std::string> warnings() const;

private:
    mutable std::mutex mutex_;
    std::vector<std::string> warnings_;
    TbbTasks tasks_;
    Own<clq_context> context_;
    std::map<std::string, Own<clq_template>> figures_;
};

}  // namespace scenes
