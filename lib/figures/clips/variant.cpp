#include "lib/figures/clips/variant.h"

#include <cmath>
#include <cstring>

#include <glm/geometric.hpp>

#include "lib/base/hash.h"
#include "lib/figures/clips/ease.h"
#include "lib/figures/clips/grip.h"
#include "lib/figures/clips/stance.h"
#include "lib/figures/mesh.h"
#include "lib/math/trig.h"

namespace claque::figures
{

namespace
{

constexpr std::array<Bone, 5> trunk_bones = {Bone::spine, Bone::spine_upper, Bone::chest, Bone::neck, Bone::head};
constexpr std::array<Bone, 7> arm_bones = {Bone::clavicle, Bone::upper_arm, Bone::forearm,   Bone::hand,
                                           Bone::thumb,    Bone::fingers,   Bone::fingertips};

float draw(uint64_t seed, uint64_t what) { return base::unit(base::hash(seed, what, base::Purpose::pick)); }

bool is_gait(const ClipMaker &maker)
{
    for (const char *name : {"walk", "jog", "walk_slow", "turn"})
        if (std::strcmp(maker.name, name) == 0) return true;
    return false;
}

// True for clips that begin and end in a pose shared with other clips.
bool is_anchored(const ClipMaker &maker)
{
    const char *name = maker.name;
    return !is_gait(maker) && std::strcmp(name, "applaud") != 0 && std::strcmp(name, "cheer") != 0;
}

Bone opposite(Bone bone)
{
    const int i = index_of(bone), first = index_of(Bone::clavicle);
    return i < first ? bone : static_cast<Bone>((i - first) % 2 == 0 ? i + 1 : i - 1);
}

Pose mirror_image(const Pose &pose)
{
    Pose out;
    for (int i = 0; i < bone_count; ++i) {
        const Bone bone = static_cast<Bone>(i), other = opposite(bone);
        const glm::vec3 shift = pose.shift(other);
        out.set(bone, mirrored(pose.local(other)));
        out.set_shift(bone, glm::vec3(-shift.x, shift.y, shift.z));
    }
    return out;
}

// The position of a wrist in the chest's frame.
glm::vec3 in_chest(const Pose &pose, Side side)
{
    return glm::conjugate(pose.world(Bone::chest)) * (pose.joint(on(side, Bone::hand)) - pose.joint(Bone::chest));
}

glm::vec3 from_chest(const Pose &pose, glm::vec3 p) { return pose.joint(Bone::chest) + pose.world(Bone::chest) * p; }

// The reference from which a clip's movements are measured.
struct Centre {
    std::array<glm::quat, bone_count> mean;
    std::array<glm::vec3, 2> wrists;  // in the chest's frame; where the hands are nearest, if they meet
    bool meets = false;
};

Centre centre_of(const ClipMaker &maker)
{
    constexpr int samples = 96;
    constexpr float touching_m = 0.16f;  // from wrist to wrist
    Centre out;
    std::array<glm::quat, bone_count> sums;
    sums.fill(glm::quat(0, 0, 0, 0));
    std::array<glm::vec3, 2> middle = {glm::vec3(0), glm::vec3(0)}, nearest = middle;
    float least = 1e9f;
    for (int k = 0; k < samples; ++k) {
        const Pose pose = maker.pose_at(static_cast<float>(k) / samples);
        for (int b = 0; b < bone_count; ++b) {
            const glm::quat q = pose.local(static_cast<Bone>(b));
            glm::quat &sum = sums[static_cast<size_t>(b)];
            sum = glm::dot(sum, q) < 0 ? sum - q : sum + q;
        }
        const glm::vec3 left = in_chest(pose, Side::left), right = in_chest(pose, Side::right);
        middle[0] += left / static_cast<float>(samples), middle[1] += right / static_cast<float>(samples);
        const float apart = glm::length(left - right);
        if (apart >= least) continue;
        least = apart;
        nearest = {left, right};
    }
    for (size_t b = 0; b < out.mean.size(); ++b) out.mean[b] = glm::normalize(sums[b]);
    out.meets = least < touching_m;
    out.wrists = out.meets ? nearest : middle;
    return out;
}

// In [-1, 1], with the period of a whole cycle.
float sway(const Variant &v, float phase, uint64_t which)
{
    float sum = 0;
    for (int k = 1; k <= 3; ++k)
        sum += (1.2f - 0.2f * static_cast<float>(k)) * (2 * draw(v.seed, 16 * which + static_cast<uint64_t>(k)) - 1) *
               wave(phase, k, draw(v.seed, 16 * which + 8 + static_cast<uint64_t>(k)));
    return sum / 2.4f;
}

// 1 on the thigh, 0 from a hand's breadth away.
float on_thigh(const Pose &pose, Side side)
{
    const glm::vec3 hip = pose.joint(on(side, Bone::thigh)), knee = pose.joint(on(side, Bone::shin));
    const glm::vec3 wrist = pose.joint(on(side, Bone::hand)), bone = knee - hip;
    const float along = glm::dot(wrist - hip, bone) / glm::dot(bone, bone);
    const float off = glm::length(wrist - hip - bone * (along < 0 ? 0 : along > 1 ? 1 : along));
    return 1 - ease(0.15f, 0.27f, off);
}

class Varying
{
public:
    explicit Varying(const Variant &v)
        : v_(v), maker_(figure_clips()[v.clip]), centre_(centre_of(maker_)), anchored_(is_anchored(maker_))
    {
    }

