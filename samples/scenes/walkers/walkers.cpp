#include "samples/scenes/walkers/walkers.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "lib/base/near_names.h"
#include "samples/scenes/random.h"
#include "samples/scenes/shadows.h"
#include "samples/scenes/walkers/plain.h"
#include "samples/scenes/walkers/vehicles.h"

namespace scenes::walkers
{

namespace
{

constexpr float person_height_m = 1.75f, shadow_width_m = 0.95f;
const char *const people_of_rome[] = {"citizen", "patrician", "plebeian", "decurion"};

// A pose is of a time up to the longest update period before the frame's.
constexpr double around_s = 1;

// A track that is over before any time that is shown: its actor is nowhere.
OwnTrack track_of_absence(const Member &member)
{
    clq_track_point points[2] = {};
    points[0].time_s = -1e9, points[1].time_s = 1 - 1e9;
    clq_track_def def = clq_track_def_init();
    def.points = points, def.point_count = 2;
    clq_track *made = nullptr;
    check(clq_track_create(member.locomotion.get(), &def, &made));
    return OwnTrack(made);
}

class Walkers final : public Scene, public SocialClasses
{
public:
    Walkers(Library &library, const CrowdOptions &crowd_options, const Options &options)
        : library_(library), scene_crowd_(library, crowd_options), plain_(crowd_options.seed, options.light)
    {
        trajectories_ = asked_at(options.places.file, [&] { return load(library, options); });
        plan_ = plan_of(trajectories_.get(), options);
        std::vector<SocialClass> classes = options.characters;
        if (classes.empty())
            for (const char *name : people_of_rome) classes.push_back(walkers::class_of(name));
        for (const SocialClass &one : classes) cast_.push_back(walkers::cast(library, one, crowd_options.lod));
        for (const Member &member : cast_) away_.push_back(track_of_absence(member));
        people_.emplace(library, trajectories_.get(), plan_, cast_, crowd_options.seed);
        vehicles_.emplace(trajectories_.get(), plan_, people_->all());
        walks_.resize(people_->all().size());
        for (size_t i = 0; i < walks_.size(); ++i) {
            const Person &person = people_->all()[i];
            if (person.kind == Person::Kind::vehicle) continue;
            enter(i, crowd_options.as_shown || person.kind == Person::Kind::rides);
            if (crowd_options.as_shown) continue;
            walk(i);
            options.progress(i + 1, walks_.size());
        }
        busiest_s_ = busiest();
        asked_at(options.places.area, [&] { lay(library, options, plan_, plain_.ground()); });
        if (!options.follow.empty()) followed_ = asked_at(options.places.follow, [&] { return find(options.follow); });
        if (followed_) walk(*followed_);
    }

    clq_crowd *crowd() const override { return scene_crowd_.crowd(); }
    std::vector<clq_actor> actors() const override { return scene_crowd_.actors(); }
    std::string class_of(size_t individual) const override
    {
        return cast_[people_->all()[person_of_[individual]].member].described.name;
    }
    double busiest_s() const override { return busiest_s_; }
    std::vector<clq_template *> templates() const override
    {
        std::vector<clq_template *> out;
        for (const Member &member : cast_) out.push_back(member.tmpl);
        return out;
    }

    clq_camera camera(Shot shot, double aspect, double time_s) const override
    {
        if (followed_) return behind(people_->all()[*followed_], time_s, aspect);
        if (shot != Shot::close) return overview_of(plan_, aspect);
        const double z = plan_.middle_z + plan_.half_z + 3;
        return look({plan_.middle_x, 1.62, z}, {plan_.middle_x, 1.2, z - 6}, 50, aspect, 0.2, far_of(plan_));
    }

