// From rows in order to people: where one ends and the next begins.
#include <algorithm>
#include <cmath>

#include "lib/asset/trajectories/assemble.h"
#include "lib/base/error.h"

namespace claque::asset
{

using base::text_of;

namespace
{

// The usual step is taken from so many pairs of rows at most.
constexpr size_t most_steps = 1 << 20;

enum class Break { none, person, gap, jump, boarding };

// Breaks of one kind, and the largest of them.
struct BreakTally {
    uint64_t count = 0;
    double worst = 0;
    Row at;
    void add(double size, const Row &row)
    {
        ++count;
        if (size > worst) worst = size, at = row;
    }
};

class Splitter
{
public:
    Splitter(Reading &reading, const TrajectoryOptions &options, Trajectories &out)
        : reading_(reading), options_(options), out_(out)
    {
        const double step = usual_step_s(reading.rows.all);
        gap_s_ = reading.joined ? HUGE_VAL : options.max_gap_s > 0 ? options.max_gap_s : std::max(2.5, 4 * step);
    }

    void split()
    {
        std::vector<Row> &rows = reading_.rows.all;
        reading_.budget.charge(rows.size() * sizeof(clq_trajectory_sample), "the samples");
        out_.samples.reserve(rows.size());
        const Row *before = nullptr;
        for (const Row &row : rows) {
            const Break here = break_before(before, row);
            before = &row;
            if (here != Break::none) begun_ = false;
            if (here == Break::person) part_ = 0;
            add(row);
        }
        report();
    }

private:
    Break break_before(const Row *before, const Row &row)
    {
        if (!before || before->person != row.person) return Break::person;
        if (before->flags != row.flags) return Break::boarding;
        if (row.time - before->time > gap_s_) {
            if (is_shown(row)) gaps_.add(row.time - before->time, row);
            return Break::gap;
        }
        // Vehicles are no people.
        if (row.flags) return Break::none;
        const double x = row.x - before->x, y = row.y - before->y;
        const double speed = std::sqrt(x * x + y * y) / (row.time - before->time);
        if (!(speed > options_.max_speed_m_s)) return Break::none;
        if (is_shown(row)) jumps_.add(speed, row);
        return Break::jump;
    }

    bool is_shown(const Row &row) const
    {
        return row.time >= options_.start_s && row.time <= options_.end_s && (!row.flags || options_.vehicles);
    }

    void add(const Row &row)
    {
        if (row.flags && !options_.vehicles) riding_.add(row.line);
        if (!is_shown(row)) return;
        if (!begun_) begin(row);
        Person &person = out_.people.back();
        ++person.count;
        if (reading_.heights) person.height_m = std::fmax(person.height_m, static_cast<float>(row.z));
        out_.samples.push_back({row.time, row.x, row.y, reading_.heights ? 0 : row.z, row.heading_rad, row.flags});
    }

    void begin(const Row &row)
    {
        begun_ = true;
        if (out_.people.size() == out_.people.capacity()) {
            const size_t more = std::max<size_t>(out_.people.capacity() / 2, 64);
            reading_.budget.charge(more * sizeof(Person), "the people");
            out_.people.reserve(out_.people.capacity() + more);
        }
        Person person;
        person.id = out_.ids.text(row.person);
        if (part_++ > 0) person.id = out_.ids.keep(text_of("%s#%llu", person.id, base::big(part_)));
        person.first = out_.samples.size();
        person.height_m = NAN;
        out_.people.push_back(person);
    }

    std::string where(const BreakTally &tally) const
    {
        return text_of("is that of %s at %.2f s (%s %u)", out_.ids.shown(tally.at.person).c_str(), tally.at.time,
                       reading_.place, tally.at.line);
    }

