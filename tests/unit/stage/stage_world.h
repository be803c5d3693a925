// A stage over the crowd of one arm, whose clips are slow (2 s, markers "down" at 0.5 and 1.25 s), fast (1 s, "down" at
// 0.25 s), bent (1 s) and wave (0.5 s).
#pragma once

#include <claque/stage.h>

#include <string>
#include <vector>

#include "tests/api/arm.h"

// A machine with some names declared, and the rest of its text.
std::string machine_text(const std::string &rest);

class StageWorld
{
public:
    explicit StageWorld(const clq_stage_def *def = nullptr);
    ~StageWorld();
    StageWorld(const StageWorld &) = delete;
    StageWorld &operator=(const StageWorld &) = delete;

    clq_machine machine(const std::string &text);
    // The refusal of a text that is no machine; "" if it is one.
    std::string refusal(const std::string &text);
    clq_agent agent(clq_machine machine, double x = 0, const char *agent_class = nullptr, uint64_t seed = 1);
    clq_agent actor_agent(clq_machine machine);  // that directs the arm's actor
    void step(double until_s);
    // Brings the crowd to a time that is decided.
    clq_stage_applied apply(double time_s);
    std::string state(clq_agent agent) const;
    double entered_s(clq_agent agent) const;
    double variable(clq_agent agent, const char *name) const;
    double crowd_variable(const char *name) const { return variable({}, name); }
    void send(const char *name, double at_s, double value = 0);
    void send_to(clq_agent agent, const char *name, double at_s, double value = 0);
    clq_stage_info info() const;

    Arm arm;
    clq_stage *stage = nullptr;
};
