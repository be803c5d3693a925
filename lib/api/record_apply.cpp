// Makes recorded calls: each goes through the checks that the host's own call goes through.
#include "lib/api/boundary.h"
#include "lib/api/play_def.h"
#include "lib/api/record_handle.h"
#include "lib/behave/command.h"
#include "lib/crowd/descriptions.h"
#include "lib/record/block_writer.h"

namespace claque::api
{

namespace
{

using base::fail;
using model::none;
using record::Kind;

// Any number, as a C host may pass it: the checks of the call read it as bits. A copy of such an enum is undefined.
template <class Enum>
void put(Enum &out, record::EnumBits bits)
{
    static_assert(sizeof(Enum) == sizeof bits, "C hosts pass enums as int");
    std::memcpy(&out, &bits, sizeof out);
}

// Calls that make something gave it an id, which it has to get again.
template <class Id>
void require_id(const char *what, const crowd::Id &made, const Id &recorded)
{
    if (made.index1 != recorded.index1 || made.generation != recorded.generation)
        fail(CLQ_FORMAT, "the recorded call made %s {%u, %u}; here it is {%u, %u}", what, recorded.index1,
             recorded.generation, made.index1, made.generation);
}

class Calls
{
public:
    Calls(const clq_record &played, clq_crowd *handle) : played_(played), handle_(handle), to_(handle->crowd) {}

    void on(const record::ActorCreate &c)
    {
        if (c.tmpl >= played_.templates.size())
            fail(CLQ_FORMAT, "a record names template %u of %zu", c.tmpl, played_.templates.size());
        const clq_template &tmpl = *played_.templates[c.tmpl];
        if (c.texture_set != CLQ_RANDOM && c.texture_set >= tmpl.texture_set_count())
            fail(CLQ_FORMAT, "texture set %u does not exist: template '%s' has %u", c.texture_set, tmpl.name.c_str(),
                 tmpl.texture_set_count());
        const crowd::Id made = crowd::create(to_, tmpl, transform_of(c.transform), play_of(c.play), c.seed);
        crowd::set_texture_set(to_, made, c.texture_set);
        require_id("actor", made, c.made);
    }
    void on(const record::ActorDestroy &c) { crowd::destroy(to_, id_of(c.actor)); }
    void on(const record::ActorClone &c)
    {
        const crowd::Transform place = transform_of(c.transform);
        require_id("actor", crowd::clone(to_, id_of(c.actor), c.placed ? &place : nullptr, c.seed), c.made);
    }
    void on(const record::ActorPlay &c) { crowd::play(to_, id_of(c.actor), play_of(c.play)); }
    void on(const record::ActorFadeTo &c)
    {
        const uint32_t row = to_.row_of(id_of(c.actor));
        const crowd::Source source = crowd::source(to_, row, play_of(c.play), c.gait ? c.gait - 1 : none, c.share);
        clq_curve curve;
        put(curve, c.curve);
        crowd::fade_to(to_, id_of(c.actor), source, c.at_s, c.length_s, curve_of(curve));
    }
    void on(const record::ActorSetGaitShare &c)
    {
        crowd::change_share(to_, id_of(c.actor), c.share, c.at_s, c.length_s);
    }
    void on(const record::ActorAddLayer &c)
    {
        clq_layer_def def = clq_layer_def_init();
        put(def.kind, c.layer_kind), put(def.curve, c.curve);
        def.play = c.play, def.weight = c.weight, def.loops = c.loops;
        def.fade_in_s = c.fade_in_s, def.fade_out_s = c.fade_out_s;
        def.mask = {c.mask}, def.has_reference = c.has_reference;
        def.reference_clip = c.reference_clip, def.reference_time_s = c.reference_time_s;
        const model::Template &tmpl = to_.template_of(to_.row_of(id_of(c.actor)));
        require_id("layer", {crowd::add_layer(to_, id_of(c.actor), layer_of(def, tmpl)), 0}, crowd::Id{c.made, 0});
    }
    void on(const record::ActorEndLayer &c) { crowd::end_layer(to_, id_of(c.actor), c.layer, c.at_s, c.fade_out_s); }
    void on(const record::ActorSetWatched &c) { crowd::watch(to_, id_of(c.actor), c.watched); }
    void on(const record::ActorSetTextureSet &c) { crowd::set_texture_set(to_, id_of(c.actor), c.set); }
    void on(const record::ActorSetPriority &c) { crowd::set_priority(to_, id_of(c.actor), c.priority); }
    void on(const record::ActorAttach &c)
    {
        const model::Sphere sphere{glm::vec3(c.centre[0], c.centre[1], c.centre[2]), c.radius};
        require_id("attachment", crowd::attach(to_, id_of(c.actor), c.node, sphere), c.made);
    }
    void on(const record::ActorDetach &c) { crowd::detach(to_, {c.attachment.index1, c.attachment.generation}); }
    void on(const record::ActorJoin &c)
    {
        const crowd::Transform place = transform_of(c.transform);
        crowd::join(to_, id_of(c.actor), id_of(c.group), c.placed ? &place : nullptr);
    }
    void on(const record::ActorFollowTrack &c)
    {
        crowd::follow_track(to_, id_of(c.actor), borrow_track(played_, handle_, c.track), c.start_s);
    }
    void on(const record::ActorFadeToTrack &c)
    {
        crowd::fade_to_track(to_, id_of(c.actor), c.at_s, c.length_s, crowd::Curve::smooth);
    }
    void on(const record::ActorLeaveTrack &c) { crowd::leave_track(to_, id_of(c.actor), c.at_s); }
    void on(const record::ActorAttachMechanism &c)
    {
        crowd::MechanismAttachment wanted;
        wanted.mechanism = c.mechanism - 1, wanted.priority = c.priority;
        wanted.phase_s = c.phase_s, wanted.start_s = c.start_s;
        crowd::attach_mechanism(to_, id_of(c.actor), wanted);
    }
    void on(const record::ActorDetachMechanism &c)
    {
        to_.row_of(id_of(c.actor));
        if (c.mechanism - 1 >= to_.behaviours().mechanism_count())
            fail(CLQ_FORMAT, "mechanism %u does not exist", c.mechanism);
        crowd::detach_mechanism(to_, id_of(c.actor), c.mechanism - 1);
    }
    void on(const record::ActorGaze &c)
    {
        const glm::dvec3 point(c.point[0], c.point[1], c.point[2]);
        behave::command_gaze(to_, id_of(c.actor), c.mechanism - 1, c.has_point ? &point : nullptr, c.at_s);
    }
    void on(const record::ActorExpress &c)
    {
        behave::command_expression(to_, id_of(c.actor), c.mechanism - 1, c.pose == CLQ_NONE ? none : c.pose, c.at_s);
    }
    void on(const record::ActorSay &c) { behave::command_phrase(to_, id_of(c.actor), c.mechanism - 1, c.at_s); }
    void on(const record::ActorPlayRootPath &c)
    {
        crowd::play_root_path(to_, id_of(c.actor), {c.path ? c.path - 1 : none, c.speed, c.phase_s, c.start_s});
    }
    void on(const record::ActorFollowGround &c) { crowd::follow_ground(to_, id_of(c.actor), c.max_up, c.max_down); }
    void on(const record::GroupCreate &c)
    {
        const crowd::Transform place = c.placed ? transform_of(c.transform) : crowd::Transform();
        require_id("group", crowd::create_group(to_, place), c.made);
    }
    void on(const record::GroupDestroy &c) { crowd::destroy_group(to_, id_of(c.group)); }
    void on(const record::GroupSetTransform &c)
    {
        crowd::set_group_transform(to_, id_of(c.group), transform_of(c.transform));
    }
    void on(const record::GroupSetEnabled &c) { crowd::enable_group(to_, id_of(c.group), c.enabled); }
    void on(const record::GroupSetSpeed &c) { crowd::set_group_speed(to_, id_of(c.group), c.speed); }

