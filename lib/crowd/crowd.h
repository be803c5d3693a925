// Who is there, where, doing what, in what colours: one row an individual, columns apart (S0 3, S1 1). What a host
// sets and nothing else; lib/frame reads it, and never writes.
//
// Calls throw base::Error (CLQ_STALE_ID, CLQ_ARGUMENT, CLQ_LIMIT) or std::bad_alloc, and leave everything as it was
// then: each reserves first and commits after. One writer.
#pragma once

#include "lib/base/span.h"
#include "lib/crowd/behaviours.h"
#include "lib/crowd/colours.h"
#include "lib/crowd/extras.h"
#include "lib/crowd/layers.h"
#include "lib/crowd/transform.h"
#include "lib/model/template.h"

namespace claque::crowd
{

class ColourMap;  // colour_map.h

struct Id {
    uint32_t index1 = 0;  // row + 1; 0 is nobody
    uint32_t generation = 0;
};

constexpr uint32_t random_texture_set = model::none;  // for Crowd::set_texture_set

// What lasts as long as an individual does.
struct Actor {
    uint32_t tmpl = 0;        // of Crowd::templates()
    uint32_t generation = 0;  // odd while the row is alive
    uint64_t seed = 0;
    uint64_t play_version = 0;       // new for every play of every individual: no two states share one
    uint32_t colours = model::none;  // slot in its template's colour table; none: the template's own
    uint32_t texture_set = 0;        // of its template
};

// Actors that are tested and moved together: a vehicle with its occupants, a flock, a block of seats (S0 4.3, 8).
struct Group {
    Transform transform;      // of the group's space in the world
    uint32_t generation = 0;  // odd while it exists
    uint32_t members = 0;
    bool enabled = true;   // the members of a disabled group are nowhere to be seen
    uint64_t version = 0;  // new whenever the group's sphere may have changed
};

// Throws base::Error (CLQ_ARGUMENT) unless the clip is one of the template's and the numbers are finite.
void check_play(const Play &play, const model::Template &tmpl);

class Crowd
{
public:
    explicit Crowd(std::pmr::memory_resource *memory, uint64_t seed = 0);
    ~Crowd();
    Crowd(const Crowd &) = delete;
    Crowd &operator=(const Crowd &) = delete;

    // The template must outlive the crowd; `has_template` tells beforehand whether it will be a new one to hold.
    Id create(const model::Template &tmpl, const Transform &transform, const Play &play, uint64_t seed);
    void destroy(Id id);
    void play(Id id, const Play &play);
    void set_transforms(const Id *ids, const Transform *transforms, uint32_t count);  // all or none
    void set_colours(Id id, const float *rgb, uint32_t zone_count);                   // [3 * zone_count], each [0, 1]
    // count 0: the template's own ranges. Drawn by (seed of crowd, seed of actor, zone): repeatable.
    void randomise_colours(Id id, const model::HsbRange *ranges, uint32_t count);
    // Out of a class of a map; all or none.
    void randomise_colours(const Id *ids, uint32_t count, const ColourMap &map, uint32_t colour_class);

    void set_texture_set(Id id, uint32_t set);  // drawn_by_lot: by the seeds of crowd and actor

    // An individual like another: everything but what is attached to it. `place` null: the other's own.
    Id clone(Id id, const Transform *transform, uint64_t seed);
    void set_priority(Id id, float priority);  // [0, 1]
    Id attach(Id id, uint32_t node, const model::Sphere &sphere);
    void detach(Id attached);
    void set_hooks(Id id, const clq_actor_hooks &hooks);                               // both null: none
    void set_ground(double (*height)(void *user, const double point[3]), void *user);  // null: none
    void follow_ground(Id id, float max_up, float max_down);                           // world units; both 0: not

    // Behaviour (S0 5.3, 7.1). Descriptions go to behaviours() directly.
    Behaviours &behaviours() { return behaviours_; }
    const Behaviours &behaviours() const { return behaviours_; }
    void attach_mechanism(Id id, const MechanismAttachment &attachment);
    void detach_mechanism(Id id, uint32_t mechanism);
    CommandHistory &command_history(Id id, uint32_t mechanism);  // of this use, for the caller to change
    void play_root_path(Id id, const RootPathPlay &root_play);

    // Fades, gaits and gestures (layers.h). Descriptions go to layers() directly.
    Layers &layers() { return layers_; }
    const Layers &layers() const { return layers_; }
    // Checked. `share`: of the gait's second clip, whose first one the play's clip becomes; gait none: the clip alone.
    Source source(uint32_t row, const Play &play, uint32_t gait, float share) const;
    void play(Id id, const Source &source);  // at once, whatever was fading
    // What is told for a time before the last fade's replaces that one.
    void fade_to(Id id, const Source &source, double at_s, float length_s, Curve curve);
    void change_share(Id id, float share, double at_s, float length_s);
    uint32_t add_layer(Id id, const Layer &layer);  // its name
    void end_layer(Id id, uint32_t layer_id, double at_s, float fade_out_s);
    LayerState layer_state_of(uint32_t row) const;
    void watch(Id id, bool watched);  // whether anybody asks what happens in its clips
    base::Span<const uint32_t> watched() const { return base::Span<const uint32_t>(watched_); }  // rows, ascending

    Id create_group(const Transform &transform);
    void destroy_group(Id id);  // its members stay where they are in the world
    void set_group_transform(Id id, const Transform &transform);
    void enable_group(Id id, bool enabled);
    // `place`: in the group's space, or null: it stays where it is in the world. Group none: it leaves.
    void join(Id id, Id group, const Transform *transform);

