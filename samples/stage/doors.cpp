// Doors: opened and closed at the times of the scenario, and by `call = "open NAME"` and `call = "close NAME"`.
#include "samples/stage/run.h"

namespace staged
{
namespace
{

class Doors final : public Service
{
public:
    explicit Doors(const scenes::Staging &stage) : doors_(stage.doors), next_(doors_.size(), 0)
    {
        for (const scenes::ScenarioDoor &door : doors_) is_open_.push_back(door.open);
    }

    std::vector<std::string> actions() const override
    {
        std::vector<std::string> names;
        for (const scenes::ScenarioDoor &door : doors_)
            names.insert(names.end(), {"open " + door.name, "close " + door.name});
        return names;
    }

    void serve(Run &run, size_t action, const Call &call) override
    {
        set(run, action / 2, action % 2 == 0, call.time_s);
    }

    void before_tick(Run &run, double end_s) override
    {
        for (size_t i = 0; i < doors_.size(); ++i)
            for (; next_[i] < doors_[i].changes.size() && doors_[i].changes[next_[i]].at_s <= end_s; ++next_[i])
                set(run, i, doors_[i].changes[next_[i]].open, doors_[i].changes[next_[i]].at_s);
    }

    void put(BytesOut &out) const override
    {
        for (size_t i = 0; i < doors_.size(); ++i) out.put<uint64_t>(next_[i]), out.put<uint8_t>(is_open_[i]);
    }
    void take(Run &run, BytesIn &in) override
    {
        for (size_t i = 0; i < doors_.size(); ++i) {
            next_[i] = in.count(doors_[i].changes.size());
            is_open_[i] = in.take<uint8_t>() != 0;
            scenes::check(clq_navigation_set_door(run.navigation(), static_cast<uint32_t>(i), is_open_[i]));
        }
    }

private:
    void set(Run &run, size_t door, bool open, double at_s)
    {
        if (is_open_[door] == open) return;
        is_open_[door] = open;
        run.set_door(static_cast<uint32_t>(door), open, at_s);
    }

    std::vector<scenes::ScenarioDoor> doors_;
    std::vector<size_t> next_;  // of the changes of each
    std::vector<bool> is_open_;
};

}  // namespace

std::unique_ptr<Service> make_doors(const scenes::Staging &stage) { return std::make_unique<Doors>(stage); }

}  // namespace staged
