// A window while what it shows is loaded.
#include "samples/view/loading.h"

#include <future>
#include <thread>

#include "tests/view/staged.h"

namespace
{

using view_test::Staged;

// A window in memory, which is closed after some frames.
class ShortWindow final : public view::Window
{
public:
    explicit ShortWindow(int frames) : frames_(frames) {}

    GetProcAddress get_proc_address() const override { return surface_->get_proc_address(); }
    void *user() const override { return surface_->user(); }
    const std::string &name() const override { return surface_->name(); }
    void read(int below, int width, int height, std::vector<uint8_t> &out) override
    {
        surface_->read(below, width, height, out);
    }
    void renew() override { surface_->renew(); }
    bool next(view::Input &input) override
    {
        input = {};
        input.width = 320, input.height = 240, input.elapsed_s = 1;
        return frames_-- > 0;
    }

private:
    std::unique_ptr<view::Surface> surface_ = view::make_offscreen_surface(contexts::Kind::any, 320, 240);
    int frames_;
};

class Loading : public Staged
{
protected:
    void SetUp() override
    {
        Staged::SetUp();
        request_.title = "a parade";
        request_.open = [this](scenes::Library &) {
            goes_on_.get_future().wait();
            loaded_ = true;
            view::Opened opened;
            opened.options.scene = "parade";
            opened.options.crowd_options.count = 1;
            return opened;
        };
        request_.progress = [this](const std::string &words) {
            said_.push_back(words);
            if (said_.size() == 3 && goes_on_at_third_) goes_on_.set_value();
        };
    }

    view::Request request_;
    std::promise<void> goes_on_;
    std::vector<std::string> said_;
    bool goes_on_at_third_ = true;
    std::atomic<bool> loaded_{false};
};

TEST_F(Loading, SaysForHowLongAndGivesWhatWasLoaded)
{
    ShortWindow window(1000000);
    const std::optional<view::Loaded> loaded = view::load_in(window, request_);
    ASSERT_TRUE(loaded);
    EXPECT_NE(loaded->scene, nullptr);
    ASSERT_GE(said_.size(), 3u);
    EXPECT_EQ(said_[0], "loading a parade, 1 s");
    EXPECT_EQ(said_[2], "loading a parade, 3 s");
}

TEST_F(Loading, EndsWithTheWindowAndLeavesNoThreadBehind)
{
    goes_on_at_third_ = false;
    ShortWindow window(5);
    std::thread later([this] {
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        goes_on_.set_value();
    });
    EXPECT_FALSE(view::load_in(window, request_));
    EXPECT_TRUE(loaded_) << "loading still runs, and uses what is gone";
    later.join();
}

TEST_F(Loading, PassesOnWhyItFailed)
{
    request_.open = [](scenes::Library &) -> view::Opened { throw scenes::Failure("no such file"); };
    ShortWindow window(1000000);
    try {
        view::load_in(window, request_);
        ADD_FAILURE() << "it loaded";
    } catch (const scenes::Failure &failure) {
        EXPECT_STREQ(failure.what(), "no such file");
    }
}

}  // namespace
