#include "tests/soak/soak.h"

#include <chrono>
#include <cstdio>
#include <malloc.h>
#include <memory>
#include <unistd.h>

#include "samples/contexts/offscreen.h"
#include "tests/api/failing_memory.h"
#include "tests/gl/support/absent.h"
#include "tests/soak/people.h"

namespace soak
{
namespace
{

constexpr uint64_t between_draws = 100, between_checks = 500, generation = 1500, forgotten = 7;
constexpr int size_px = 64;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool keeps_freed_memory = true;  // a sanitizer does, so resident memory grows; the other counts hold
#else
constexpr bool keeps_freed_memory = false;
#endif

struct Memory {
    int64_t host = 0;  // of the context's allocator while no people live
    double heap_mb = 0, resident_mb = 0;
};

Memory memory_now()
{
    Memory now;
    now.host = failing_memory::host_bytes();
    now.heap_mb = static_cast<double>(mallinfo2().uordblks) / 1e6;
    long pages = 0, all = 0;
    if (std::FILE *file = std::fopen("/proc/self/statm", "r")) {
        if (std::fscanf(file, "%ld %ld", &all, &pages) != 2) pages = 0;
        std::fclose(file);
    }
    now.resident_mb = static_cast<double>(pages) * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
    return now;
}

// Draws people with a renderer of their templates.
class Painter
{
public:
    Painter(clq_context *context, contexts::Offscreen &screen, const People &people) : screen_(screen)
    {
        clq_renderer_def def = clq_renderer_def_init();
        def.get_proc_address = screen.get_proc_address(), def.user = screen.user();
        EXPECT_EQ(clq_renderer_create(context, &def, &renderer_), CLQ_OK) << clq_last_error();
        for (clq_template *tmpl : people.templates)
            EXPECT_EQ(clq_renderer_prepare(renderer_, tmpl), CLQ_OK) << clq_last_error();
    }
    ~Painter() { clq_renderer_destroy(renderer_); }
    Painter(const Painter &) = delete;
    Painter &operator=(const Painter &) = delete;

    std::vector<uint8_t> draw(const People &people)
    {
        const auto clear_colour = function<void (*)(float, float, float, float)>("glClearColor");
        const auto clear = function<void (*)(unsigned)>("glClear");
        clear_colour(0.1f, 0.2f, 0.3f, 1), clear(0x4100);
        for (clq_view *view : people.views)
            EXPECT_EQ(clq_renderer_draw(renderer_, view, nullptr), CLQ_OK) << clq_last_error();
        std::vector<uint8_t> picture;
        screen_.read_rgb(picture);
        return picture;
    }

private:
    template <class Function>
    Function function(const char *name) const
    {
        return reinterpret_cast<Function>(screen_.get_proc_address()(screen_.user(), name));
    }
    contexts::Offscreen &screen_;
    clq_renderer *renderer_ = nullptr;
};

class Soak
{
public:
    Soak(const Plan &plan, contexts::Offscreen &screen) : plan_(plan), screen_(screen), world_(context_def())
    {
        for (clq_template *&tmpl : world_.templates) clq_template_destroy(tmpl), tmpl = nullptr;
        people_ = std::make_unique<People>(world_, plan.seed);
        begin_generation(0);
    }
    ~Soak()
    {
        painter_.reset();
        people_.reset();
        kept_.clear();
        for (clq_template *&tmpl : world_.templates) tmpl = nullptr;
    }

    void step()
    {
        ++step_;
        people_->happen(step_);
        people_->update(step_);
        if (step_ % between_draws == 0) painter_->draw(*people_), ++drawn_;
        if (step_ % between_checks == 0) compare_with_fresh_run();
        if (step_ % generation == 0) renew();
    }

    uint64_t drawn() const { return drawn_; }
    uint64_t compared() const { return compared_; }
    uint64_t different() const { return different_; }
    uint64_t different_pictures() const { return different_pictures_; }
    const People &people() const { return *people_; }
    const std::vector<Memory> &memories() const { return memories_; }

private:
    static const clq_context_def *context_def()
    {
        static clq_context_def def = clq_context_def_init();
        def.allocator = failing_memory::allocator;
        return &def;
    }

    void begin_generation(uint64_t step)
    {
        began_ = step;
        saved_ = people_->save();
        known_ = people_->known;
        painter_ = std::make_unique<Painter>(world_.context, screen_, *people_);
    }