    // Of many actors, and descriptions.
    void other(Kind kind, crowd::Reader &in)
    {
        HostResolver resolver(*handle_, nullptr, 0, &played_.lent);
        switch (kind) {
            case Kind::crowd_set_transforms:
                return transforms(in);
            case Kind::crowd_set_speeds:
                return speeds(in);
            case Kind::actor_colours:
                return colours(in);
            case Kind::crowd_add_mechanism:
                return crowd::read_mechanism(in, resolver, to_.tables);
            case Kind::crowd_add_root_path:
                return crowd::read_path(in, resolver, to_.tables);
            case Kind::crowd_add_gait:
                return crowd::read_gait(in, to_.tables);
            default:
                return crowd::read_mask(in, to_.tables);
        }
    }

private:
    void transforms(crowd::Reader &in)
    {
        const uint32_t count = static_cast<uint32_t>(in.left() / record::placed_bytes);
        std::pmr::vector<crowd::Id> &ids = handle_->actor_ids;
        ids.clear(), handle_->placed.clear();
        ids.reserve(count), handle_->placed.reserve(count);
        for (uint32_t i = 0; i < count; ++i) {
            clq_actor actor;
            clq_transform place;
            record::walk_id(in, actor), record::walk_place(in, place);
            ids.push_back(id_of(actor)), handle_->placed.push_back(transform_of(place));
        }
        crowd::set_transforms(to_, ids.data(), handle_->placed.data(), count);
    }

    void speeds(crowd::Reader &in)
    {
        clq_actor actor;
        float speed = 0;
        while (in.left() > 0) {
            record::walk_id(in, actor), in.value(speed);
            const crowd::Id id = id_of(actor);
            crowd::set_speeds(to_, &id, &speed, 1);
        }
    }

    void colours(crowd::Reader &in)
    {
        clq_actor actor;
        record::walk_id(in, actor);
        const uint32_t row = to_.row_of(id_of(actor)), zones = to_.template_of(row).zone_count();
        if (zones == 0 || in.left() != size_t(3) * zones)
            fail(CLQ_FORMAT, "a recorded call gives %zu numbers for the colours of %u zones", in.left(), zones);
        uint8_t *rgb = crowd::make_colours(to_.tables, row);
        for (uint32_t i = 0; i < 3 * zones; ++i) in.value(rgb[i]);
    }

    const clq_record &played_;
    clq_crowd *handle_;
    crowd::Crowd &to_;
};

template <class Call>
bool made_if(Calls &calls, const record::Entry &entry, crowd::Reader &in)
{
    if (entry.kind != Call::kind) return false;
    Call call;
    record::walk(in, call);
    calls.on(call);
    return true;
}

template <class... All>
bool made_one_of(Calls &calls, const record::Entry &entry, crowd::Reader &in, const std::tuple<All...> *)
{
    return (made_if<All>(calls, entry, in) || ...);
}

}  // namespace

void apply(const clq_record &played, clq_crowd *crowd, const record::Entry &entry)
{
    Calls calls(played, crowd);
    crowd::Reader in("a recorded call", entry.fields, entry.size);
    if (!made_one_of(calls, entry, in, static_cast<const record::Calls *>(nullptr))) calls.other(entry.kind, in);
    if (in.left() != 0) fail(CLQ_FORMAT, "a recorded call has %zu bytes too many", in.left());
}

}  // namespace claque::api
