// The people in view of a run's camera, looked up at fixed times: what decisions hear does not depend on which frames
// are drawn. The flow that draws looks; the flow of decisions takes what was seen when its time has come.
#pragma once

#include <claque/scene.h>
#include <claque/stage.h>

#include <deque>
#include <mutex>
#include <vector>

#include "samples/stage/bytes.h"
#include "samples/stage/people.h"

namespace staged
{

class Sights
{
public:
    static constexpr double every_s = 0.5;

    // `lead_s`: what is seen is heard so long afterwards.
    Sights(const People &people, double lead_s);

    // The flow that draws.
    double next_s() const { return static_cast<double>(looks_) * every_s; }
    void look(const clq_camera &camera);  // at next_s()

    // The flow of decisions: tells the stage which agents came into view or left it, up to the end of its next tick.
    void tell(clq_stage *stage, const std::vector<clq_agent> &agents, double end_s);
    void came(uint32_t person) { in_view_[person] = true; }  // as its stage has it

    // With both flows at rest. take() throws Failure.
    void put(BytesOut &out) const;
    void take(BytesIn &in);

private:
    struct Sight {
        double heard_s;
        std::vector<uint32_t> people;  // ascending
    };

    const People &people_;
    double lead_s_;
    clq_scene *scene_ = nullptr;       // of the crowd, which ends it
    std::vector<uint32_t> person_of_;  // by actor
    std::vector<clq_scene_hit> hits_;
    uint64_t looks_ = 0;
    std::vector<bool> in_view_;  // by person, as its stage has it
    mutable std::mutex mutex_;
    std::deque<Sight> sights_;
};

}  // namespace staged
