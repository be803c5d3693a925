// What a saved stage and its agents may hold, on both sides of each bound.
#include "tests/unit/stage/saved_rules.h"

using namespace saved_rules;

TEST_F(SavedRules, OfTheWhole)
{
    ASSERT_EQ(good_.agents[0].depth, 2u);
    ASSERT_EQ(good_.agents[1].depth, 0u);
    TAKES([](SavedStage &) {});
    REFUSES("the crowd has other variables", [](SavedStage &s) { s.crowd.push_back(0); });
    REFUSES("the classes of agents are wrong", [](SavedStage &s) { s.classes.clear(); });
    REFUSES("the classes of agents are wrong", [](SavedStage &s) { s.classes[0] = "a"; });
    REFUSES("a timetable sends no event", [](SavedStage &s) { s.timetable[0].task.kind = TaskKind::set; });
    RANGE("a timetable repeats wrongly", s.timetable[0].every_s, {0, 0.01, 1e9}, {0.0099, 1.001e9, -1, NAN});
    RANGE("an event is unknown", s.timetable[0].task.index, {4}, {5});
    RANGE("a class has no credit", s.queues[2].credit, {0, 1e300}, {-1e-9, INFINITY, NAN});
    RANGE("a class has waited for no time", s.done[3].longest_wait_s, {0, 1e300}, {-1e-9, INFINITY, NAN});
    const auto order = [](uint64_t value) { return [=](SavedStage &s) { s.next_order = value; }; };
    TAKES(order(own_order));
    REFUSES("a count is too large", order(own_order - 1));
    RANGE("a count is too large", s.unit_us, {0, 1e300}, {-1e-9, INFINITY, NAN});
    RANGE("a count is too large", s.tick, {199999999000}, {200000001000});
    RANGE("a count is too large", s.shown_s, {-1e300}, {-INFINITY, NAN});
    RANGE("a mask is unknown", (s.masks.resize(1), s.masks[0].machine), {0}, {1});
    RANGE("a mask is unknown", (s.masks.resize(1), s.masks[0].cast), {0}, {1});
    RANGE("a mask is unknown", (s.masks.resize(1), s.masks[0].mask), {0}, {1});
    TAKES([](SavedStage &s) { s.rows.resize(s.agents.size()); });
    REFUSES("more actors than agents", [](SavedStage &s) { s.rows.resize(s.agents.size() + 1); });
    const Forge follows = [](SavedStage &s) { s.rows.resize(2), s.rows[1].tracks[0] = {1}; };
    REFUSES("an actor walks that cannot", follows);
    give_locomotion();
    TAKES(follows);
}

TEST_F(SavedRules, OfWhatMoves)
{
    const Forge moves = [](SavedStage &s) { s.movement = {1}; },
                walks = [](SavedStage &s) { s.movement = {1}, s.agents[0].is_walker = true; };
    REFUSES("its agents walk otherwise", moves);
    give_locomotion();
    REFUSES("an agent walks that cannot", walks);  // there is no ground
    director().movement = std::make_unique<Standing>();
    TAKES(moves);
    TAKES(walks);
    REFUSES("its agents walk otherwise", [](SavedStage &) {});
    cast().locomotion = nullptr;
    REFUSES("an agent walks that cannot", walks);
    director().movement.reset();
}

TEST_F(SavedRules, OfAnAgent)
{
    RANGE("an agent runs a machine that there is not", s.agents[1].machine, {0}, {1});
    RANGE("an agent has no template", s.agents[1].cast, {0}, {1});
    RANGE("an agent has no template", s.agents[1].agent_class, {0, 1}, {2});
    RANGE("an agent is nowhere", s.agents[0].scale, {1e-30, 1e30}, {0, -1, INFINITY, NAN});
    RANGE("an agent is nowhere", s.agents[0].heading_rad, {-1e300}, {INFINITY, NAN});
    for (int k = 0; k < 3; ++k) {
        RANGE("an agent is nowhere", s.agents[0].position[k], places, nowhere);
        RANGE("an event happened nowhere", (s.agents[0].has_origin = true, s.agents[0].origin[k]), places, nowhere);
        RANGE("", s.agents[0].origin[k], nowhere, {});
    }
    const double now = director().decided_s();
    RANGE("an agent is nowhere", s.agents[0].now_s, {now}, {std::nextafter(now, 2 * now)});
    RANGE("an event has no sender", s.agents[0].sender, {2, none}, {3});
    RANGE("an agent plays an unknown clip", s.agents[1].clip, {0, none}, {double(machine().clip_names.size())});
    RANGE("an agent plays no clip", s.agents[0].play_speed, {0.005, 200}, {0.0049, 201, -1, NAN});
    RANGE("an agent plays no clip", s.agents[0].play_phase_s, {1e9, -1e9}, {1.001e9, -1.001e9, NAN});
    RANGE("an agent plays no clip", s.agents[0].play_start_s, {1e10, -1e10}, {1.001e10, -1.001e10, NAN});
    REFUSES("an agent has other variables", [](SavedStage &s) { s.agents[0].variables.push_back(0); });
    REFUSES("an agent has other variables", [](SavedStage &s) { s.agents[0].variables.clear(); });
    REFUSES("an agent has other variables", [](SavedStage &s) { s.agents[1].variables.assign(2, 0); });
    TAKES([](SavedStage &s) { s.agents[1].variables.clear(), s.agents[1].last.clear(); });
    REFUSES("an agent has other states", [](SavedStage &s) { s.agents[0].last.clear(); });
    REFUSES("an agent has other states", [](SavedStage &s) { s.agents[1].last.assign(2, none); });
}

TEST_F(SavedRules, OfTheStatesOfAnAgent)
{
    const char *const unknown = "an agent is in an unknown state";
    const uint32_t out = good_.agents[0].path[0].state, in = good_.agents[0].path[1].state,
                   count = static_cast<uint32_t>(machine().states.size());
    RANGE(unknown, s.agents[0].path[1].state, {double(in)}, {double(count)});
    RANGE(unknown, s.agents[0].path[1].serial, {1}, {0, double(good_.agents[0].next_serial)});
    RANGE(unknown, s.agents[0].path[0].entered_s, {-1e300}, {INFINITY, NAN});
    const char *const apart = "an agent is in states that do not hold each other";
    for (uint32_t level = 0; level < 2; ++level)
        for (uint32_t state = 0; state < count; ++state) {
            const Forge forge = [=](SavedStage &s) { s.agents[0].path[level].state = state; };
            if (state == (level ? in : out)) TAKES(forge);
            else REFUSES(apart, forge);
        }
    REFUSES("an agent is in no innermost state", [](SavedStage &s) { s.agents[0].depth = 1; });
    for (uint32_t of = 0; of < count; ++of)
        for (const uint32_t left : {0u, 1u, 2u, 3u, none}) {
            const Forge forge = [=](SavedStage &s) { s.agents[0].last[of] = left; };
            if (left == none || (left < count && machine().states[left].parent == of)) TAKES(forge);
            else REFUSES("the history of an agent is wrong", forge);
        }
}
