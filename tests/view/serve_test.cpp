// A window served over VNC: what a viewer does and sees, what it must not, and that viewers do not wait for each other.
#include <algorithm>
#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

#include "samples/view/serve/server.h"
#include "tests/gl/support/absent.h"
#include "tests/view/rfb_viewer.h"
#include "tests/view/staged.h"
#include "tests/view/vnc_client.h"

namespace
{

using view_test::Bytes;
using view_test::RfbViewer;
using view_test::Staged;
using view_test::VncClient;

view::serve::Options at_any_port()
{
    view::serve::Options options;
    options.port = 0;
    options.refusal_s = 0;
    return options;
}

TEST(Place, IsAPortAnAddressOrBoth)
{
    const auto read = [](const std::string &text) {
        view::serve::Options options;
        return view::serve::read_place(text, options) ? view::serve::place_text(options.address, options.port) : "none";
    };
    EXPECT_EQ(read("5901"), "127.0.0.1:5901");
    EXPECT_EQ(read("10.0.0.7"), "10.0.0.7:5900");
    EXPECT_EQ(read("0.0.0.0:80"), "0.0.0.0:80");
    EXPECT_EQ(read("[::1]:5901"), "[::1]:5901");
    EXPECT_EQ(read("[::1]"), "[::1]:5900");
    for (const char *wrong :
         {"", "my.glb", "70000", "-1", "1.2.3", "1.2.3.4:", "1.2.3.4:x", "[::1", "[1.2.3.4]:5", "::1"})
        EXPECT_EQ(read(wrong), "none") << wrong;
}

TEST(Password, IsMadeAnewEachTimeAndIsAsLongAsVncAllows)
{
    const std::string first = view::serve::make_password();
    EXPECT_EQ(first.size(), 8u);
    EXPECT_NE(view::serve::make_password(), first);
}

class Served : public Staged
{
protected:
    void SetUp() override
    {
        Staged::SetUp();
        if (IsSkipped()) return;
        open({});
        server_.emplace(at_any_port(), "a window", 480, 480, queue_);
        input_.width = input_.height = 480;
        input_.elapsed_s = 0.04;
    }
    void TearDown() override { server_.reset(); }

    void frame()
    {
        queue_.next(input_);
        session().frame(input_);
        server_->show(window());
    }
    // Draws frames and listens until something holds; a minute is for machines that do much else.
    template <class Condition>
    bool comes(VncClient &client, const Condition &condition)
    {
        for (int frames = 0; frames < 3000; ++frames) {
            frame();
            if (!client.listen(20)) return false;
            if (condition()) return true;
        }
        return false;
    }
    bool shows_the_window(VncClient &client)
    {
        for (int waits = 0; waits < 3000; ++waits) {
            if (client.rgb() == window()) return true;
            if (!client.listen(20)) return false;
        }
        return false;
    }

