// Failures in OSG's log: each once, not in every frame.
#pragma once

#include <mutex>
#include <string>

#include <osg/Notify>

#include "samples/scenes/check.h"

namespace osg_plugin
{

class Warning
{
public:
    // From any thread.
    void give(const scenes::Failure &failure)
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (failure.what() != last_) OSG_WARN << "claque: " << failure.what() << std::endl;
        last_ = failure.what();
    }

private:
    std::mutex mutex_;
    std::string last_;
};

}  // namespace osg_plugin
