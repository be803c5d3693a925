// Data of control mechanisms (S0 5.3, 7.1): descriptions that many actors share, and the attachment of one mechanism to
// one actor. lib/behave evaluates them.
//
// A mechanism's output is a function of time, the actor's seed and the host's commands. An unseen actor therefore need
// not be evaluated and is still right for its clock when it comes into view.
#pragma once

#include <claque/behave.h>

#include <limits>
#include <variant>

#include "lib/model/template.h"

namespace claque::crowd
{

using model::Array;

struct DofValue {
    uint32_t dof = 0;  // of the template's rig
    float value = 0;
};

// A set of values, such as a smile or a mouth that says O. Poses are in an array of the mechanism.
struct DofPose {
    uint32_t first = 0, count = 0;
};

// The start of a pose in a phrase.
struct PhraseKey {
    float time_s = 0;             // from the phrase's beginning, ascending
    uint32_t pose = model::none;  // none: the mouth at rest
};

// Spine, neck and eyes share the turn towards a point (S0 5.3): the spine turns by its share, the neck by its share of
// the rest, the eyes by the remainder, each within its range. None of them compensates for the limits of another.
// Absent: none.
struct Gaze {
    uint32_t eye_yaw[2] = {model::none, model::none}, eye_pitch[2] = {model::none, model::none};
    uint32_t neck_yaw = model::none, neck_pitch = model::none, spine_yaw = model::none, spine_pitch = model::none;
    float neck_share = 0.6f, spine_share = 0.2f;  // [0, 1]
    glm::vec3 eyes = glm::vec3(0);                // between the eyes at rest, in the Skeleton Root's frame
    float turn_s = 0.4f;                          // duration of a turn from one point to the next
    float wander_s = 0;  // without a point: mean interval between random directions; 0: straight on
    float wander_yaw = 0.5f, wander_pitch = 0.15f;  // [radians] largest random angles
};

// One of several poses at a time, each held for about hold_s and chosen at random, unless the host commands one.
struct Expression {
    explicit Expression(std::pmr::memory_resource *memory) : poses(memory), values(memory) {}
    Array<DofPose> poses;
    Array<DofValue> values;
    float hold_s = 4, blend_s = 0.4f;
};

// Closes and opens the lids about every period_s.
struct Blink {
    explicit Blink(std::pmr::memory_resource *memory) : closed(memory) {}
    Array<DofValue> closed;
    float period_s = 4, close_s = 0.15f;
};

// Mouth poses in time, played once from a command on, or repeatedly with pauses.
struct Phrase {
    explicit Phrase(std::pmr::memory_resource *memory) : keys(memory), poses(memory), values(memory) {}
    Array<PhraseKey> keys;
    Array<DofPose> poses;
    Array<DofValue> values;
    float length_s = 0;  // the mouth goes to rest after it
    float pause_s = 0;   // mean pause between two repetitions; negative: only when the host commands it
    float blend_s = 0.06f;
};

// Random clips, each for slot_s, in place of what the actor plays. Writes no degree of freedom.
struct Idle {
    explicit Idle(std::pmr::memory_resource *memory) : clips(memory), weights(memory) {}
    Array<uint32_t> clips;
    Array<float> weights;  // one per clip: its relative probability; empty: equal ones
    float slot_s = 6;
    float fade_s = 0;        // fade-out time of the previous slot's clip; at most slot_s
    float speed_spread = 0;  // [0, 1) speeds are random in 1 - this to 1 + this
    float phase_spread = 0;  // [0, 1] of a clip's length: range of random start phases
};

// A mechanism of the host.
struct HostMechanism {
    // Calls run on one thread, the caller of the update. `memory`: the callback keeps state from call to call; it then
    // runs in every update for every actor that it is attached to, seen or not, in the order of rows, and these actors
    // are due in every frame.
    void (*run)(void *user, const clq_behaviour_call *call, clq_dof_writer *writer) = nullptr;
    void *user = nullptr;
    bool memory = false;
};

using MechanismKind = std::variant<Gaze, Expression, Blink, Phrase, Idle, HostMechanism>;

constexpr uint32_t max_behaviour_levels = 4;
constexpr float never = std::numeric_limits<float>::infinity();

struct Mechanism {
    MechanismKind kind;
    const model::Template *tmpl = nullptr;  // its dofs and clips are indices into this template
    // S0 5.3: level k + 1 begins at level_m[k], ascending; infinity: never. From off_m on the mechanism does not run.
    // It is also off when all nodes that it writes are deactivated.
    float level_m[max_behaviour_levels - 1] = {never, never, never};
    float off_m = never;
    // range in Behaviours::written(): what it may write; empty for a host mechanism: all
    uint32_t first_dof = 0, dof_count = 0;
};

// A command of the host to one actor's mechanism.
struct Command {
    double at_s = -std::numeric_limits<double>::infinity();  // valid from this time on
    uint32_t choice = model::none;         // gaze: 0: a point; expression: a pose; phrase: 0: speaks; none: automatic
    uint32_t choice_before = model::none;  // expression: the choice before
    glm::vec3 point = glm::vec3(0);        // gaze: in the Reference Point's space
    float from_yaw = 0, from_pitch = 0;    // gaze: the direction before, in the Skeleton Root's frame
    float side = 0;                        // gaze: sign of the yaw towards a point behind the actor; 0: the smaller yaw
};

// The last command, and the one before.
struct CommandHistory : Command {
    Command before;
};

// The attachment of one mechanism to one actor. Attachments of an actor form a list in ascending priority; later ones
// overwrite earlier ones.
struct MechanismAttachment {
    uint32_t mechanism = 0;
    uint32_t next = model::none;
    float priority = 0;
    float phase_s = 0;
    double start_s = 0;
    uint32_t command_history = model::none;  // in Behaviours::command(); none: never commanded
};

constexpr uint32_t max_mechanisms = 16;  // per actor

// The movement of the Skeleton Root round the Reference Point (S0 3, 4.1), a closed curve or a table, in the Reference
// Point's space. Many actors may share one, each with its own clock.
struct RootPath {
    explicit RootPath(std::pmr::memory_resource *memory) : times_s(memory), positions(memory), rotations(memory) {}
    // A flight: a smooth closed curve that meets the positions at equal intervals of time; the root faces forwards and
    // banks into turns.
    // A table: keys with rotations, linear and by the shorter arc between keys; the last key leads back to the first.
    bool flight = true;
    Array<float> times_s;  // table: ascending from 0; the last one is duration_s and repeats the first key
    Array<glm::vec3> positions;
    Array<glm::quat> rotations;  // table
    float duration_s = 1;
    float bank = 0;      // flight: radians of bank per rad/s of turning
    float max_bank = 0;  // [radians]
    float reach = 0;     // the largest distance of any position from the Reference Point
};

// How one actor plays a root path.
struct RootPathPlay {
    uint32_t path = model::none;  // none: the Skeleton Root stays at the Reference Point
    float speed = 1;              // factor of the path's own; negative plays backwards
    float phase_s = 0;
    double start_s = 0;
};

}  // namespace claque::crowd
