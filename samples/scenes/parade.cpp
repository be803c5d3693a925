// Rows of one character, any character, scaled to the size of a person, each individual in its own colours and playing
// the clips in turn.
#include <algorithm>
#include <cmath>

#include "samples/scenes/camera_fit.h"
#include "samples/scenes/clip_way.h"
#include "samples/scenes/light.h"
#include "samples/scenes/posed_template.h"
#include "samples/scenes/random.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/shadows.h"
#include "samples/scenes/sky.h"
#include "samples/scenes/template_names.h"

namespace scenes
{
namespace
{

constexpr double size_m = 1.75;  // the longest side of a character, once scaled
constexpr double fov_deg = 30;

// A character in metres: its extent round its Reference Point.
struct Extent {
    double scale = 1;
    double ground = 0;       // its lowest point, scaled
    double height = size_m;  // above that
    double middle_x = 0, middle_z = 0;
    double half_x = 0.4, half_z = 0.4;
};

Extent extent_of(const PoseBox &box)
{
    Extent e;
    if (box.is_none()) return e;
    std::array<double, 3> first = box.low, last = box.high;
    // Most characters stand on y = 0; parts a little below it are a blade, a tail or a jump. Others stand on their
    // lowest point.
    if (std::abs(first[1]) < 0.15 * (last[1] - first[1])) first[1] = 0;
    const double longest = std::max({last[0] - first[0], last[1] - first[1], last[2] - first[2]});
    e.scale = longest > 0 && std::isfinite(longest) ? size_m / longest : 1;
    e.ground = first[1] * e.scale;
    e.height = (last[1] - first[1]) * e.scale;
    e.middle_x = (first[0] + last[0]) / 2 * e.scale;
    e.middle_z = (first[2] + last[2]) / 2 * e.scale;
    e.half_x = (last[0] - first[0]) / 2 * e.scale;
    e.half_z = (last[2] - first[2]) / 2 * e.scale;
    return e;
}

class Parade final : public Scene
{
public:
    Parade(Library &library, const CrowdOptions &crowd_options, const Character &character)
        : seed_(crowd_options.seed),
          character_(character),
          scene_crowd_(library, crowd_options),
          sky_(crowd_options.seed, Sky::Land::studio)
    {
        if (!character_.tmpl) character_.tmpl = library.builtin("citizen");
        PosedTemplate posed(library, character_.tmpl);
        info_ = posed.info();
        first_ = std::min(character_.first_clip, info_.clip_count);
        clips_ = std::min(info_.clip_count - first_, character_.one_clip ? 1 : info_.clip_count);
        // Files with their clips in the order of the alphabet begin with "Death".
        const uint32_t stands = standing_clip(character_.tmpl);
        if (first_ == 0 && !character_.one_clip && stands != CLQ_NONE) lead_ = stands;
        extent_ = extent_of(standing_box(posed, character_.first_clip, character_.one_clip));
        across_ = std::max(0.75, 2.3 * extent_.half_x);
        deep_ = std::max(1.0, 2.2 * extent_.half_z);
        line_up(static_cast<int>(crowd_options.count));
        measure_clips(posed, crowd_options.count);
        for (uint32_t i = 0; i < crowd_options.count; ++i) enter(i, crowd_options.count);
        lay_ground();
    }

    clq_crowd *crowd() const override { return scene_crowd_.crowd(); }
    std::vector<clq_actor> actors() const override { return scene_crowd_.actors(); }
    std::vector<clq_template *> templates() const override { return {character_.tmpl}; }

    clq_camera camera(Shot shot, double aspect, double) const override
    {
        const bool all = shot == Shot::overview;
        return frame(all ? rows_ : 1, all ? columns_ : std::min(columns_, 3), aspect);
    }

    bool take_shadows(clq_shadow_def &def) override
    {
        paints_people_ = false;
        def = shadows_in(light_);
        def.ground = CLQ_SHADOW_GROUND_PLANE;  // characters need not stand on their origin
        return true;
    }

    void place(double time_s) override
    {
        moving_.clear();
        if (paints_people_)
            for (const uint32_t person : travellers_) lay_rim(person, time_s);
    }

    void prepare(const Gl &gl) override { shadows_.prepare(gl); }

