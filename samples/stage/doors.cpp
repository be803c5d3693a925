// Doors: opened and closed at the times of the scenario, and by `call = "open NAME"` and `call = "close NAME"`. The
// people that go through are counted.
#include "samples/stage/doors.h"

#include <algorithm>
#include <cmath>

#include "samples/stage/run.h"

namespace staged
{
namespace
{

// The longest side is as wide as the door.
double width_of(const scenes::Outline &outline)
{
    double widest = 0;
    for (size_t i = 0; i < outline.size(); i += 2) {
        const size_t next = (i + 2) % outline.size();
        widest = std::max(widest, std::hypot(outline[next] - outline[i], outline[next + 1] - outline[i + 1]));
    }
    return widest;
}

class Doors final : public Service
{
public:
    explicit Doors(const scenes::Staging &stage)
        : doors_(stage.doors), next_(doors_.size(), 0), within_(doors_.size()), passed_s_(doors_.size())
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
        for (size_t i = 0; i < doors_.size(); ++i) count(run, i);
        for (size_t i = 0; i < doors_.size(); ++i)
            for (; next_[i] < doors_[i].changes.size() && doors_[i].changes[next_[i]].at_s <= end_s; ++next_[i])
                set(run, i, doors_[i].changes[next_[i]].open, doors_[i].changes[next_[i]].at_s);
    }

    void tell(std::vector<DoorCount> &out) const override
    {
        for (size_t i = 0; i < doors_.size(); ++i)
            out.push_back({doors_[i].name, width_of(doors_[i].outline), passed_s_[i]});
    }

    void put(BytesOut &out) const override
    {
        for (const std::vector<uint32_t> &of : within_) {
            out.put<uint64_t>(of.size());
            for (const uint32_t person : of) out.put(person);
        }
        for (const std::vector<double> &of : passed_s_) {
            out.put<uint64_t>(of.size());
            for (const double at_s : of) out.put(at_s);
        }
        for (size_t i = 0; i < doors_.size(); ++i) out.put<uint64_t>(next_[i]), out.put<uint8_t>(is_open_[i]);
    }
    void take(Run &run, BytesIn &in) override
    {
        for (std::vector<uint32_t> &of : within_) {
            of.resize(in.count(run.people().all().size()));
            for (uint32_t &person : of) person = in.take<uint32_t>();
        }
        for (std::vector<double> &of : passed_s_) {
            of.resize(in.count(uint64_t(1) << 20));
            for (double &at_s : of) at_s = in.take<double>();
        }
        for (size_t i = 0; i < doors_.size(); ++i) {
            next_[i] = in.count(doors_[i].changes.size());
            is_open_[i] = in.take<uint8_t>() != 0;
            scenes::check(clq_navigation_set_door(run.navigation(), static_cast<uint32_t>(i), is_open_[i]));
        }
    }

private:
    // A person passes on leaving the door.
    void count(Run &run, size_t door)
    {
        std::vector<uint32_t> now;
        for (const uint32_t person : run.here()) {
            const std::array<double, 3> at = run.place_of(person);
            if (is_within(doors_[door].outline, at[0], at[2])) now.push_back(person);
        }
        for (const uint32_t person : within_[door])
            if (!std::binary_search(now.begin(), now.end(), person)) passed_s_[door].push_back(run.decided_s());
        within_[door] = std::move(now);
    }

    void set(Run &run, size_t door, bool open, double at_s)
    {
        if (is_open_[door] == open) return;
        is_open_[door] = open;
        run.set_door(static_cast<uint32_t>(door), open, at_s);
    }

    std::vector<scenes::ScenarioDoor> doors_;
    std::vector<size_t> next_;  // of the changes of each
    std::vector<bool> is_open_;
    std::vector<std::vector<uint32_t>> within_;  // people, ascending
    std::vector<std::vector<double>> passed_s_;
};

}  // namespace

double flow_of(std::vector<double> times_s, double width_m)
{
    if (times_s.size() < 20) return 0;
    std::sort(times_s.begin(), times_s.end());
    const size_t first = times_s.size() / 10, last = times_s.size() * 9 / 10 - 1;
    return static_cast<double>(last - first) / (times_s[last] - times_s[first]) / width_m;
}

std::unique_ptr<Service> make_doors(const scenes::Staging &stage) { return std::make_unique<Doors>(stage); }

}  // namespace staged
