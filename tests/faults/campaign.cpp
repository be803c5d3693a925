#include "tests/faults/campaign.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "tests/api/failing_memory.h"
#include "tests/faults/child.h"
#include "tests/faults/watched_gl.h"
#include "tests/support/patterns.h"

namespace fm = failing_memory;

namespace faults
{

const Effort brief = {4, 2, 7, 100, 10000, 1}, thorough = {200, 0.1, 12, ~0ull, ~0ull, 3};

namespace
{

// What a call without a fault gives.
struct Good {
    std::string before, after, future;
    uint64_t found = 0, allocations = 0;
    int64_t blocks = 0;  // that are not given back when the world has ended
    std::vector<fm::Place> places;
};

// With allocation n failing; `seen` counts them. The one function that arms, so that a place is the same for all.
[[gnu::noinline]] clq_status attempt(World &world, const Call &call, uint64_t n, bool persistent, uint64_t &seen)
{
    world.made = World::untouched;
    world.found = 0;
    fm::arm(n, fm::Reach::everything, persistent);
    const clq_status status = call.run(world);
    seen = fm::disarm();
    return status;
}

clq_status attempt(World &world, const Call &call)
{
    uint64_t seen = 0;
    return attempt(world, call, 0, false, seen);
}

void finish(World &world, const Call &call)
{
    if (call.after) call.after(world);
}

std::string separated(const std::vector<std::string> &parts)
{
    std::string all;
    for (const std::string &part : parts) all += part + '\x1f';
    return all;
}

std::vector<std::string> parts_of(const std::string &text)
{
    std::vector<std::string> parts;
    for (size_t at = 0, end; (end = text.find('\x1f', at)) != std::string::npos; at = end + 1)
        parts.push_back(text.substr(at, end - at));
    return parts;
}

std::string list_of(const std::vector<fm::Place> &places)
{
    std::string list;
    for (const fm::Place place : places) list += std::to_string(place) + ' ';
    return list;
}

// Ends the world. Returns how many blocks were not given back.
int64_t end(World *world, int64_t at_first)
{
    delete world;
    return fm::blocks() - at_first;
}

std::string run_good(World *world, const Call &call, uint32_t frames)
{
    static std::vector<fm::Place> places;
    places.reserve(1u << 21);
    const int64_t at_first = fm::blocks();
    if (call.before) call.before(*world);
    fm::note_places(&places, frames);
    uint64_t seen = 0;
    const clq_status status = attempt(*world, call, 0, false, seen);
    fm::note_places(nullptr, frames);
    if (status != CLQ_OK) return std::string("E ") + clq_status_name(status) + " without a fault: " + clq_last_error();
    static std::string found, after, future;
    if (call.traits & ends) return separated({std::to_string(seen), "", "", "", "0", ""});
    finish(*world, call);
    found = std::to_string(world->found);
    after = world->see();
    future = world->see_future();
    const int64_t own =
        int64_t(after.capacity() > 15) + int64_t(future.capacity() > 15) + int64_t(found.capacity() > 15);
    const int64_t lost = end(world, at_first) - own;
    return separated({std::to_string(seen), found, after, future, std::to_string(lost), list_of(places)});
}

std::string wrong(uint64_t n, const std::string &what) { return "E allocation " + std::to_string(n) + ": " + what; }

std::string check_refusal(const World &world, const Call &call, clq_status status, int64_t held)
{
    const std::string says = clq_last_error();
    if (status != CLQ_OUT_OF_MEMORY) return std::string(clq_status_name(status)) + ", " + says;
    const bool named = says.rfind(call.name + ": ", 0) == 0 || (call.traits & inside);
    if (!named || says.find("memory") == std::string::npos) return "it says '" + says + "'";
    if (world.made != World::untouched) return "out was written";
    if (!(call.traits & keeps) && fm::host_bytes() != held)
        return std::to_string(fm::host_bytes() - held) + " bytes of the host stay behind";
    return "";
}

// With allocation n failing, and later ones too if `persistent`.
std::string run_fault(World *world, const Call &call, uint64_t n, bool persistent, const Good &good)
{
    const int64_t at_first = fm::blocks();
    if (call.before) call.before(*world);
    const int64_t held = fm::host_bytes();
    uint64_t seen = 0;
    clq_status status = attempt(*world, call, n, persistent, seen);
    if (seen < n) return wrong(n, "only " + std::to_string(seen) + " were asked for this time");
    const bool refused = status != CLQ_OK;
    if (refused) {
        const std::string problem = check_refusal(*world, call, status, held);
        if (!problem.empty()) return wrong(n, problem);
        const std::string changed = difference(good.before, world->see());
        if (!changed.empty()) return wrong(n, "the failed call has changed " + changed);
        if (call.before) call.before(*world);
        status = attempt(*world, call);
        if (status != CLQ_OK)
            return wrong(
                n, std::string("the next call fails as well: ") + clq_status_name(status) + ", " + clq_last_error());
    }
    if ((call.traits & counts) && world->left_out() > 0) {
        status = attempt(*world, call);
        if (status != CLQ_OK || world->left_out() > 0)
            return wrong(n, "the next update leaves individuals out as well");
    }
    finish(*world, call);
    const char *when = refused ? "after the next call: " : "though the call succeeded: ";
    if (world->found != good.found) return wrong(n, std::string(when) + "another result");
    {
        const std::string changed = difference(good.after, world->see());
        const std::string later = difference(good.future, world->see_future());
        if (!changed.empty() || !later.empty()) return wrong(n, when + changed + later);
    }
    const int64_t lost = end(world, at_first) - good.blocks;
    if (lost != 0) return wrong(n, std::to_string(lost) + " blocks are lost");
    return (refused ? "F " : "W ") + std::to_string(fm::failed_place());
}

// The numbers of the allocations to fail: those of the plan, and the first at each place.
std::vector<uint64_t> plan(const Good &good, const Effort &effort, bool is_long)
{
    std::set<uint64_t> numbers;
    const uint64_t each = good.allocations > effort.large ? 1 : effort.each;
    const double growth = good.allocations > effort.large ? 9 : effort.growth;
    for (double n = 1; n <= double(good.allocations); n = n < double(each) ? n + 1 : std::ceil(n * (1 + growth)))
        numbers.insert(uint64_t(n));
    // The last ones, after which a call has least left to do.
    for (uint64_t left = 0; left < 3 && left < good.allocations; ++left) numbers.insert(good.allocations - left);
    std::set<fm::Place> met;
    for (size_t i = 0; i < good.places.size() && !is_long; ++i)
        if (met.insert(good.places[i]).second) numbers.insert(i + 1);
    return {numbers.begin(), numbers.end()};
}

std::string read_good(World &world, const Call &call, const Effort &effort, Good &good)
{
    if (!(call.traits & ends)) {
        const Told before = in_child([&] {
            if (call.before) call.before(world);
            return world.see();
        });
        if (!before.end.empty() || before.text[0] == 'E') return "before the call: " + before.end + before.text;
        good.before = before.text;
    }
    const Told told = in_child([&] { return run_good(&world, call, effort.frames); });
    if (!told.end.empty() || told.text.rfind("E ", 0) == 0) return told.end + told.text;
    const std::vector<std::string> parts = parts_of(told.text);
    if (parts.size() != 6) return "the call told nothing";
    good.allocations = std::stoull(parts[0]);
    good.found = parts[1].empty() ? 0 : std::stoull(parts[1]);
    good.after = parts[2], good.future = parts[3], good.blocks = std::stoll(parts[4]);
    std::istringstream places(parts[5]);
    for (fm::Place place; places >> place;) good.places.push_back(place);
    return "";
}

// In the state that the world is in.
void try_state(World &world, const Call &call, const Effort &effort, Outcome &outcome)
{
    Good good;
    outcome.problem = read_good(world, call, effort, good);
    outcome.allocations += good.allocations;
    if (!outcome.problem.empty() || good.allocations == 0 || (call.traits & (quiet | ends))) return;
    std::set<fm::Place> wanted(good.places.begin(), good.places.end()), failed;
    const bool is_long = good.allocations > effort.each_place;
    fm::note_places(nullptr, effort.frames);
    for (const uint64_t n : plan(good, effort, is_long))
        for (const bool persistent : {false, true}) {
            if (persistent && (n > effort.each || good.allocations > effort.large)) continue;
            const Told told = in_child([&] { return run_fault(&world, call, n, persistent, good); });
            if (!told.end.empty()) outcome.problem = wrong(n, told.end);
            else if (told.text.empty() || told.text[0] == 'E') outcome.problem = told.text;
            if (!outcome.problem.empty()) {
                outcome.problem += persistent ? " (all later ones fail too)" : "";
                return;
            }
            ++outcome.faults;
            outcome.did_without += told.text[0] == 'W';
            failed.insert(std::stoull(told.text.substr(2)));
        }
    if (is_long) return;
    outcome.places += wanted.size();
    for (const fm::Place place : wanted) outcome.failed_places += failed.count(place);
}

// The steps of growth at which the call allocates, at most `states` of them; the first is 0 where it never does.
std::vector<uint32_t> steps_that_allocate(World &world, const Call &call, uint32_t states)
{
    const Told told = in_child([&] {
        std::string found;
        uint32_t count = 0;
        for (uint32_t step = 0; step < 70 && count < states; ++step) {
            if (step) world.grow();
            uint64_t seen = 0;
            (void)attempt(world, call, 0, false, seen);
            if (seen > 0) found += std::to_string(step) + ' ', ++count;
        }
        return found;
    });
    std::vector<uint32_t> steps;
    std::istringstream text(told.text);
    for (uint32_t step; text >> step;) steps.push_back(step);
    if (steps.empty()) steps.push_back(0);
    return steps;
}

void grow_to(World &world, const Call &call, uint32_t step)
{
    for (uint32_t i = 0; i < step; ++i) {
        (void)attempt(world, call);
        world.grow();
    }
}

std::string text_of(const Outcome &o)
{
    return separated({std::to_string(o.allocations), std::to_string(o.faults), std::to_string(o.did_without),
                      std::to_string(o.places), std::to_string(o.failed_places), o.problem});
}

}  // namespace

Outcome try_call(World &world, const Call &call, const Effort &effort)
{
    world.sees_assets = call.name.rfind("clq_asset_", 0) == 0;
    world.builds_assets = patterns::describes("clq_asset_(add|set|make)_.*", call.name);
    const std::vector<uint32_t> steps = (call.traits & grows) && !(call.traits & ends)
                                            ? steps_that_allocate(world, call, effort.states)
                                            : std::vector<uint32_t>{0};
    Outcome all;
    for (const uint32_t step : steps) {
        const Told told = in_child([&] {
            Outcome outcome;
            grow_to(world, call, step);
            try_state(world, call, effort, outcome);
            return text_of(outcome);
        });
        const std::vector<std::string> parts = parts_of(told.text);
        if (parts.size() != 6) {
            all.problem = told.end + told.text;
            return all;
        }
        all.allocations += std::stoull(parts[0]), all.faults += std::stoull(parts[1]);
        all.did_without += std::stoull(parts[2]);
        all.places += std::stoull(parts[3]), all.failed_places += std::stoull(parts[4]);
        all.problem = parts[5];
        if (!all.problem.empty()) return all;
    }
    return all;
}

}  // namespace faults