    Pose at(float phase) const
    {
        // Late in one half of the clip, early in the other, and in time at both ends.
        const Pose own = handed(maker_.pose_at(phase + v_.lead * math::sin(2 * pi * phase) / (2 * pi)), phase);
        const float share = anchored_ ? hold(phase, 0, 0.15f, 0.85f, 1) : 1;
        Pose pose = own;
        move_trunk(pose, phase, share);
        if (share > 0)
            for (const Side side : {Side::left, Side::right}) move_arm(pose, own, side, share);
        return pose;
    }

private:
    // The legs of a clip that stays in place are not mirrored; a gait is mirrored as a whole.
    Pose handed(const Pose &pose, float phase) const
    {
        if (v_.handedness == Handedness::own) return pose;
        const Pose image = mirror_image(pose);
        if (!anchored_) return is_gait(maker_) ? image : with_upper_body(pose, image, 1);
        return with_upper_body(pose, image, hold(phase, 0, 0.16f, 0.84f, 1));
    }

    static Pose with_upper_body(const Pose &pose, const Pose &image, float share)
    {
        Pose out = pose;
        const auto take = [&](Bone bone) { out.set(bone, nlerp(pose.local(bone), image.local(bone), share)); };
        for (const Bone bone : trunk_bones) take(bone);
        for (const Bone left : arm_bones)
            for (const Side side : {Side::left, Side::right}) take(on(side, left));
        return share > 0 ? out : pose;
    }

    void move_trunk(Pose &pose, float phase, float share) const
    {
        if (!(share > 0)) return;
        uint64_t which = 0;
        for (const Bone bone : trunk_bones) {
            const bool looks = bone == Bone::neck || bone == Bone::head;
            const glm::quat own = pose.local(bone);
            glm::quat mean = centre_.mean[static_cast<size_t>(bone)];
            if (v_.handedness == Handedness::other) mean = mirrored(mean);
            const glm::quat wide = nlerp(mean, own, 1 + (v_.trunk - 1) * share);
            const float nod = (looks ? 2.0f : 1.0f) * sway(v_, phase, which++) * share;
            const float look = (looks ? 4.0f : 1.2f) * sway(v_, phase, which++) * share;
            const float cock = (looks ? 1.5f : 0.9f) * sway(v_, phase, which++) * share;
            pose.set(bone, glm::normalize(wide * yaw(look) * pitch(nod) * roll(cock)));
        }
    }