    void set_light(const Gl &g, const Eye &eye) const override { set_lights(g, light_, eye); }
    void draw_environment(const Gl &g, const Eye &eye) const override
    {
        g.Disable(gl::lighting);
        ground_.draw(g);
        sky_.draw(g, eye);  // lighting is on again
        if (paints_people_) shadows_.draw(g, moving_);
    }

private:
    // Selects the number of columns that brings the camera nearest.
    void line_up(int count)
    {
        constexpr double usual_aspect = 4.0 / 3.0;
        double nearest = 0;
        for (int columns = 1; columns <= count && columns < 4 * std::sqrt(count) + 2; ++columns) {
            const int rows = (count + columns - 1) / columns;
            if (rows > columns + 1) continue;  // rows far behind are not visible
            const double distance = fit_camera({room(rows, columns)}, fov_deg, usual_aspect, pitch_of(rows)).distance;
            if (nearest > 0 && distance >= nearest) continue;
            nearest = distance;
            columns_ = columns;
            rows_ = rows;
        }
    }

    // The space of rows of standing people, from the middle of the first.
    PoseBox room(int rows, int columns) const
    {
        const double half_x =
            (columns - 1) * across_ / 2 + (rows > 1 && columns > 1 ? across_ * 0.25 : 0) + extent_.half_x;
        return {{-half_x, 0, -(rows - 1) * deep_ - extent_.half_z}, {half_x, extent_.height, extent_.half_z}};
    }

    static double pitch_of(int rows) { return rows > 1 ? 0.36 : 0.10; }

    uint32_t clip_of(uint32_t person) const { return clips_ ? first_ + (lead_ + person) % clips_ : CLQ_NONE; }

    // The boxes and ways of the clips that are shown, in metres from a Reference Point.
    void measure_clips(PosedTemplate &posed, uint32_t people)
    {
        const uint32_t shown = std::min(clips_, people);
        const uint32_t poses = std::clamp(400 / std::max(1u, shown), 3u, 33u);
        for (uint32_t i = 0; i < std::max(1u, shown); ++i) {
            const bool moves = i < shown;
            if (!moves) posed.pose(CLQ_NONE, 0);
            std::vector<PoseBox> boxes = moves ? posed.boxes_of_clip(clip_of(i), poses) : std::vector{posed.box()};
            clip_boxes_.push_back(PoseBox::none());
            for (PoseBox &box : boxes) {
                for (size_t axis = 0; axis < 3; ++axis) box.low[axis] *= extent_.scale, box.high[axis] *= extent_.scale;
                clip_boxes_.back().hold(box);
            }
            ways_.emplace_back(boxes, moves ? posed.length_s(clip_of(i)) : 0);
        }
    }

    // The space of the people in the middle of the first rows, in all poses of their clips, from the ground up.
    std::vector<PoseBox> filled(int rows, int columns) const
    {
        std::vector<PoseBox> out;
        const int first = (columns_ - columns) / 2;
        for (int row = 0; row < rows; ++row) {
            PoseBox all = PoseBox::none();
            for (int column = first; column < first + columns; ++column) {
                const size_t person = static_cast<size_t>(row * columns_ + column);
                if (person >= scene_crowd_.places().size()) break;
                const clq_transform &place = scene_crowd_.places()[person];
                PoseBox box = clip_boxes_[person % clip_boxes_.size()];
                if (box.is_none()) box = {{0, 0, 0}, {0, 0, 0}};
                for (size_t axis = 0; axis < 3; ++axis)
                    box.low[axis] += place.position[axis], box.high[axis] += place.position[axis];
                box.low[1] = 0, box.high[1] = std::max(box.high[1], 0.0);
                all.hold(box);
            }
            if (!all.is_none()) out.push_back(all);
        }
        return out;
    }

    clq_camera frame(int rows, int columns, double aspect) const
    {
        const CameraFit f = fit_camera(filled(rows, columns), fov_deg, aspect, pitch_of(rows));
        // Where a model is long and low, the rounds end anywhere, also under the ground.
        const double eye_y = std::max(f.target_y - f.fy * f.distance, 0.05 * f.distance);
        return look({f.target_x, eye_y, f.target_z - f.fz * f.distance}, {f.target_x, f.target_y, f.target_z}, fov_deg,
                    aspect, f.distance * 0.02, f.distance * 40 + 100);
    }

    clq_play play(uint32_t person) const
    {
        clq_play play = {};
        play.clip = clip_of(person), play.speed = 1;
        if (character_.one_clip) return play;
        play.speed = static_cast<float>(random_between(seed_, person, Purpose::speed, 0.9, 1.1));
        clq_clip_info clip = clq_clip_info_init();
        if (play.clip != CLQ_NONE && clq_template_get_clip(character_.tmpl, play.clip, &clip) == CLQ_OK)
            play.phase_s = static_cast<float>(random_unit(seed_, person, Purpose::phase) * clip.duration_s);
        return play;
    }