    view::InputQueue queue_;
    view::Input input_;
    std::optional<view::serve::Server> server_;
};

TEST_F(Served, GivesAViewerThePictureAndTakesItsClicksKeysAndWheel)
{
    VncClient client(server_->port(), server_->password());
    ASSERT_TRUE(client.connected());
    ASSERT_TRUE(comes(client, [&] { return client.updates() > 0; }));
    EXPECT_TRUE(shows_the_window(client));

    const view::Widget *pause = session().ui().find("pause");
    ASSERT_NE(pause, nullptr);
    const int x = static_cast<int>((pause->box.x0 + pause->box.x1) / 2);
    const int y = static_cast<int>((pause->box.y0 + pause->box.y1) / 2);
    client.pointer(x, y, 0), client.pointer(x, y, 1), client.pointer(x, y, 0);
    EXPECT_TRUE(comes(client, [&] { return session().model().clock.paused; }));
    frame();
    EXPECT_TRUE(shows_the_window(client));
    const std::vector<uint8_t> before = window();

    client.pointer(100, 100, 8), client.pointer(100, 100, 0);  // the wheel
    EXPECT_TRUE(comes(client, [&] { return session().model().view.mode == view::CameraMode::free; }));
    EXPECT_TRUE(shows_the_window(client));
    EXPECT_NE(window(), before);

    client.key(0xff09, true), client.key(0xff09, false);  // tab
    EXPECT_TRUE(comes(client, [&] { return !session().model().panel; }));
}

TEST_F(Served, RefusesWrongPasswordsAndOtherWaysIn)
{
    using Answer = RfbViewer::Answer;
    for (const Answer answer : {Answer::wrong, Answer::echo, Answer::nothing}) {
        const RfbViewer viewer(server_->port());
        Bytes offered;
        ASSERT_TRUE(viewer.greet(offered));
        EXPECT_EQ(offered, Bytes({2})) << "a password is the only way in";
        EXPECT_FALSE(viewer.answer(answer, server_->password()));
        EXPECT_TRUE(viewer.closed());
    }
    const RfbViewer without(server_->port());
    Bytes offered;
    ASSERT_TRUE(without.greet(offered));
    without.send({1, 1});  // no security, though it is not offered, and the next step at once
    EXPECT_TRUE(without.closed());
    EXPECT_EQ(server_->watching(), 0);
    EXPECT_FALSE(VncClient(server_->port(), "wrong").connected());
    EXPECT_TRUE(VncClient(server_->port(), server_->password()).connected());
}

TEST_F(Served, LetsGoWhatAViewerHeldWhenItLeft)
{
    {
        VncClient client(server_->port(), server_->password());
        ASSERT_TRUE(client.connected());
        client.pointer(100, 100, 1);
        client.key('w', true);
        EXPECT_TRUE(comes(client, [&] { return input_.buttons[view::left_button] && input_.keys['W']; }));
    }
    for (int frames = 0; frames < 3000 && (input_.buttons[view::left_button] || input_.keys['W']); ++frames) {
        frame();
        usleep(10000);
    }
    EXPECT_FALSE(input_.buttons[view::left_button]);
    EXPECT_FALSE(input_.keys['W']);
}

// Not by what a test calls, but by the command with its own words.
TEST(TheCommand, SaysItsPlaceAndPasswordAndServesThere)
{
    std::string why_not;
    if (!contexts::make_offscreen(contexts::Kind::any, 8, 8, contexts::PixelFormat::rgba8888, why_not))
        END_WITHOUT_CONTEXT(contexts::Kind::any, why_not);
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const pid_t process = fork();
    if (process == 0) {
        dup2(ends[1], STDOUT_FILENO);
        execl(CLAQUE_COMMAND, CLAQUE_COMMAND, "view", "--serve", "127.0.0.1:0", "--scene", "parade", "--count", "1",
              "--size", "320x240", static_cast<char *>(nullptr));
        _exit(127);
    }
    close(ends[1]);
    std::string said;
    for (char letter = 0; said.find("ctrl+C") == std::string::npos && read(ends[0], &letter, 1) == 1;) said += letter;
    const std::string place = "127.0.0.1:", word = "its password is ";
    const int port = std::atoi(said.c_str() + said.find(place) + place.size());
    const std::string password = said.substr(said.find(word) + word.size(), 8);
    {
        VncClient wrong(port, "wrong"), client(port, password);
        EXPECT_FALSE(wrong.connected());
        EXPECT_TRUE(client.connected()) << said;
        bool drawn = false;
        for (int waits = 0; client.connected() && waits < 3000 && !drawn; ++waits) {
            if (!client.listen(20)) break;
            const std::vector<unsigned char> rgb = client.rgb();
            drawn = std::count(rgb.begin(), rgb.end(), 0) < static_cast<std::ptrdiff_t>(rgb.size() / 2);
        }
        EXPECT_TRUE(drawn);
    }
    kill(process, SIGTERM);
    int status = 0;
    waitpid(process, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGTERM);
    close(ends[0]);
}

// No session: pictures that differ everywhere, a viewer that never reads, and one that reads all.
TEST(SlowViewer, GetsFewerFramesAndDelaysNone)
{
    constexpr int side = 640, frames = 60;
    view::InputQueue queue;
    view::serve::Server server(at_any_port(), "noise", side, side, queue);
    const RfbViewer slow(server.port(), 4096);
    int width = 0, height = 0;
    ASSERT_TRUE(slow.log_in(server.password(), width, height));
    EXPECT_EQ(width, side);
    for (int k = 0; k < 2 * frames; ++k) ASSERT_TRUE(slow.request(false, side, side));
    VncClient quick(server.port(), server.password());
    ASSERT_TRUE(quick.connected());
    unsigned random = 1;
    for (int frame = 0; frame < frames; ++frame) {
        std::vector<uint8_t> rgb(3 * side * side);
        for (uint8_t &byte : rgb) byte = static_cast<uint8_t>((random = random * 1664525 + 1013904223) >> 24);
        const std::vector<uint8_t> shown = rgb;
        server.show(std::move(rgb));
        int waits = 0;
        while (quick.rgb() != shown && ++waits < 3000) ASSERT_TRUE(quick.listen(20));
        ASSERT_LT(waits, 3000) << "frame " << frame << " does not reach the viewer that reads";
    }
    EXPECT_EQ(server.watching(), 2);
    EXPECT_EQ(server.frames_shown(), static_cast<uint64_t>(frames));
    EXPECT_LT(server.frames_sent(0), static_cast<uint64_t>(frames) / 2);
    EXPECT_GE(server.frames_sent(1), static_cast<uint64_t>(frames));
    EXPECT_LE(server.frames_sent(1), static_cast<uint64_t>(frames) + 2);
}

TEST(Places, AreAsManyAsViewersMayConnect)
{
    view::InputQueue queue;
    view::serve::Server server(at_any_port(), "full", 64, 64, queue);
    std::vector<std::unique_ptr<RfbViewer>> viewers;
    int width = 0, height = 0;
    for (size_t k = 0; k < view::serve::most_viewers; ++k) {
        viewers.push_back(std::make_unique<RfbViewer>(server.port()));
        EXPECT_TRUE(viewers.back()->log_in(server.password(), width, height)) << k;
    }
    EXPECT_FALSE(RfbViewer(server.port()).log_in(server.password(), width, height));
    viewers.pop_back();
    bool again = false;
    for (int tries = 0; tries < 600 && !again; ++tries) {
        again = RfbViewer(server.port()).log_in(server.password(), width, height);
        if (!again) usleep(50000);
    }
    EXPECT_TRUE(again);
}

// noVNC, in a browser, talks to the port itself.
TEST(Browser, IsAnsweredAsAWebSocket)
{
    view::InputQueue queue;
    view::serve::Server server(at_any_port(), "web", 64, 64, queue);
    const RfbViewer browser(server.port());
    const std::string request =
        "GET /websockify HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
        "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n"
        "Origin: http://127.0.0.1:6080\r\n\r\n";
    ASSERT_TRUE(browser.send(Bytes(request.begin(), request.end())));
    std::string said;
    for (Bytes letter; said.find("RFB 003.008") == std::string::npos && browser.read(1, letter);)
        said += static_cast<char>(letter[0]);
    EXPECT_EQ(said.rfind("HTTP/1.1 101", 0), 0u) << said;
    EXPECT_NE(said.find("s3pPLMBiTxaQ9kYGzzhZRbK+xOo="), std::string::npos) << "RFC 6455, 1.3";
    EXPECT_NE(said.find("RFB 003.008"), std::string::npos);
}

TEST(Handshake, EndsByItselfWhereAViewerSaysNothing)
{
    view::InputQueue queue;
    view::serve::Options options = at_any_port();
    options.handshake_s = 0.3;
    view::serve::Server server(options, "patient", 64, 64, queue);
    EXPECT_TRUE(RfbViewer(server.port()).closed());
    const RfbViewer half(server.port());
    Bytes version;
    ASSERT_TRUE(half.read(12, version));
    half.send({'R', 'F', 'B'});
    EXPECT_TRUE(half.closed());
}

}  // namespace