    void place(double time_s) override
    {
        places_.clear();
        if (followed_) warn_of_absence(people_->all()[*followed_], time_s);
        warn_of_nobody(time_s);
        vehicles_->place(time_s);
        for (size_t individual = 0; individual < person_of_.size(); ++individual) {
            const size_t i = person_of_[individual];
            const Person &person = people_->all()[i];
            if (person.kind == Person::Kind::rides) sit(individual, time_s);
            if (person.kind == Person::Kind::rides || time_s < person.start_s - around_s ||
                time_s > person.end_s + around_s)
                continue;
            walk(i);
            if (time_s < person.start_s || time_s > person.end_s) continue;
            clq_track_state state;
            check(clq_track_evaluate(person.track.get(), time_s, &state));
            clq_transform place = clq_transform_init();
            std::copy(state.position, state.position + 3, place.position);
            place.scale = static_cast<float>(person.scale / cast_[person.member].scale);
            places_.push_back(place);
        }
    }

    std::optional<ReadPart> read_part() const override
    {
        return ReadPart{"tracks", people_->made(), people_->all().size()};
    }

    bool take_shadows(clq_shadow_def &def) override
    {
        paints_people_ = false;
        def = shadows_in(plain_.light());
        return true;
    }

    void prepare(const Gl &gl) override
    {
        plain_.prepare(gl);
        shadows_.prepare(gl);
    }

    void set_light(const Gl &g, const Eye &eye) const override { plain_.set_light(g, eye); }
    void draw_environment(const Gl &g, const Eye &eye) const override
    {
        plain_.draw(g, eye);
        g.Disable(gl::texture_2d);
        vehicles_->boxes().draw(g);
        if (paints_people_) shadows_.cast(places_, plain_.light().to_sun, person_height_m, shadow_width_m);
        shadows_.draw(g, vehicles_->shade());
    }

private:
    // Before its track begins an actor is in no picture, but it exists: the numbers of all others stay.
    void enter(size_t number, bool away)
    {
        const Person &person = people_->all()[number];
        actor_of_.resize(number + 1), actor_of_[number] = person_of_.size();
        person_of_.push_back(number);
        clq_transform place = clq_transform_init();
        place.scale = static_cast<float>(person.scale);
        const Member &member = cast_[person.member];
        const SceneCrowd::Part part = {member.tmpl, place, clq_play_init()};
        if (member.described.palette.empty()) scene_crowd_.enter(part);
        else scene_crowd_.enter(part, scene_crowd_.actors().size(), ranges_of(member.tmpl, member.described));
        if (away) follow(number, away_[person.member].get());
    }

    clq_actor actor(size_t person) const { return scene_crowd_.actors()[actor_of_[person]]; }

    void follow(size_t person, clq_track *track)
    {
        check(clq_actor_follow_track(scene_crowd_.crowd(), actor(person), track, 0));
    }

    // Who rides is on no track: the seat moves it.
    void sit(size_t individual, double time_s)
    {
        const size_t number = person_of_[individual];
        const Person &person = people_->all()[number];
        const bool is_there = time_s >= person.start_s && time_s <= person.end_s;
        if (walks_[number] && !is_there) follow(number, away_[person.member].get());
        if (!walks_[number] && is_there) {
            check(clq_actor_leave_track(scene_crowd_.crowd(), actor(number), time_s));
            clq_play play = clq_play_init();
            play.clip = find_clip(cast_[person.member].tmpl, {"sit", "sitting", "sit_idle", "seated", "stand", "idle"});
            play.phase_s = static_cast<float>(number % 64);
            scene_crowd_.play(individual, play);
        }
        walks_[number] = is_there;
        if (!is_there) return;
        const Vehicles::Stand seat = vehicles_->at(number, time_s);
        const clq_actor one = actor(number);
        const clq_transform place = stand(seat.position[0], seat.position[1], seat.position[2], seat.ahead_x,
                                          seat.ahead_z, static_cast<float>(person.scale));
        check(clq_crowd_set_transforms(scene_crowd_.crowd(), &one, &place, 1));
    }

    // Makes the person's track if it has none.
    void walk(size_t person)
    {
        if (walks_[person] || people_->all()[person].kind != Person::Kind::walks) return;
        follow(person, people_->track(person));
        walks_[person] = true;
    }

    // The time of an arrival after which the most people are there.
    double busiest() const
    {
        std::vector<std::pair<double, int>> changes;  // an arrival before a departure at the same time
        for (const Person &person : people_->all())
            changes.insert(changes.end(), {{person.start_s, -1}, {person.end_s, 1}});
        std::sort(changes.begin(), changes.end());
        double at = 0;
        int now = 0, most = 0;
        for (const auto &[time_s, change] : changes)
            if ((now -= change) > most) most = now, at = time_s;
        return at;
    }

