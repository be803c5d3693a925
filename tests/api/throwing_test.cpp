// Callbacks that throw outside updates: while a context, a template or a crowd is made, written or ended, and jobs.
#include <cstring>
#include <mutex>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/api/test_world.h"
#include "tests/api/throwing_host.h"

namespace
{

using throwing::Host;
using throwing::Kind;
using throwing::Moment;

// The bytes of a template that was built while one call of a kind threw.
std::string built(Host &host, clq_context *context, clq_status &status)
{
    const SmallTemplate small;
    clq_template *tmpl = nullptr;
    status = clq_template_build(context, &small.def, &tmpl);
    if (status != CLQ_OK) return "";
    host.written.clear();
    EXPECT_EQ(clq_template_save(tmpl, Host::write, &host), CLQ_OK) << clq_last_error();
    clq_template_destroy(tmpl);
    return host.written;
}

struct Ran {
    std::mutex mutex;
    std::set<uint32_t> indices;
};

void square(void *data, uint32_t index)
{
    Ran &ran = *static_cast<Ran *>(data);
    {
        const std::lock_guard<std::mutex> lock(ran.mutex);
        ran.indices.insert(index);
    }
    if (index == 7) throw std::runtime_error("seven");
    if (index == 90) throw 90;
}

TEST(Throwing, AContextWhoseAllocatorThrowsIsNotMade)
{
    Host host;
    const clq_context_def def = host.context_def(false);
    clq_context *context = nullptr;
    host.arm(Kind::allocate, 1);
    EXPECT_EQ(clq_context_create(&def, &context), CLQ_OUT_OF_MEMORY);
    EXPECT_EQ(context, nullptr);
    host.disarm();
    ASSERT_EQ(clq_context_create(&def, &context), CLQ_OK);
    host.arm(Kind::log, 1);
    clq_context_log(context, CLQ_LOG_WARNING, "said");
    EXPECT_EQ(host.disarm(), 1u);
    EXPECT_EQ(host.last_log, "said");
    host.arm(Kind::release, 1);
    EXPECT_EQ(clq_context_destroy(context), CLQ_OK);
    EXPECT_EQ(host.disarm(), 1u);
}

TEST(Throwing, ATemplateIsTheSameWhateverTasksThrow)
{
    for (const bool threads : {false, true})
        for (const Moment moment : {Moment::before, Moment::half, Moment::after}) {
            Host host;
            const clq_context_def def = host.context_def(threads);
            clq_context *context = nullptr;
            ASSERT_EQ(clq_context_create(&def, &context), CLQ_OK);
            clq_status status = CLQ_OK;
            const std::string calm = built(host, context, status);
            ASSERT_FALSE(calm.empty());
            uint64_t calls = 1;
            for (uint64_t n = 1; n <= calls; ++n) {
                host.arm(Kind::tasks, n, moment);
                EXPECT_EQ(built(host, context, status), calm) << "call " << n;
                EXPECT_EQ(status, CLQ_OK) << clq_last_error();
                calls = host.disarm();
            }
            EXPECT_GT(calls, 1u);
            EXPECT_EQ(clq_context_destroy(context), CLQ_OK);
        }
}

TEST(Throwing, ALogThatThrowsWhileTasksThrowChangesNothing)
{
    Host host;
    clq_context_def def = host.context_def(true);
    def.tasks.run = [](void *, uint32_t, void (*)(void *, uint32_t), void *) { throw 5; };
    clq_context *context = nullptr;
    ASSERT_EQ(clq_context_create(&def, &context), CLQ_OK);
    host.arm(Kind::log, 1);
    clq_status status = CLQ_OK;
    EXPECT_FALSE(built(host, context, status).empty());
    EXPECT_GT(host.disarm(), 0u);
    EXPECT_NE(host.last_log.find("that is no std::exception"), std::string::npos) << host.last_log;
    EXPECT_EQ(clq_context_destroy(context), CLQ_OK);
}

TEST(Throwing, AnAllocatorThatThrowsInATaskFailsTheTemplate)
{
    for (const bool threads : {false, true}) {
        Host host;
        const clq_context_def def = host.context_def(threads);
        clq_context *context = nullptr;
        ASSERT_EQ(clq_context_create(&def, &context), CLQ_OK);
        uint64_t n = 1;
        for (;; ++n) {
            host.arm(Kind::allocate, n);
            clq_template *tmpl = nullptr;
            const SmallTemplate small;
            const clq_status status = clq_template_build(context, &small.def, &tmpl);
            const uint64_t calls = host.disarm();
            if (status == CLQ_OK) clq_template_destroy(tmpl);
            if (calls < n) break;
            ASSERT_EQ(status, CLQ_OUT_OF_MEMORY) << clq_last_error();
        }
        EXPECT_GT(n, 10u);
        EXPECT_EQ(clq_context_destroy(context), CLQ_OK) << clq_last_error();
    }
}

TEST(Throwing, AJobThatThrowsIsReportedByTheLowestIndexAndAllOthersRun)
{
    for (const bool threads : {false, true}) {
        Host host;
        const clq_context_def def = host.context_def(threads);
        clq_context *context = nullptr;
        ASSERT_EQ(clq_context_create(&def, &context), CLQ_OK);
        for (const uint32_t count : {100u, 10000u}) {
            Ran ran;
            EXPECT_EQ(clq_context_run(context, count, square, &ran), CLQ_CALLBACK);
            EXPECT_STREQ(clq_last_error(), "clq_context_run: at index 7 the job threw an exception: seven");
            EXPECT_EQ(ran.indices.size(), count);
        }
        Ran few;
        EXPECT_EQ(clq_context_run(context, 5, square, &few), CLQ_OK);
        EXPECT_EQ(few.indices.size(), 5u);
        EXPECT_EQ(clq_context_destroy(context), CLQ_OK);
    }
}

TEST(Throwing, AWriterThatThrowsFailsTheSaveAndChangesNothing)
{
    Host host;
    TestWorld world;
    clq_crowd *crowd = world.new_crowd();
    world.set_up(crowd);
    world.fill(crowd, 40, 5);
    const uint64_t before = clq_crowd_get_hash(crowd);
    uint64_t n = 1;
    for (;; ++n) {
        host.arm(Kind::write, n);
        const clq_status status = clq_crowd_save(crowd, Host::write, &host);
        if (host.disarm() < n) {
            EXPECT_EQ(status, CLQ_OK) << clq_last_error();
            break;
        }
        ASSERT_EQ(status, CLQ_CALLBACK);
        ASSERT_NE(std::strstr(clq_last_error(), "the write function threw an exception: thrown on purpose"), nullptr)
            << clq_last_error();
        ASSERT_EQ(clq_crowd_get_hash(crowd), before);
    }
    EXPECT_GT(n, 1u);
    host.arm(Kind::write, 1);
    EXPECT_EQ(clq_template_save(world.templates[0], Host::write, &host), CLQ_CALLBACK);
    EXPECT_NE(std::strstr(clq_last_error(), throwing::words), nullptr) << clq_last_error();
    host.disarm();
}

TEST(Throwing, AWriterMayReleaseTheTemplateThatItGets)
{
    TestWorld world;
    const SmallTemplate small;
    clq_template *tmpl = nullptr;
    ASSERT_EQ(clq_template_build(world.context, &small.def, &tmpl), CLQ_OK);
    const auto end = [](void *user, const void *, size_t) {
        clq_template_destroy(static_cast<clq_template *>(user));
        return 1;
    };
    EXPECT_EQ(clq_template_save(tmpl, end, tmpl), CLQ_IO);
}

}  // namespace