    void enter(uint32_t person, uint32_t count)
    {
        const int row = static_cast<int>(person) / columns_, column = static_cast<int>(person) % columns_;
        const int here = std::min(columns_, static_cast<int>(count) - row * columns_);  // the last row is centred too
        const double x =
            (column - (here - 1) * 0.5) * across_ + (row % 2 == 1 && here == columns_ ? across_ * 0.25 : 0);
        const double z = -row * deep_;
        clq_transform place =
            stand(x - extent_.middle_x, -extent_.ground, z - extent_.middle_z, 0, 1, static_cast<float>(extent_.scale));
        scene_crowd_.enter({character_.tmpl, place, play(person)});
        if (ways_[person % ways_.size()].is_long()) return travellers_.push_back(person);
        const auto [rx, rz] = rim();
        shadows_.ring(static_cast<float>(x) + 0.05f, 0, static_cast<float>(z) - 0.06f, rx, rz);
    }

    // Half the sizes of the dark rim round a person.
    std::pair<float, float> rim() const
    {
        // Leaves out spread arms of the rest pose, whose shadow is negligible.
        const double body = std::max(extent_.half_z, 0.22 * extent_.height);
        const float rx = static_cast<float>(std::min(extent_.half_x, body) * 1.25 + 0.12);
        const float rz = static_cast<float>(std::min(extent_.half_z, std::max(extent_.half_x, body)) * 1.25 + 0.12);
        return {rx, rz};
    }

    // The rim follows a person whom a clip leads away.
    void lay_rim(uint32_t person, double time_s)
    {
        clq_active_clip active[CLQ_ACTIVE_CLIP_MAX];
        uint32_t count = 0;
        check(clq_actor_get_active_clips(crowd(), scene_crowd_.actors()[person], time_s, active, &count));
        const std::array<double, 2> at = ways_[person % ways_.size()].at(count ? active[0].clip_time_s : 0);
        const clq_transform &place = scene_crowd_.places()[person];
        const auto [rx, rz] = rim();
        Shadows::ring(moving_, static_cast<float>(place.position[0] + at[0]) + 0.05f, 0,
                      static_cast<float>(place.position[2] + at[1]) - 0.06f, rx, rz);
    }

    void lay_ground()
    {
        constexpr Rgb near = {0.60f, 0.59f, 0.57f};
        constexpr int cells = 64;
        const double reach = 3 + 1.2 * (columns_ * across_ + rows_ * deep_), half = 40 * reach;
        // Cells grow outwards, so that the fade into the backdrop is smooth near and cheap far away.
        const auto line = [&](int i) {
            const double t = 2.0 * i / cells - 1;
            return half * t * t * t;
        };
        const Rgb far = Sky::backdrop;
        for (int row = 0; row <= cells; ++row)
            for (int column = 0; column <= cells; ++column) {
                const double x = line(column), z = line(row);
                const double t = std::min(1.0, std::sqrt(x * x + z * z) / (4 * reach));
                const float k = static_cast<float>(t * t * (3 - 2 * t));
                ground_.add(
                    {static_cast<float>(x), 0, static_cast<float>(z)}, {0, 1, 0}, 0, 0,
                    {near.r + (far.r - near.r) * k, near.g + (far.g - near.g) * k, near.b + (far.b - near.b) * k});
            }
        for (uint32_t row = 0; row < cells; ++row)
            for (uint32_t column = 0; column < cells; ++column) {
                const uint32_t a = row * (cells + 1) + column, below = a + cells + 1;
                ground_.triangle(a, below, below + 1);
                ground_.triangle(a, below + 1, a + 1);
            }
    }

    uint64_t seed_;
    Character character_;
    SceneCrowd scene_crowd_;
    clq_template_info info_ = clq_template_info_init();
    Extent extent_;
    uint32_t first_ = 0, clips_ = 0, lead_ = 0;  // the clips that are shown; which of these the first person shows
    std::vector<PoseBox> clip_boxes_;            // of the clips that are shown, in turn, as ways_
    std::vector<ClipWay> ways_;
    std::vector<uint32_t> travellers_;  // people whose ways are long
    Geometry moving_;                   // their rims
    int columns_ = 1, rows_ = 1;
    double across_ = 1, deep_ = 1;
    Daylight light_;
    Sky sky_;
    Geometry ground_;
    Shadows shadows_;
    bool paints_people_ = true;
};

}  // namespace

std::unique_ptr<Scene> make_parade(Library &library, const CrowdOptions &crowd_options, const Character &character)
{
    return std::make_unique<Parade>(library, crowd_options, character);
}

}  // namespace scenes
