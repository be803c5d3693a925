// Three individuals side by side, the middle one between callbacks of a host (S0 7.1).
#pragma once

#include <cstdlib>
#include <functional>

#include "tests/gl/support/fixture.h"

namespace gltest
{

using claque::draw::DrawList;

// A host's hooks as functions that a test supplies.
struct Callbacks {
    std::function<int32_t()> before;
    std::function<void()> after;
    uint32_t index1 = 0, generation = 0;
    claque::draw::Hooks hooks;

    Callbacks(std::function<int32_t()> b, std::function<void()> a) : before(std::move(b)), after(std::move(a))
    {
        if (before) hooks.before = call_before;
        if (after) hooks.after = call_after;
        hooks.user = this;
    }
    Callbacks(const Callbacks &) = delete;

    static int32_t call_before(void *user, uint32_t index1, uint32_t generation)
    {
        Callbacks &self = *static_cast<Callbacks *>(user);
        self.index1 = index1, self.generation = generation;
        return self.before();
    }
    static void call_after(void *user, uint32_t index1, uint32_t generation)
    {
        Callbacks &self = *static_cast<Callbacks *>(user);
        self.index1 = index1, self.generation = generation;
        self.after();
    }
};

class HooksTest : public GlTest
{
protected:
    void SetUp() override
    {
        GlTest::SetUp();
        if (posed_.tmpl) return;
        posed_ = small_posed();
        paint(*posed_.tmpl);
    }

    DrawList trio() const
    {
        DrawList list = list_of(posed_, camera_on(posed_, 5, -0.5f, 0.4f, 4.0f / 3.0f));
        for (uint32_t i = 0; i < 3; ++i) {
            claque::draw::Item item = list.items[0];
            item.actor_index = 10 + i;
            item.generation = 5;
            item.model_view[12] += 2.6f * (float(i) - 1);
            list.items.push_back(item);
        }
        list.items.erase(list.items.begin());
        return list;
    }
    DrawList trio(const Callbacks &of_the_middle) const
    {
        DrawList list = trio();
        list.items[1].hooks = &of_the_middle.hooks;
        return list;
    }
    // Its neighbours lie wholly outside.
    static bool is_middle(size_t byte) { return std::abs(int(byte / 3 % width) - width / 2) < 58; }

    static void expect_same_neighbours(const Picture &a, const Picture &b)
    {
        uint32_t differ = 0;
        for (size_t i = 0; i < a.size(); ++i) differ += !is_middle(i) && a[i] != b[i];
        EXPECT_EQ(differ, 0u);
    }
    static bool same_middle(const Picture &a, const Picture &b)
    {
        for (size_t i = 0; i < a.size(); ++i)
            if (is_middle(i) && a[i] != b[i]) return false;
        return true;
    }
    Picture calm(const passes::RendererOptions &options = {})
    {
        return draw(*context_, *make_renderer_of(posed_, options), trio());
    }
    PosedModel posed_;
};

}  // namespace gltest
