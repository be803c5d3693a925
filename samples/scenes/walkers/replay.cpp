#include "samples/scenes/walkers/replay.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "lib/base/near_names.h"
#include "samples/scenes/light.h"
#include "samples/scenes/shadows.h"
#include "samples/scenes/sky.h"
#include "samples/scenes/stone.h"
#include "samples/scenes/walkers/ground.h"
#include "samples/scenes/walkers/plain.h"
#include "samples/scenes/walkers/record_positions.h"

namespace scenes::walkers
{

namespace
{

// Where people are in some moments of a record, and their numbers.
struct Box {
    double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    std::set<uint32_t> seen;
    bool empty() const { return !(low[0] <= high[0]); }
};

Box box_of(Library &library, const RecordFile &file)
{
    constexpr int moments = 8;
    RecordPlaces places(library, file);
    Box box;
    for (int k = 0; k <= moments; ++k)
        places.at(file.info.start_s + (file.info.end_s - file.info.start_s) * k / moments,
                  [&](clq_actor actor, const double *position) {
                      box.seen.insert(actor.index1);
                      for (int axis = 0; axis < 3; ++axis)
                          box.low[axis] = std::min(box.low[axis], position[axis]),
                          box.high[axis] = std::max(box.high[axis], position[axis]);
                  });
    return box;
}

uint32_t number_of(const std::string &text)
{
    if (text.empty() || text.size() > 9 || text.find_first_not_of("0123456789") != std::string::npos)
        throw Failure("the camera is to follow '" + text + "': the actors of a record have numbers, from 1 on");
    return static_cast<uint32_t>(std::stoul(text));
}

// Looks through all steps for an actor that was in none of the moments.
void expect_actor(Library &library, const RecordFile &file, uint32_t number, std::set<uint32_t> seen)
{
    RecordPlaces places(library, file);
    for (uint64_t step = 0; step < file.info.step_count && seen.count(number) == 0; ++step) {
        double time_s = 0;
        check(clq_record_get_time(file.record.get(), step, &time_s));
        places.at(time_s, [&](clq_actor actor, const double *) { seen.insert(actor.index1); });
    }
    if (seen.count(number) > 0) return;
    std::vector<std::string> names;
    for (const uint32_t one : seen) names.push_back(std::to_string(one));
    const std::string name = std::to_string(number);
    throw Failure("no actor has the number " + name + " that the camera is to follow" +
                  claque::base::names_near(name, names));
}

clq_crowd_def def_of(const clq_record *record, const CrowdOptions &options)
{
    clq_crowd_def def = clq_crowd_def_init();
    check(clq_record_get_crowd_def(record, &def));
    // How it is drawn, not what is shown.
    def.cache = options.cache, def.cache_budget_bytes = options.cache_budget_bytes;
    def.cull = options.cull, def.rigid_mode = options.rigid_mode;
    return def;
}

class Replay final : public Scene
{
public:
    Replay(Library &library, const CrowdOptions &crowd_options, const ReplayOptions &options)
        : library_(library),
          file_(library, options.file),
          cast_(library, file_, options.characters),
          plain_(crowd_options.seed, Daylight())
    {
        const clq_crowd_def def = def_of(file_.record.get(), crowd_options);
        clq_crowd *made = nullptr;
        check(clq_crowd_create(library.context(), &def, &made), options.file);
        crowd_.reset(made);
        Box box = box_of(library, file_);
        if (!options.follow.empty()) {
            followed_ = number_of(options.follow);
            followed_places_.emplace(library, file_);
            expect_actor(library, file_, *followed_, box.seen);
        }
        if (box.empty()) box = {{-5, 0, -5}, {5, 0, 5}, {}};
        plan_.half_x = std::max(1.0, (box.high[0] - box.low[0]) / 2);
        plan_.half_z = std::max(1.0, (box.high[2] - box.low[2]) / 2);
        plan_.middle_x = (box.high[0] + box.low[0]) / 2, plan_.middle_z = (box.high[2] + box.low[2]) / 2;
        plan_.ground = box.low[1];
        lay(library, Options(), plan_, plain_.ground());
        place(file_.info.start_s);
    }

    clq_crowd *crowd() const override { return crowd_.get(); }
    std::vector<clq_template *> templates() const override { return cast_.templates(); }

    clq_camera camera(Shot shot, double aspect, double) const override
    {
        const double x = plan_.middle_x, y = plan_.ground, z = plan_.middle_z;
        if (followed_) {
            const double *p = followed_at_;
            return look({p[0], p[1] + 2.4, p[2] + 5}, {p[0], p[1] + 1, p[2]}, 48, aspect, 0.2, far_of(plan_));
        }
        if (shot != Shot::close) return overview_of(plan_, aspect);
        return look({x, y + 1.62, z + plan_.half_z + 3}, {x, y + 1.2, z + plan_.half_z - 3}, 50, aspect, 0.2,
                    far_of(plan_));
    }

    void place(double time_s) override
    {
        check(clq_record_play(file_.record.get(), crowd_.get(), time_s));
        if (followed_) find_followed(time_s);
        warn_of_other_times(time_s);
    }

    std::optional<ReadPart> read_part() const override
    {
        clq_record_info info = clq_record_info_init();
        check(clq_record_get_info(file_.record.get(), &info));
        return ReadPart{"bytes", info.read_bytes, file_.bytes.size()};
    }

    bool take_shadows(clq_shadow_def &def) override
    {
        def = shadows_in(plain_.light());
        def.plane_height = plan_.ground;
        return true;
    }

    void prepare(const Gl &gl) override { plain_.prepare(gl); }

    void set_light(const Gl &g, const Eye &eye) const override { plain_.set_light(g, eye); }
    void draw_environment(const Gl &g, const Eye &eye) const override { plain_.draw(g, eye); }

private:
    void warn_of_other_times(double time_s) const
    {
        constexpr double around_s = 1;
        const double start_s = file_.info.start_s, end_s = file_.info.end_s;
        if (time_s >= start_s - around_s && time_s <= end_s + around_s) return;
        char text[120];
        std::snprintf(text, sizeof text, "the record runs from %.6g to %.6g s: pictures of other times show its %s",
                      start_s, end_s, time_s < start_s ? "first step" : "end");
        clq_context_log(library_.context(), CLQ_LOG_WARNING, text);
    }

    // The actor that has this number now, whichever it is. One whose track has ended is absent.
    void find_followed(double time_s)
    {
        bool found = false;
        followed_places_->at(time_s, [&](clq_actor actor, const double *position) {
            if (actor.index1 != *followed_) return;
            found = true;
            followed_at_[0] = position[0], followed_at_[1] = plan_.ground, followed_at_[2] = position[2];
        });
        if (found) return;
        clq_context_log(library_.context(), CLQ_LOG_WARNING,
                        ("actor " + std::to_string(*followed_) +
                         " is absent at some of the times shown: the camera that follows waits")
                            .c_str());
    }

    Library &library_;
    RecordFile file_;
    RecordCast cast_;
    Own<clq_crowd> crowd_;
    Plan plan_;
    Plain plain_;
    std::optional<uint32_t> followed_;
    std::optional<RecordPlaces> followed_places_;
    double followed_at_[3] = {0, 0, 0};
};

}  // namespace

std::unique_ptr<Scene> make_replay(Library &library, const CrowdOptions &crowd_options, const ReplayOptions &options)
{
    return std::make_unique<Replay>(library, crowd_options, options);
}

}  // namespace scenes::walkers