    size_t find(const std::string &id) const
    {
        const std::vector<Person> &people = people_->all();
        for (size_t i = 0; i < people.size(); ++i)
            if (people[i].id == id) return i;
        std::vector<std::string> ids;
        for (const Person &person : people) ids.push_back(person.id);
        throw Failure("no person has the id " + id + " that the camera is to follow" +
                      claque::base::names_near(id, ids));
    }

    void warn_of_absence(const Person &person, double time_s) const
    {
        constexpr double instant_s = 1e-6;
        if (time_s >= person.start_s - instant_s && time_s <= person.end_s + instant_s) return;
        char text[160];
        std::snprintf(text, sizeof text,
                      " is present from %.6g to %.6g s: at other times the camera that follows waits at the nearer end",
                      person.start_s, person.end_s);
        clq_context_log(library_.context(), CLQ_LOG_WARNING,
                        ((person.kind == Person::Kind::vehicle ? "vehicle " : "person ") + person.id + text).c_str());
    }

    void warn_of_nobody(double time_s) const
    {
        const double end_s = plan_.end_s - plan_.start_s;
        if (time_s >= -around_s && time_s <= end_s + around_s) return;
        char text[100];
        std::snprintf(text, sizeof text, "the file has people from 0 to %.6g s: pictures of other times are empty",
                      end_s);
        clq_context_log(library_.context(), CLQ_LOG_WARNING, text);
    }

    // Over the shoulder, from where the person comes; the direction is the mean of two seconds, so that it does not
    // jerk.
    clq_camera behind(const Person &person, double time_s, double aspect) const
    {
        const double t = std::clamp(time_s, person.start_s, person.end_s);
        if (person.kind != Person::Kind::walks) {  // behind a vehicle, and above it
            const Vehicles::Stand at = vehicles_->rear(*followed_, t);
            const double *p = at.position, x = at.ahead_x, z = at.ahead_z;
            return look({p[0] - 6 * x - 4.5 * z, p[1] + 3.6, p[2] - 6 * z + 4.5 * x},
                        {p[0] + 4 * x, p[1] + 1, p[2] + 4 * z}, 48, aspect, 0.2, 400);
        }
        clq_track_state state;
        double x = 0, z = 0;
        for (int k = -10; k <= 10; ++k) {
            check(clq_track_evaluate(person.track.get(), t + 0.1 * k, &state));
            x += std::sin(state.heading_rad), z += std::cos(state.heading_rad);
        }
        check(clq_track_evaluate(person.track.get(), t, &state));
        const double size = std::sqrt(x * x + z * z), dx = size > 0 ? x / size : 0, dz = size > 0 ? z / size : 1;
        const double *p = state.position;
        return look({p[0] - 3.2 * dx + 1.2 * dz, p[1] + 1.9, p[2] - 3.2 * dz - 1.2 * dx},
                    {p[0] + 1.5 * dx, p[1] + 0.95, p[2] + 1.5 * dz}, 48, aspect, 0.2, 400);
    }

    Library &library_;
    OwnTrajectories trajectories_;
    Plan plan_;
    std::vector<Member> cast_;
    std::vector<OwnTrack> away_;  // by member of the cast
    std::optional<People> people_;
    std::optional<Vehicles> vehicles_;
    std::vector<bool> walks_;                   // by person: its actor follows its own track, or sits
    std::vector<size_t> person_of_, actor_of_;  // of individuals, and the other way round; vehicles are none
    SceneCrowd scene_crowd_;
    Plain plain_;
    double busiest_s_ = 0;
    std::optional<size_t> followed_;
    std::vector<clq_transform> places_;
    bool paints_people_ = true;
    mutable Shadows shadows_;
};

}  // namespace

std::unique_ptr<Scene> make(Library &library, const CrowdOptions &crowd_options, const Options &options)
{
    return std::make_unique<Walkers>(library, crowd_options, options);
}

}  // namespace scenes::walkers
