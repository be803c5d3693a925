// A real window, with events of a mouse and of keys that come from the X server.
#include <chrono>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include <gtest/gtest.h>

#include "tests/hosts/x_server.h"

namespace
{

class Window : public testing::Test
{
protected:
    void SetUp() override
    {
        if (!server_.why_not().empty()) GTEST_SKIP() << server_.why_not();
        if (std::system("command -v xdotool > /dev/null") != 0) GTEST_SKIP() << "there is no xdotool";
        folder_ = testing::TempDir() + "claque_view_window_" + std::to_string(getpid());
        std::filesystem::create_directories(folder_);
        process_ = fork();
        if (process_ == 0) {
            const int log = open((folder_ + "/log").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
            dup2(log, STDOUT_FILENO);
            dup2(log, STDERR_FILENO);
            execl(CLAQUE_COMMAND, CLAQUE_COMMAND, "view", "--scene", "parade", "--count", "3", "--size", "640x480",
                  "--shots", folder_.c_str(), static_cast<char *>(nullptr));
            _exit(127);
        }
        ASSERT_GT(process_, 0);
    }
    void TearDown() override
    {
        if (process_ > 0 && status_ < 0) {
            kill(process_, SIGKILL);
            waitpid(process_, nullptr, 0);
        }
        if (!folder_.empty()) std::filesystem::remove_all(folder_);
    }

    static bool does(const std::string &steps)
    {
        return std::system(("xdotool " + steps + " > /dev/null 2>&1").c_str()) == 0;
    }
    // Waits for what the program does; a minute is for machines that do much else.
    template <class Condition>
    static bool comes(const Condition &condition)
    {
        for (int tenths = 0; tenths < 600; ++tenths) {
            if (condition()) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
        }
        return false;
    }
    std::string log() const
    {
        std::ifstream file(folder_ + "/log");
        return {std::istreambuf_iterator<char>(file), {}};
    }
    bool ends() { return waitpid(process_, &status_, WNOHANG) == process_; }

    hosts_test::XServer server_;
    std::string folder_;
    pid_t process_ = -1;
    int status_ = -1;
};

TEST_F(Window, OpensTakesAClickAndClosesByItsKey)
{
    ASSERT_TRUE(comes([] { return does("search --name claque mousemove --window %1 60 430"); }));
    // The button "picture" saves one.
    const std::string saved = folder_ + "/view-1.png";
    EXPECT_TRUE(comes([&] {
        if (std::filesystem::exists(saved)) return true;
        does("search --name claque mousemove --window %1 184 422 click 1");
        return false;
    }));
    EXPECT_TRUE(comes([&] {
        if (ends()) return true;
        does("search --name claque windowfocus key ctrl+q");
        return false;
    }));
    EXPECT_TRUE(WIFEXITED(status_) && WEXITSTATUS(status_) == 0) << log();
}

TEST(NoScreen, IsSaidAtOnce)
{
    const std::string log = testing::TempDir() + "claque_view_no_screen_" + std::to_string(getpid());
    const int status = std::system(("env -u DISPLAY -u WAYLAND_DISPLAY timeout 60 " CLAQUE_COMMAND
                                    " view --scene parade --count 1 > " +
                                    log + " 2>&1")
                                       .c_str());
    std::ifstream file(log);
    const std::string said{std::istreambuf_iterator<char>(file), {}};
    std::filesystem::remove(log);
    EXPECT_EQ(WEXITSTATUS(status), 1) << said;
    EXPECT_NE(said.find("claque: no window could be opened"), std::string::npos) << said;
}

}  // namespace