    void report()
    {
        std::vector<std::string> &warnings = reading_.warnings;
        if (gaps_.count)
            warnings.push_back("people are absent for longer than " + text_of("%g s in ", gap_s_) +
                               counted(gaps_.count, "place", "places") + ", and are others after it: the longest, " +
                               text_of("%.2f s, ", gaps_.worst) + where(gaps_));
        if (jumps_.count)
            warnings.push_back("people are faster than " + text_of("%g m/s in ", options_.max_speed_m_s) +
                               counted(jumps_.count, "place", "places") + ", and are others after it: the fastest, " +
                               text_of("%.1f m/s, ", jumps_.worst) + where(jumps_));
        if (riding_.count)
            warnings.push_back("left out " + counted(riding_.count, "row", "rows") + " of people in a vehicle" +
                               first_of(reading_, riding_.line));
        const auto alone = static_cast<uint64_t>(std::count_if(out_.people.begin(), out_.people.end(),
                                                               [](const Person &person) { return person.count == 1; }));
        if (alone) warnings.push_back(counted(alone, "person has", "people have") + " one sample only" + first_alone());
    }

    std::string first_alone() const
    {
        const auto found = std::find_if(out_.people.begin(), out_.people.end(),
                                        [](const Person &person) { return person.count == 1; });
        return text_of("; the first, at %.2f s, is '%.60s'", out_.samples[found->first].time_s, found->id);
    }

    Reading &reading_;
    const TrajectoryOptions &options_;
    Trajectories &out_;
    double gap_s_ = 0;
    bool begun_ = false;
    uint64_t part_ = 0;  // people that the present id has become
    BreakTally gaps_, jumps_;
    Tally riding_;
};

// Fills in when most people are there at once.
void count_at_once(Trajectories &out)
{
    std::vector<double> begins, ends;
    begins.reserve(out.people.size()), ends.reserve(out.people.size());
    for (const Person &person : out.people) {
        begins.push_back(out.samples[person.first].time_s);
        ends.push_back(out.samples[person.first + person.count - 1].time_s);
    }
    std::sort(begins.begin(), begins.end());
    std::sort(ends.begin(), ends.end());
    size_t gone = 0;
    for (size_t come = 0; come < begins.size(); ++come) {
        while (ends[gone] < begins[come]) ++gone;
        const uint32_t there = static_cast<uint32_t>(come + 1 - gone);
        if (there > out.facts.most_at_once) out.facts.most_at_once = there, out.facts.most_at_once_s = begins[come];
    }
}

}  // namespace

double usual_step_s(const std::vector<Row> &rows)
{
    std::vector<double> steps;
    const size_t stride = rows.size() / most_steps + 1;
    for (size_t i = 1; i < rows.size(); i += stride)
        if (rows[i].person == rows[i - 1].person) steps.push_back(rows[i].time - rows[i - 1].time);
    if (steps.empty()) return 0;
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>((steps.size() - 1) / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return *middle;
}

void split_into_people(Reading &reading, const TrajectoryOptions &options, Trajectories &out)
{
    out.facts.step_s = usual_step_s(reading.rows.all);
    Splitter(reading, options, out).split();
    if (out.people.empty())
        base::fail(CLQ_ARGUMENT,
                   "no person has a sample from %g to %g s: --vehicles (vehicles) reads vehicles too, and start_s "
                   "and end_s choose other times",
                   options.start_s, options.end_s);
}

void describe(Trajectories &out)
{
    clq_trajectories_info &facts = out.facts;
    facts.person_count = static_cast<uint32_t>(out.people.size());
    facts.sample_count = out.samples.size();
    facts.min_s = HUGE_VAL, facts.max_s = -HUGE_VAL;
    std::fill_n(facts.box_min_m, 3, HUGE_VAL);
    std::fill_n(facts.box_max_m, 3, -HUGE_VAL);
    for (const clq_trajectory_sample &sample : out.samples) {
        facts.min_s = std::min(facts.min_s, sample.time_s), facts.max_s = std::max(facts.max_s, sample.time_s);
        const double place[] = {sample.x, sample.y, sample.z};
        for (int k = 0; k < 3; ++k) {
            facts.box_min_m[k] = std::min(facts.box_min_m[k], place[k]);
            facts.box_max_m[k] = std::max(facts.box_max_m[k], place[k]);
        }
        facts.has_headings = facts.has_headings || !std::isnan(sample.heading_rad);
    }
    count_at_once(out);
    facts.warning_count = static_cast<uint32_t>(out.warnings.size());
}

}  // namespace claque::asset
