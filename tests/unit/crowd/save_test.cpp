#include "lib/crowd/save.h"

#include <functional>

#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "lib/crowd/edits.h"
#include "tests/law/support/figure.h"

namespace claque::crowd
{

using namespace testing_support;

namespace
{

class Bytes : public base::Sink
{
public:
    void take(const uint8_t *bytes, size_t count) override { all.insert(all.end(), bytes, bytes + count); }
    std::vector<uint8_t> all;
};

// Resolves one template, and accepts descriptions as they are.
class Trusting : public Resolver
{
public:
    explicit Trusting(const model::Template &tmpl) : tmpl_(tmpl) {}
    const model::Template &find_template(std::string_view name, uint64_t structure) override
    {
        if (name != tmpl_.name || structure != structure_hash(tmpl_)) base::fail(CLQ_ARGUMENT, "another one");
        return tmpl_;
    }
    void add(Behaviours &out, uint32_t, Mechanism &&mechanism) override { out.add(std::move(mechanism), {}); }
    void add(Behaviours &out, uint32_t, RootPath &&path) override { out.add(std::move(path)); }

private:
    const model::Template &tmpl_;
};

class SaveTest : public ::testing::Test
{
protected:
    SaveTest() : figure_(make_figure()), crowd_(std::pmr::get_default_resource(), 7) {}
    Id add(uint64_t seed = 1) { return crowd::create(crowd_, *figure_, Transform(), Play(), seed); }
    std::vector<uint8_t> saved() const
    {
        Bytes out;
        save(crowd_, out);
        return out.all;
    }
    void restore_into(Crowd &out, const std::vector<uint8_t> &bytes)
    {
        Trusting resolver(*figure_);
        Crowd restored(out.memory());
        restore(bytes.data(), bytes.size(), resolver, restored);
        crowd::swap_state(out, restored);
    }

    std::unique_ptr<model::Template> figure_;
    Crowd crowd_;
};

}  // namespace

TEST_F(SaveTest, FreeRowsAreUsedAgainInTheSameOrder)
{
    std::vector<Id> ids;
    for (int i = 0; i < 20; ++i) ids.push_back(add());
    for (const int i : {3, 17, 0, 8, 9}) crowd::destroy(crowd_, ids[static_cast<size_t>(i)]);
    Crowd other(std::pmr::get_default_resource(), 1);
    restore_into(other, saved());
    EXPECT_EQ(other.seed(), 7u);
    EXPECT_EQ(other.actor_count(), 15u);
    for (int i = 0; i < 8; ++i) {
        const Id here = add(), there = crowd::create(other, *figure_, Transform(), Play(), 1);
        EXPECT_EQ(there.index1, here.index1);
        EXPECT_EQ(there.generation, here.generation);
    }
}

TEST_F(SaveTest, EqualStatesHaveEqualBytesWhateverCameBefore)
{
    const Id id = add();
    const std::vector<uint8_t> before = saved();
    // Memory was allocated and freed: this is not part of the state.
    crowd_.behaviours().add(RootPath(std::pmr::get_default_resource()));
    const std::vector<uint8_t> with_path = saved();
    EXPECT_NE(with_path, before);
    crowd::play_root_path(crowd_, id, RootPathPlay{0, 1, 0, 0});
    EXPECT_NE(saved(), with_path);
    crowd::play_root_path(crowd_, id, RootPathPlay());
    crowd::follow_ground(crowd_, id, 1, 2);
    EXPECT_NE(saved(), with_path);
    crowd::follow_ground(crowd_, id, 0, 0);
    crowd::play(crowd_, id, Play());
    EXPECT_EQ(saved(), with_path);
}

TEST_F(SaveTest, HooksStayWithActorsWhoseIdIsInBothStatesAndTheGroundStays)
{
    const Id kept = add(), changed = add(), late = add();
    const std::vector<uint8_t> bytes = saved();
    int mark = 0;
    const auto ground = [](void *, const double *) { return 0.0; };
    const clq_actor_hooks hooks = {nullptr, [](void *, clq_actor) {}, &mark};
    crowd::set_ground(crowd_, ground, &mark);
    crowd::set_hooks(crowd_, kept, hooks);
    crowd::destroy(crowd_, changed);
    const Id in_its_row = add();
    ASSERT_EQ(in_its_row.index1, changed.index1);
    crowd::set_hooks(crowd_, in_its_row, hooks);
    crowd::destroy(crowd_, late);
    restore_into(crowd_, bytes);
    ASSERT_NE(crowd_.extra_of(crowd_.row_of(kept)), nullptr);
    EXPECT_EQ(crowd_.extra_of(crowd_.row_of(kept))->hooks.user, &mark);
    EXPECT_EQ(crowd_.extra_of(crowd_.row_of(changed)), nullptr) << "another actor had its row";
    EXPECT_EQ(crowd_.extra_of(crowd_.row_of(late)), nullptr);
    EXPECT_EQ(crowd_.ground_user(), &mark);
}

TEST_F(SaveTest, NoVersionIsOneThatWasThereBefore)
{
    const Id a = add(), group = crowd::create_group(crowd_, Transform());
    crowd::join(crowd_, a, group, nullptr);
    const std::vector<uint8_t> bytes = saved();
    uint64_t play = crowd_.actor(0).play_version, sphere = crowd_.group(0).version;
    uint64_t structure = crowd_.structure_version();
    for (int i = 0; i < 3; ++i) {
        restore_into(crowd_, bytes);
        EXPECT_GT(crowd_.actor(0).play_version, play);
        EXPECT_GT(crowd_.group(0).version, sphere);
        EXPECT_GT(crowd_.structure_version(), structure);
        play = crowd_.actor(0).play_version, sphere = crowd_.group(0).version;
        structure = crowd_.structure_version();
    }
}

TEST_F(SaveTest, AStructureIsTheSameForEqualTemplatesAndDiffersWithWhatACrowdSpeaksOf)
{
    const uint64_t structure = structure_hash(*figure_);
    EXPECT_EQ(structure_hash(*make_figure()), structure);
    const auto changes = [&](const char *what, const std::function<void(model::Template &)> &change) {
        const std::unique_ptr<model::Template> other = make_figure();
        change(*other);
        EXPECT_NE(structure_hash(*other), structure) << what;
    };
    changes("a node's name", [](model::Template &t) { t.rig.node_names[1] += "x"; });
    changes("a parent", [](model::Template &t) { t.rig.parents[2] = 0 + (t.rig.parents[2] == 0); });
    changes("a clip's name", [](model::Template &t) { t.rig.clip_names[0] += "x"; });
    changes("a clip's length", [](model::Template &t) { t.rig.clips[0].duration_s += 0.5f; });
    changes("a zone", [](model::Template &t) { t.zone_names[0] += "x"; });
    changes("a level's distance", [](model::Template &t) { t.levels.back().switch_distance_m += 1; });
    changes("the sphere", [](model::Template &t) { t.sklsroot.radius *= 1.01f; });
}

}  // namespace claque::crowd
