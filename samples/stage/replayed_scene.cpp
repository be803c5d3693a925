#include "samples/stage/replayed_scene.h"

#include "samples/scenes/shadows.h"
#include "samples/stage/door_leaves.h"
#include "samples/stage/setting.h"

namespace staged
{

using namespace scenes;

namespace
{

class Replayed final : public Scene
{
public:
    Replayed(Library &library, const CrowdOptions &crowd_options, const Scenario &scenario,
             const walkers::ReplayOptions &options)
        : setting_(make_setting(library, scenario, crowd_options.seed)),
          people_(walkers::make_replay(library, crowd_options, options)),
          doors_(scenario.stage->doors),
          leaves_(doors_),
          follows_(!options.follow.empty())
    {
    }

    clq_crowd *crowd() const override { return people_->crowd(); }
    std::vector<clq_template *> templates() const override { return people_->templates(); }
    void place(double time_s) override { people_->place(time_s); }

    std::optional<ReadPart> read_part() const override { return people_->read_part(); }

    clq_camera camera(Shot shot, double aspect, double time_s) const override
    {
        return follows_ ? people_->camera(shot, aspect, time_s) : setting_->camera(shot, aspect);
    }

    bool take_shadows(clq_shadow_def &def) override { return take_shadows_of(*setting_, def); }
    void prepare(const Gl &gl) override { setting_->prepare(gl); }

    void set_light(const Gl &gl, const Eye &eye) const override { setting_->set_light(gl, eye); }
    void draw_environment(const Gl &gl, const Eye &eye) const override
    {
        setting_->draw(gl, eye);
        leaves_.draw(gl, [this](size_t door) { return is_open(crowd(), door).value_or(doors_[door].open); });
    }

private:
    std::unique_ptr<Setting> setting_;
    std::unique_ptr<Scene> people_;
    const std::vector<ScenarioDoor> doors_;
    DoorLeaves leaves_;
    const bool follows_;
};

}  // namespace

std::unique_ptr<Scene> make_replayed(Library &library, const CrowdOptions &crowd_options, const Scenario &scenario,
                                     const walkers::ReplayOptions &options)
{
    return std::make_unique<Replayed>(library, crowd_options, scenario, options);
}

}  // namespace staged