    bool has_template(const model::Template &tmpl) const;
    uint32_t row_of(Id id) const;        // throws CLQ_STALE_ID
    uint32_t group_row_of(Id id) const;  // likewise

    uint32_t actor_count() const { return alive_; }
    uint32_t row_count() const { return static_cast<uint32_t>(actors_.size()); }         // rows of the gone included
    uint32_t row_capacity() const { return static_cast<uint32_t>(actors_.capacity()); }  // grows in steps
    uint64_t seed() const { return seed_; }
    std::pmr::memory_resource *memory() const { return actors_.get_allocator().resource(); }
    uint64_t bytes() const;  // held for the individuals
    uint64_t hash() const;   // of what save.h writes

    // Takes over what `restored` holds, and gives it what was here (save.h). Callbacks stay: the ground, and the hooks of
    // actors with the same id in both. No version is one that was here before, so that nothing that was made for this crowd
    // passes for the restored one's. std::bad_alloc: this is as it was. Same memory.
    void swap_state(Crowd &restored);

    // Columns, by row.
    bool alive(uint32_t row) const { return actors_[row].generation & 1; }
    const Actor &actor(uint32_t row) const { return actors_[row]; }
    const Transform &transform_of(uint32_t row) const
    {
        return transforms_[row];
    }  // in its group's space, where it has one
    Transform world_transform_of(uint32_t row) const
    {
        return groups_of_[row] == model::none ? transforms_[row]
                                              : composed(groups_[groups_of_[row]].transform, transforms_[row]);
    }
    uint32_t group_of(uint32_t row) const { return groups_of_[row]; }  // its row, or none
    const Play &play_of(uint32_t row) const { return plays_[row]; }
    Id id_of(uint32_t row) const { return {row + 1, actors_[row].generation}; }
    const model::Template &template_of(uint32_t row) const { return *templates_[actors_[row].tmpl]; }
    const Extent &extent_of(uint32_t row) const { return extents_[row]; }
    const Extra *extra_of(uint32_t row) const  // or null
    {
        return extras_of_[row] == model::none ? nullptr : &extras_[extras_of_[row]];
    }
    size_t hooked_count() const { return extras_.size(); }  // at most, who has callbacks
    double (*ground() const)(void *user, const double point[3]) { return ground_; }
    void *ground_user() const { return ground_user_; }
    const uint8_t *zone_rgb(uint32_t row) const;  // 3 a zone, or null: the template's own
    // Rows of groups, those of the gone included.
    uint32_t group_count() const { return static_cast<uint32_t>(groups_.size()); }
    const Group &group(uint32_t row) const { return groups_[row]; }
    Id group_id_of(uint32_t row) const { return {row + 1, groups_[row].generation}; }
    uint64_t structure_version() const { return structure_version_; }  // new with every actor or member come or gone
    size_t colour_bytes() const;                                       // at most, of all individuals' own colours

    base::Span<const model::Template *const> templates() const
    {
        return {templates_.data(), static_cast<uint32_t>(templates_.size())};
    }

private:
    friend class Saver;     // save.cpp
    friend class Restorer;  // restore.cpp

    uint32_t colour_slot(uint32_t row);  // its own, made when it has none; may throw
    void leave(uint32_t row);            // keeps its place as numbers
    void reserve_row();                  // room for one more, may throw
    uint32_t take_row();
    void take_back(uint32_t row, uint32_t rows_before);  // who was created last, as if it had never been
    void new_version(uint32_t row) { actors_[row].play_version = next_version_++; }  // what it shows may have changed
    uint32_t extra_slot(uint32_t row);                                               // made when it has none; may throw
    void clear_extra(uint32_t row);
    void free_attached(uint32_t index);
    void check_source(uint32_t row, const Source &source) const;
    void restore_layer_state(uint32_t row, const LayerState &read);  // that may hold anything
    void check_layer(uint32_t row, const Layer &layer) const;
    void change(uint32_t row, const LayerState &wanted);  // may throw, and then has changed nothing
    void measure(uint32_t row);                           // its extent, and that of its group
    void touch_group(uint32_t row);

    uint64_t seed_;
    uint64_t next_version_ = 1;
    uint64_t structure_version_ = 1;
    uint32_t alive_ = 0;
    uint32_t first_free_ = model::none;        // chain of rows through Actor::tmpl
    uint32_t first_free_group_ = model::none;  // chain of rows through Group::members
    std::pmr::vector<const model::Template *> templates_;
    std::pmr::vector<ColourTable> colours_;  // by template
    std::pmr::vector<Actor> actors_;
    std::pmr::vector<Transform> transforms_;
    std::pmr::vector<uint32_t> groups_of_;
    std::pmr::vector<Group> groups_;
    std::pmr::vector<Play> plays_;
    std::pmr::vector<Extent> extents_;
    std::pmr::vector<uint32_t> extras_of_;  // of extras_, or none
    std::pmr::vector<Extra> extras_;
    std::pmr::vector<Attachment> attached_;
    uint32_t first_free_extra_ = model::none, first_free_attached_ = model::none;
    Behaviours behaviours_;
    Layers layers_;
    Array<uint32_t> watched_;
    double (*ground_)(void *user, const double point[3]) = nullptr;
    void *ground_user_ = nullptr;
};

}  // namespace claque::crowd
