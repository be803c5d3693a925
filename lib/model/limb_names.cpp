#include "lib/model/limb_names.h"

#include <algorithm>
#include <vector>

namespace claque::model
{

namespace
{

// ASCII, whatever the host's locale is.
bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
bool is_alnum(char c) { return is_upper(c) || is_lower(c) || (c >= '0' && c <= '9'); }
char lower(char c) { return is_upper(c) ? static_cast<char>(c - 'A' + 'a') : c; }

// 0 thigh, 1 shin, 2 foot, 3 toes; none: another part, or a control that is no bone of the leg.
uint32_t part_of(std::string_view plain)
{
    if (is_control(plain)) return none;
    if (has(plain, "thigh") || has(plain, "upleg") || has(plain, "upperleg") || has(plain, "legupper")) return 0;
    if (has(plain, "shin") || has(plain, "calf") || has(plain, "lowerleg") || has(plain, "leglower")) return 1;
    if (has(plain, "toe") || has(plain, "ball")) return 3;
    if (has(plain, "foot") || has(plain, "ankle")) return 2;
    return is_with_side(plain, "leg") ? 1 : none;
}

// The same of skeletons whose joints have the names of joints (Maya): a hip moves the thigh, a knee the shin.
uint32_t part_of_joint(std::string_view plain)
{
    if (is_control(plain) || has(plain, "hips")) return none;
    return has(plain, "knee") ? 1 : has(plain, "hip") ? 0 : none;
}

// Nodes with the names of limbs. Several may share a name: a skin's joint is the limb, else a node that draws nothing,
// else one of a rigid mesh. The first of equals is the nearest to the root.
class Limbs
{
public:
    struct Limb {
        int side, part;
        bool operator==(const Limb &other) const { return side == other.side && part == other.part; }
    };
    using Flags = std::vector<bool>;  // one a node

    explicit Limbs(const Rig &rig) : rig_(rig), limbs_(rig.node_count(), {-1, -1}), ranks_(ranks_of(rig))
    {
        for (uint32_t i = 0; i < rig.node_count(); ++i) {
            const std::pmr::string plain = plain_name(rig.node_names[i], rig.parents.get_allocator().resource());
            const Side side = side_of(rig.node_names[i], plain);
            uint32_t part = part_of(plain);
            if (part == 1 && is_with_side(plain, "leg") && is_above_knee(rig, i)) part = 0;
            if (side != Side::unknown && part != none) limbs_[i] = {side == Side::left ? 0 : 1, static_cast<int>(part)};
        }
        const std::vector<Limb> named = limbs_;
        for (uint32_t i = 0; i < rig.node_count(); ++i) {
            const std::pmr::string plain = plain_name(rig.node_names[i], rig.parents.get_allocator().resource());
            const Side side = side_of(rig.node_names[i], plain);
            const uint32_t part = part_of_joint(plain);
            if (side == Side::unknown || part == none) continue;
            const Limb limb = {side == Side::left ? 0 : 1, static_cast<int>(part)};
            if (std::find(named.begin(), named.end(), limb) == named.end()) limbs_[i] = limb;
        }
    }

