// The struct behind clq_stage.
#pragma once

#include <claque/stage.h>

#include <atomic>
#include <mutex>

#include "lib/stage/agents/director.h"
#include "lib/stage/flow/shown.h"

struct clq_stage {
    clq_stage(clq_context *context, const clq_stage_def &def) : director(context, def), shown(context)
    {
        info = director.info();
    }
    claque::stage::Director director;  // of the decisions' flow
    claque::stage::Shown shown;        // of the drawing flow
    std::atomic<bool> is_deciding{false}, is_applying{false};
    mutable std::mutex info_mutex;
    clq_stage_info info;  // as the last step left it
};

namespace claque::stage
{

// One call at a time in a flow; another one is refused.
class Only
{
public:
    Only(std::atomic<bool> &flag, const char *flow) : flag_(flag)
    {
        if (flag_.exchange(true, std::memory_order_acquire))
            fail(CLQ_BUSY, "another call works in the %s of the stage", flow);
    }
    Only(const Only &) = delete;
    Only &operator=(const Only &) = delete;
    ~Only() { flag_.store(false, std::memory_order_release); }

private:
    std::atomic<bool> &flag_;
};

class Deciding
{
public:
    explicit Deciding(clq_stage *stage) : only_(stage->is_deciding, "decisions' flow"), stage_(stage) {}
    ~Deciding()
    {
        const clq_stage_info now = stage_->director.info();
        const std::lock_guard<std::mutex> lock(stage_->info_mutex);
        stage_->info = now;
    }

private:
    Only only_;
    clq_stage *stage_;
};

void require_finite(double number, const char *what);
void require_place(const double position[3]);
// The agent's index. Throws STALE_ID.
uint32_t index_of(const Director &director, clq_agent agent);
// The text's bytes and name.
struct Text {
    std::string bytes, name;
};
Text read_text(const clq_stage_text *source);
std::vector<Entry> read_timetable(const Text &text, Vocabulary &shared, double offset_s);

}  // namespace claque::stage
