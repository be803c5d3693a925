// What control mechanisms are made of (S0 5.3, 7.1): descriptions that many actors share, and what one actor's use of one
// holds. Nothing is evaluated here; lib/behave does that.
//
// What a mechanism writes is a function of time, of the actor's seed, and of what the host has commanded, so that who is
// not seen need not be evaluated and still is where its clock says.
#pragma once

#include <claque/behave.h>

#include "lib/model/template.h"

#include <limits>
#include <variant>

namespace claque::crowd
{

using model::Array;

struct DofValue {
    uint32_t dof = 0;  // of the template's rig
    float value = 0;
};

// Values that belong together: a smile, a mouth that says O. They stand in an array of the mechanism.
struct DofPose {
    uint32_t first = 0, count = 0;
};

// Where a shape begins in a phrase.
struct PhraseKey {
    float time_s = 0;             // from the phrase's beginning, ascending
    uint32_t pose = model::none;  // none: the mouth at rest
};

// Eyes, neck and spine share the turn towards a point (S0 5.3): the spine its share, the neck its share of the rest, the
// eyes what is left, each within its range; the spine does not make up for the neck, nor the neck for the eyes. Absent: none.
struct Gaze {
    uint32_t eye_yaw[2] = {model::none, model::none}, eye_pitch[2] = {model::none, model::none};
    uint32_t neck_yaw = model::none, neck_pitch = model::none, spine_yaw = model::none, spine_pitch = model::none;
    float neck_share = 0.6f, spine_share = 0.2f;  // [0, 1]
    glm::vec3 eyes = glm::vec3(0);                // between the eyes at rest, in the Skeleton Root's frame
    float turn_s = 0.4f;                          // that a turn from one point to the next takes
    float wander_s = 0;  // without a point: looks somewhere else about this often; 0: straight on
    float wander_yaw = 0.5f, wander_pitch = 0.15f;  // [radians] how far
};

// One of several shapes at a time, each held for about hold_s, by lot, unless the host commands one.
struct Expression {
    explicit Expression(std::pmr::memory_resource *memory) : poses(memory), values(memory) {}
    Array<DofPose> poses;
    Array<DofValue> values;
    float hold_s = 4, blend_s = 0.4f;
};

// Lids that close and open again about every period_s.
struct Blink {
    explicit Blink(std::pmr::memory_resource *memory) : closed(memory) {}
    Array<DofValue> closed;
    float period_s = 4, close_s = 0.15f;
};

// Mouth shapes in time, once from a command on, or over and over with pauses.
struct Phrase {
    explicit Phrase(std::pmr::memory_resource *memory) : keys(memory), poses(memory), values(memory) {}
    Array<PhraseKey> keys;
    Array<DofPose> poses;
    Array<DofValue> values;
    float length_s = 0;  // then the mouth goes to rest
    float pause_s = 0;   // of about this length between two rounds; negative: only when the host commands it
    float blend_s = 0.06f;
};

// Clips by lot, each for slot_s, in place of what the actor plays. Writes no degree of freedom.
struct Idle {
    explicit Idle(std::pmr::memory_resource *memory) : clips(memory), weights(memory) {}
    Array<uint32_t> clips;
    Array<float> weights;  // one a clip, what share of the lots it has; empty: equal ones
    float slot_s = 6;
    float fade_s = 0;        // that the clip of the slot before takes to go; at most slot_s
    float speed_spread = 0;  // [0, 1) speeds are 1 - this to 1 + this, by lot
    float phase_spread = 0;  // [0, 1] of a clip's length: where in it clips begin, by lot
};

// The host's own.
struct HostMechanism {
    // Calls run on one thread, the caller of the update. `memory`: it keeps something from call to call; then it runs for
    // every actor that uses it in every update, seen or not, in the order of rows, and who uses it is due in every frame.
    void (*run)(void *user, const clq_behaviour_call *call, clq_dof_writer *writer) = nullptr;
    void *user = nullptr;
    bool memory = false;
};

using MechanismKind = std::variant<Gaze, Expression, Blink, Phrase, Idle, HostMechanism>;

constexpr uint32_t max_behaviour_levels = 4;
constexpr float never = std::numeric_limits<float>::infinity();

struct Mechanism {
    MechanismKind kind;
    const model::Template *tmpl = nullptr;  // whose degrees of freedom or clips it names
    // S0 5.3: level k + 1 begins at level_m[k], ascending; infinity: never. From off_m on it does not run at all. Where the
    // skeleton has lost all nodes that it writes, it is off as well.
    float level_m[max_behaviour_levels - 1] = {never, never, never};
    float off_m = never;
    uint32_t first_dof = 0, dof_count = 0;  // of Behaviours::written(): what it may write; none of a host's: all
};

// Something that the host has told one actor's mechanism.
struct Command {
    double at_s = -std::numeric_limits<double>::infinity();  // from when on
    uint32_t choice = model::none;  // gaze: 0 a point; expression: a shape; phrase: 0 speaks; none: left to itself
    uint32_t choice_before = model::none;  // expression: what was chosen until then
    glm::vec3 point = glm::vec3(0);        // gaze: in the Reference Point's space
    float from_yaw = 0, from_pitch = 0;    // gaze: where it looked until then, in the Skeleton Root's frame
    float side = 0;  // gaze: the sign of the yaw by which a point in its back is looked at; 0: of the smaller one
};

// The last thing that it was told, and the one before.
struct CommandHistory : Command {
    Command before;
};

// One actor's use of one mechanism. Those of an actor form a chain, the lowest priority first: the later ones have the
// last word.
struct MechanismAttachment {
    uint32_t mechanism = 0;
    uint32_t next = model::none;
    float priority = 0;
    float phase_s = 0;
    double start_s = 0;
    uint32_t command_history = model::none;  // of Behaviours::command(); none: nothing was ever commanded
};

constexpr uint32_t max_mechanisms = 16;  // by one actor

// The movement of the Skeleton Root round the Reference Point (S0 3, 4.1), a closed curve or a table, in the Reference
// Point's space. Many actors move along one, each with a clock of its own.
struct RootPath {
    explicit RootPath(std::pmr::memory_resource *memory) : times_s(memory), positions(memory), rotations(memory) {}
    // A flight: positions are met at equal times on a smooth closed curve; it looks along it and banks into turns.
    // A table: keys with rotations, in between straight and by the shorter arc; goes round from the last to the first.
    bool flight = true;
    Array<float> times_s;  // table: ascending from 0; the last one is duration_s and holds the first key again
    Array<glm::vec3> positions;
    Array<glm::quat> rotations;  // table
    float duration_s = 1;
    float bank = 0;      // flight: radians for each radian a second that it turns
    float max_bank = 0;  // [radians]
    float reach = 0;     // no position is farther from the Reference Point
};

// How one actor goes along one.
struct RootPathPlay {
    uint32_t path = model::none;  // none: the Skeleton Root stays at the Reference Point
    float speed = 1;              // times the path's own; negative goes backwards
    float phase_s = 0;
    double start_s = 0;
};

}  // namespace claque::crowd