    // The best node of this name among `allowed` (empty: all), of equal rank one of `preferred`; none: there is none.
    uint32_t best(Limb limb, const Flags &preferred, const Flags &allowed = {}) const
    {
        uint32_t found = none, least = none;
        for (uint32_t i = 0; i < rig_.node_count(); ++i) {
            if (!(limbs_[i] == limb) || (!allowed.empty() && !allowed[i])) continue;
            const uint32_t score = 2 * ranks_[i] + (preferred.empty() || preferred[i] ? 0 : 1);
            if (score < least) least = score, found = i;
        }
        return found;
    }
    // Nodes above one of this name.
    Flags above(Limb limb) const
    {
        Flags out(rig_.node_count());
        for (uint32_t i = rig_.node_count(); i-- > 0;)
            if (rig_.parents[i] != none && (out[i] || limbs_[i] == limb)) out[rig_.parents[i]] = true;
        return out;
    }
    Flags below(uint32_t node) const
    {
        Flags out(rig_.node_count());
        for (uint32_t i = 0; i < rig_.node_count(); ++i)
            out[i] = rig_.parents[i] != none && (rig_.parents[i] == node || out[rig_.parents[i]]);
        return out;
    }

private:
    const Rig &rig_;
    std::vector<Limb> limbs_;
    std::vector<uint8_t> ranks_;
};

}  // namespace

std::pmr::string plain_name(std::string_view name, std::pmr::memory_resource *memory)
{
    std::pmr::string out(memory);
    for (const char c : name) {
        if (c == ':') out.clear();
        else if (is_alnum(c)) out.push_back(lower(c));
    }
    return out;
}

bool has(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

Side side_of(std::string_view name, std::string_view plain)
{
    if (has(plain, "left")) return Side::left;
    if (has(plain, "right")) return Side::right;
    const auto is_separator = [](char c) { return !is_alnum(c); };
    for (size_t i = 0; i < name.size(); ++i) {
        const bool begins = i == 0 || is_separator(name[i - 1]),
                   ends = i + 1 == name.size() || is_separator(name[i + 1]);
        const bool before_word = !ends && is_lower(name[i]) && is_upper(name[i + 1]);  // Daz and Poser: lThigh
        if (!begins || !(ends || before_word)) continue;
        if (lower(name[i]) == 'l') return Side::left;
        if (lower(name[i]) == 'r') return Side::right;
    }
    // Some writers drop the separator: FootL.
    if (name.size() > 1 && is_lower(name[name.size() - 2])) {
        if (name.back() == 'L') return Side::left;
        if (name.back() == 'R') return Side::right;
    }
    return Side::unknown;
}

bool is_with_side(std::string_view plain, std::string_view word)
{
    const size_t at = plain.find(word);
    if (at == std::string_view::npos) return false;
    if (at != 0 && at + word.size() != plain.size()) return false;
    const std::string_view side(plain.data() + (at == 0 ? word.size() : 0), plain.size() - word.size());
    return side == "left" || side == "right" || side == "l" || side == "r";
}

bool is_above_knee(const Rig &rig, uint32_t node)
{
    const auto plain = [&](uint32_t i) {
        return plain_name(rig.node_names[i], rig.parents.get_allocator().resource());
    };
    if (rig.parents[node] != none && part_of(plain(rig.parents[node])) == 0) return false;
    for (uint32_t i = node + 1; i < rig.node_count(); ++i)
        if (rig.parents[i] == node && has(plain(i), "knee")) return true;
    return false;
}

bool is_control(std::string_view plain)
{
    for (const char *other : {"twist", "ik", "pole", "roll", "control", "ctrl", "target", "end", "helper"})
        if (has(plain, other)) return true;
    return false;
}

bool is_below(const model::Rig &rig, uint32_t node, uint32_t above)
{
    while (node != none && node != above) node = rig.parents[node];
    return node == above;
}

std::vector<uint8_t> ranks_of(const Rig &rig)
{
    std::vector<uint8_t> ranks(rig.node_count(), 1);
    constexpr math::Affine identity;
    for (const PaletteEntry &entry : rig.palette) {
        const bool rigid = std::equal(identity.c, identity.c + 12, entry.inverse_bind.c);
        if (!rigid) ranks[entry.node] = 0;
        else if (ranks[entry.node] == 1) ranks[entry.node] = 2;
    }
    return ranks;
}

void find_limbs(const Rig &rig, uint32_t (&legs)[2][4])
{
    const Limbs limbs(rig);
    for (int side = 0; side < 2; ++side) {
        uint32_t *leg = legs[side];
        leg[0] = limbs.best({side, 0}, limbs.above({side, 1}));
        leg[1] = limbs.best({side, 1}, limbs.above({side, 2}), limbs.below(leg[0]));
        leg[2] = limbs.best({side, 2}, limbs.below(leg[1]));  // feet may hang on the root
        leg[3] = limbs.best({side, 3}, {}, limbs.below(leg[2]));
    }
}

}  // namespace claque::model