    // The hand moves with the chest or stays where it lies; its path is scaled as the variant says.
    void move_arm(Pose &pose, const Pose &own, Side side, float share) const
    {
        const Bone upper = on(side, Bone::upper_arm), forearm = on(side, Bone::forearm), hand = on(side, Bone::hand);
        const float lies = on_thigh(own, side);
        glm::vec3 way = in_chest(own, side) - wrist_centre(side);
        way *= 1 + (v_.reach - 1) * share * (1 - lies);
        const glm::vec3 goes = from_chest(pose, wrist_centre(side) + way);
        const glm::vec3 stays = own.joint(hand);
        const glm::vec3 wrist = goes + (stays - goes) * lies;

        const glm::quat chest_turn = pose.world(Bone::chest) * glm::conjugate(own.world(Bone::chest));
        const glm::quat with_chest = chest_turn * own.world(hand);
        const glm::vec3 shoulder = pose.joint(upper), elbow = pose.joint(forearm), now = pose.joint(hand);
        move_wrist(pose, side, wrist, elbow - (shoulder + now) * 0.5f);
        pose.set_world(hand, nlerp(with_chest, own.world(hand), lies));
    }

    glm::vec3 wrist_centre(Side side) const
    {
        const bool swapped = v_.handedness == Handedness::other;
        const glm::vec3 c = centre_.wrists[(side == Side::left) != swapped ? 0 : 1];
        return swapped ? glm::vec3(-c.x, c.y, c.z) : c;
    }

    const Variant &v_;
    const ClipMaker &maker_;
    Centre centre_;
    bool anchored_;
};

// Evenly spread over [0, 1) as n grows, for any `from` (golden ratio sequence).
float spread(uint32_t n, float from)
{
    const float x = from + 0.61803399f * static_cast<float>(n);
    return x - std::floor(x);
}

}  // namespace

Variant variant_of(uint32_t clip, uint32_t number)
{
    Variant v;
    v.clip = clip;
    v.number = number;
    v.seed = base::hash(0x7661726965642063ull, clip, base::Purpose::clip, number);
    const ClipMaker &maker = figure_clips()[clip];
    const float tempo = 0.80f + 0.42f * spread(number, draw(clip, 1));
    v.frames = static_cast<int>(static_cast<float>(maker.frames) * tempo + 0.5f);
    // Gaits vary little, since a cycle whose halves differ limps.
    v.lead = (is_anchored(maker) ? 0.35f : 0.12f) * (2 * draw(v.seed, 1000) - 1);
    v.trunk = 0.70f + 0.55f * spread(number, draw(clip, 2));
    // Hands that meet may open wider than in the clip; other hands must not come nearer to the body.
    const float maximum = centre_of(maker).meets ? 1.25f : 1.0f;
    v.reach = 0.80f + (maximum - 0.80f) * spread(number, draw(clip, 3));
    v.handedness = number % 2 == 1 ? Handedness::other : Handedness::own;
    return v;
}

std::string name_of(const Variant &v)
{
    return std::string(figure_clips()[v.clip].name) + (v.number < 10 ? ".0" : ".") + std::to_string(v.number);
}

std::vector<Pose> poses_of(const Variant &v)
{
    const Varying varying(v);
    std::vector<Pose> poses;
    for (int k = 0; k < v.frames; ++k)
        poses.push_back(varying.at(static_cast<float>(k) / static_cast<float>(v.frames)));
    poses.push_back(figure_clips()[v.clip].ending == Ending::closed ? poses.front() : varying.at(1));
    return poses;
}

void add_variants(model::Rig &rig, uint32_t clip_count, Fit fit)
{
    const uint32_t own = static_cast<uint32_t>(figure_clips().size());
    for (uint32_t i = 0; rig.clips.size() < clip_count; ++i) {
        const Variant v = variant_of(i % own, 1 + i / own);
        add_clip(rig, name_of(v).c_str(), poses_of(v), fit);
    }
}

}  // namespace claque::figures
