// No stage loses a task: each that it holds waits for its time, or is due in its class. Tests of stages ask at their
// end. Tracks that are lost are counted by the context, which then refuses to end.
#pragma once

#include <gtest/gtest.h>

#include "lib/stage/api/stage_handle.h"

inline void expect_no_lost_task(const clq_stage *stage)
{
    const claque::stage::Director &director = stage->director;
    if (!director.is_between_ticks()) return;  // the last step failed
    size_t found = director.scheduler.waiting();
    for (const clq_stage_class_info &one : director.scheduler.done) found += one.waiting;
    EXPECT_EQ(director.scheduler.held(), found) << "tasks that nothing will ever end";
}
