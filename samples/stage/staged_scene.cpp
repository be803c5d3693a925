#include "samples/stage/staged_scene.h"

#include "samples/stage/door_leaves.h"

namespace staged
{

using namespace scenes;

namespace
{

class Staged final : public StagedScene, public SocialClasses
{
public:
    Staged(Library &library, const CrowdOptions &crowd_options, const Scenario &scenario, const StageOptions &options)
        : setting_(make_setting(library, scenario, crowd_options.seed)),
          run_(library, crowd_options, scenario, *setting_, options.run),
          leaves_(scenario.stage->doors),
          flows_(run_, options.apart, options.run.live)
    {
        for (const Person &person : run_.people().all()) classes_.push_back(scenario.characters[person.member].name);
    }

    Run &run() override { return run_; }
    double behind_s() override { return flows_.behind_s(); }
    double kept_s() override { return flows_.kept_s(); }
    void rest() override { flows_.rest(); }
    std::vector<uint8_t> save() override
    {
        flows_.rest();
        return run_.save();
    }
    void restore(const std::vector<uint8_t> &bytes) override
    {
        flows_.rest();
        run_.restore(bytes);
        flows_.begin_again();
    }
    clq_crowd *crowd() const override { return run_.crowd(); }
    std::vector<clq_actor> actors() const override { return run_.people().actors(); }
    std::string class_of(size_t person) const override { return classes_[person]; }
    std::vector<clq_template *> templates() const override { return run_.templates(); }
    clq_camera camera(Shot shot, double aspect, double) const override { return setting_->camera(shot, aspect); }

    void place(double time_s) override
    {
        run_.look(time_s, [this](double look_s) { flows_.reach(look_s); });
        flows_.reach(time_s);
        run_.show(time_s);
    }

    std::optional<Mind> mind_of(clq_actor actor) const override
    {
        const std::vector<Person> &all = run_.people().all();
        for (uint32_t person = 0; person < all.size(); ++person)
            if (all[person].actor.index1 == actor.index1) return run_.mind_of(person);
        return {};
    }

    bool take_shadows(clq_shadow_def &def) override { return take_shadows_of(*setting_, def); }

    void prepare(const Gl &gl) override { setting_->prepare(gl); }

    void set_light(const Gl &gl, const Eye &eye) const override { setting_->set_light(gl, eye); }
    void draw_environment(const Gl &gl, const Eye &eye) const override
    {
        setting_->draw(gl, eye);
        leaves_.draw(gl, [this](size_t door) { return is_open(crowd(), door).value_or(true); });
    }

private:
    std::unique_ptr<Setting> setting_;
    Run run_;
    DoorLeaves leaves_;
    std::vector<std::string> classes_;
    Flows flows_;  // the last one: its thread uses all above
};

}  // namespace

std::unique_ptr<StagedScene> make_staged(Library &library, const CrowdOptions &crowd_options, const Scenario &scenario,
                                         const StageOptions &options)
{
    return std::make_unique<Staged>(library, crowd_options, scenario, options);
}

std::unique_ptr<Scene> make_scenario(Library &library, const CrowdOptions &crowd_options, const Scenario &scenario)
{
    return make_staged(library, crowd_options, scenario, {});
}

}  // namespace staged