    // A crowd in the state at the generation's beginning, with all commands since and one update.
    void compare_with_fresh_run()
    {
        People::Known now = people_->known;
        std::swap(people_->known, known_);
        People fresh(world_, *people_, saved_);
        std::swap(people_->known, known_);
        for (uint64_t past = began_ + 1; past <= step_; ++past)
            if (!plan_.forgets || past != began_ + forgotten) fresh.happen(past);
        fresh.update(step_);
        ++compared_;
        different_ += fresh.hash() != people_->hash();
        Painter painter(world_.context, screen_, fresh);
        different_pictures_ += painter.draw(fresh) != painter_->draw(*people_);
    }

    // New templates, a new crowd and a new renderer for the same people.
    void renew()
    {
        const std::vector<uint8_t> bytes = people_->save();
        auto next = std::make_unique<People>(world_, *people_, bytes);
        painter_.reset();
        if (plan_.leaks) kept_.push_back(std::move(people_));
        people_ = std::move(next);
        people_->update(step_);
        // What is held while these alone live must not depend on how many came before.
        memories_.push_back(memory_now());
        begin_generation(step_);
    }

    const Plan plan_;
    contexts::Offscreen &screen_;
    TestWorld world_;
    std::unique_ptr<People> people_;
    std::vector<std::unique_ptr<People>> kept_;
    std::unique_ptr<Painter> painter_;
    std::vector<uint8_t> saved_;
    People::Known known_;
    std::vector<Memory> memories_;
    uint64_t step_ = 0, began_ = 0, drawn_ = 0, compared_ = 0, different_ = 0, different_pictures_ = 0;
};

double seconds_since(std::chrono::steady_clock::time_point begin)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void print(const Soak &soak, uint64_t done, double seconds, const Memory &first, const Memory &last)
{
    std::printf(
        "%llu updates, %llu drawn, %llu compared with fresh runs, %.1f s; %llu commands, %llu of them refused\n",
        (unsigned long long)done, (unsigned long long)soak.drawn(), (unsigned long long)soak.compared(), seconds,
        (unsigned long long)soak.people().known.commands, (unsigned long long)soak.people().known.refused);
    std::printf(
        "memory after warm-up and at the end: context %lld and %lld bytes, heap %.3f and %.3f MB, resident %.1f and "
        "%.1f MB\n",
        (long long)first.host, (long long)last.host, first.heap_mb, last.heap_mb, first.resident_mb, last.resident_mb);
}

std::vector<std::string> judged(const Soak &soak)
{
    std::vector<std::string> problems;
    const auto require = [&](bool rule, const char *what) {
        if (!rule) problems.emplace_back(what);
    };
    const std::vector<Memory> &all = soak.memories();
    const Memory &first = all[all.size() / 10], &last = all.back();
    require(soak.people().known.refused * 4 < soak.people().known.commands,
            "more than a quarter of the commands are refused");
    require(soak.different() == 0, "what is shown differs from a fresh run");
    require(soak.different_pictures() == 0, "a picture differs from a fresh run's");
    int64_t smallest = first.host, largest = first.host;
    for (const Memory &one : all) smallest = std::min(smallest, one.host), largest = std::max(largest, one.host);
    // The people of a generation are 40 to 60, so their tables differ, but not more and more.
    require(static_cast<double>(last.host) < 1.3 * static_cast<double>(smallest), "the context's memory grows");
    require(static_cast<double>(largest) < 1.6 * static_cast<double>(smallest), "the context's memory grows at times");
    require(last.heap_mb < first.heap_mb + 1, "the heap grows");
    require(keeps_freed_memory || last.resident_mb < 1.05 * first.resident_mb + 4, "resident memory grows");
    require(!testing::Test::HasFailure(), "a call failed, see above");
    return problems;
}

}  // namespace

Outcome run(const Plan &plan)
{
    std::string why;
    const auto screen =
        contexts::make_offscreen(contexts::Kind::any, size_px, size_px, contexts::PixelFormat::rgba8888, why);
    if (!screen) {
        const std::string absent = gltest::absent_gl(contexts::Kind::any);
        if (absent.empty()) return {"", {why}};
        return {absent, {}};
    }
    screen->make_current();
    const auto begin = std::chrono::steady_clock::now();
    const int64_t before = failing_memory::host_bytes();
    auto soak = std::make_unique<Soak>(plan, *screen);
    uint64_t done = 0;
    while (done < plan.updates && (plan.seconds <= 0 || seconds_since(begin) < plan.seconds)) soak->step(), ++done;
    const std::vector<Memory> &all = soak->memories();
    if (all.size() < 2) return {"", {std::to_string(done) + " updates are too few to compare memory"}};
    print(*soak, done, seconds_since(begin), all[all.size() / 10], all.back());
    Outcome outcome = {"", judged(*soak)};
    soak.reset();
    if (const int64_t left = failing_memory::host_bytes() - before; left != 0)
        outcome.problems.push_back(std::to_string(left) + " bytes are left when all has ended");
    return outcome;
}

}  // namespace soak
