// Who gets to a served window: pages of a browser by their origin, those that know the password before those that wait,
// and passwords of eight letters that are never printed without need.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "samples/view/serve/origin.h"
#include "samples/view/serve/server.h"
#include "tests/gl/support/absent.h"
#include "tests/view/rfb_viewer.h"

namespace
{

using view_test::Bytes;
using view_test::RfbViewer;
using Clock = std::chrono::steady_clock;

view::serve::Options patient()
{
    view::serve::Options options;
    options.port = 0, options.refusal_s = 0, options.handshake_s = 120, options.typing_s = 120;
    return options;
}

std::string asking(const std::string &host, const std::string &origin)
{
    return "GET /websockify HTTP/1.1\r\nHost: " + host +
           "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
           "Sec-WebSocket-Version: 13\r\n" +
           (origin.empty() ? "" : "Origin: " + origin + "\r\n") + "\r\n";
}

TEST(Origin, IsOfTheSameHostOrOneThatIsNamed)
{
    const std::vector<std::string> named = {"https://Claque.example/"};
    const struct {
        const char *host, *origin;
        bool allowed;
    } pages[] = {
        {"127.0.0.1:5900", "http://127.0.0.1:6080", true},
        {"127.0.0.1:5900", "http://127.0.0.1", true},
        {"Cluster:5900", "https://cluster:8443", true},
        {"[::1]:5900", "http://[::1]:6080", true},
        {"127.0.0.1:5900", "", true},
        {"127.0.0.1:5900", "https://claque.example", true},
        {"127.0.0.1:5900", "http://claque.example", false},
        {"127.0.0.1:5900", "https://claque.example.org", false},
        {"127.0.0.1:5900", "http://evil.example", false},
        {"127.0.0.1:5900", "http://127.0.0.1.evil.example", false},
        {"127.0.0.1:5900", "null", false},
        {"127.0.0.1:5900", "http://", false},
        {"[::1]:5900", "http://[::2]", false},
        {"", "http://", false},
    };
    for (const auto &page : pages)
        EXPECT_EQ(view::serve::origin_is_allowed(asking(page.host, page.origin), named), page.allowed)
            << page.host << " " << page.origin;
    const std::string own = asking("127.0.0.1", "http://127.0.0.1");
    EXPECT_FALSE(view::serve::origin_is_allowed("GET / HTTP/1.1\r\nORIGIN:http://evil.example\r\n" + own, {}));
    EXPECT_FALSE(view::serve::origin_is_allowed("GET / HTTP/1.1\r\nHost: evil.example\r\n" + own, {}));
}

// What the server says to a page, to its first RFB or to its end.
std::string said_to(int port, const std::string &request)
{
    const RfbViewer browser(port);
    EXPECT_TRUE(browser.send(Bytes(request.begin(), request.end())));
    std::string said;
    for (Bytes letter; said.find("RFB 003.008") == std::string::npos && browser.read(1, letter);)
        said += static_cast<char>(letter[0]);
    return said;
}

TEST(Browser, IsRefusedWithAPageOfAnotherHost)
{
    view::InputQueue queue;
    view::serve::Options options = patient();
    options.origins = {"https://claque.example"};
    const view::serve::Server server(options, "web", 64, 64, queue);
    for (const char *origin : {"http://127.0.0.1:6080", "https://claque.example"})
        EXPECT_NE(said_to(server.port(), asking("127.0.0.1", origin)).find("RFB 003.008"), std::string::npos);
    for (const char *origin : {"http://evil.example", "null"})
        EXPECT_EQ(said_to(server.port(), asking("127.0.0.1", origin)),
                  "HTTP/1.1 403 Forbidden\r\nConnection: close\r\n\r\n");
}

// LibVNCServer takes a request for a while after it was looked for.
TEST(Browser, IsRefusedWhereItAsksLate)
{
    view::InputQueue queue;
    view::serve::Options options = patient();
    options.handshake_s = 20;
    const view::serve::Server server(options, "web", 64, 64, queue);
    for (int late_ms = 90; late_ms <= 230; late_ms += 20) {
        const RfbViewer browser(server.port());
        usleep(static_cast<useconds_t>(1000 * late_ms));
        const std::string request = asking("127.0.0.1", "http://evil.example");
        const Clock::time_point start = Clock::now();
        browser.send(Bytes(request.begin(), request.end()));
        EXPECT_TRUE(browser.closed());
        ASSERT_LT(Clock::now() - start, std::chrono::seconds(10)) << late_ms;
    }
    EXPECT_EQ(server.watching(), 0);
}

TEST(Waiting, LocksNoViewerOut)
{
    view::InputQueue queue;
    view::serve::Server server(patient(), "crowded", 64, 64, queue);
    int width = 0, height = 0;
    const RfbViewer first(server.port());
    ASSERT_TRUE(first.log_in(server.password(), width, height));
    std::vector<std::unique_ptr<RfbViewer>> idle;
    for (int k = 0; k < 60; ++k) {
        idle.push_back(std::make_unique<RfbViewer>(server.port()));
        Bytes offered;
        if (k % 2 == 0 && idle.back()->greet(offered)) idle.back()->send({2});  // up to the password
    }
    for (size_t k = 1; k < view::serve::most_viewers; ++k) {
        idle.push_back(std::make_unique<RfbViewer>(server.port()));
        EXPECT_TRUE(idle.back()->log_in(server.password(), width, height)) << k;
    }
    server.show(std::vector<uint8_t>(size_t{3} * 64 * 64, 7));
    Bytes kind;
    EXPECT_TRUE(first.request(false, width, height) && first.read(1, kind)) << "it is still there";
    // The last viewer knows that it is in before the server counts it.
    for (int k = 0; k < 1000 && server.watching() < static_cast<int>(view::serve::most_viewers); ++k) usleep(10000);
    EXPECT_EQ(server.watching(), static_cast<int>(view::serve::most_viewers));
}

TEST(Waiting, GivesAPersonTimeToTypeThePassword)
{
    view::InputQueue queue;
    view::serve::Options options = patient();
    options.handshake_s = view::serve::Options().handshake_s;
    EXPECT_EQ(options.handshake_s, 3);
    const view::serve::Server server(options, "typed", 64, 64, queue);
    const RfbViewer slow(server.port());
    Bytes offered;
    ASSERT_TRUE(slow.greet(offered));
    EXPECT_TRUE(slow.send({2}));
    usleep(4000000);
    Bytes challenge;
    EXPECT_TRUE(slow.read(16, challenge)) << "the question is there";
    const RfbViewer silent(server.port());
    EXPECT_TRUE(silent.closed());
    EXPECT_TRUE(slow.send(Bytes(16, 0)));
    Bytes result;
    EXPECT_TRUE(slow.read(4, result)) << "and is still open";
    options.typing_s = 0.4;
    const view::serve::Server hasty(options, "typed", 64, 64, queue);
    const RfbViewer late(hasty.port());
    ASSERT_TRUE(late.greet(offered) && late.send({2}) && late.read(16, challenge));
    EXPECT_TRUE(late.closed());
}

TEST(Password, HasExactlyEightLettersThatVncPasses)
{
    EXPECT_EQ(view::serve::wrong_password("tq7vm3xe"), "");
    EXPECT_EQ(view::serve::wrong_password(view::serve::make_password()), "");
    EXPECT_EQ(view::serve::wrong_password("tq7vm3x"), "has 7 letters; a password of VNC has exactly 8");
    EXPECT_EQ(view::serve::wrong_password("tq7vm3xe9"), "has 9 letters; a password of VNC has exactly 8");
    EXPECT_EQ(view::serve::wrong_password(""), "has 0 letters; a password of VNC has exactly 8");
    for (const char *odd : {"tq7vm3\xc3\xbc", "tq7 m3xe", "tq7vm3x\x1b"})
        EXPECT_NE(view::serve::wrong_password(odd).find("ASCII"), std::string::npos) << odd;
}

// What the command says with this password in a file, until it serves or ends.
std::string said_by_command(const std::string &password)
{
    const std::string file = testing::TempDir() + "claque-password-" + std::to_string(getpid());
    std::ofstream(file) << password << "\n";
    int ends[2];
    if (pipe(ends) != 0) return "";
    const pid_t process = fork();
    if (process == 0) {
        dup2(ends[1], STDOUT_FILENO), dup2(ends[1], STDERR_FILENO);
        execl(CLAQUE_COMMAND, CLAQUE_COMMAND, "view", "--serve", "127.0.0.1:0", "--scene", "parade", "--count", "1",
              "--size", "64x48", "--password-file", file.c_str(), static_cast<char *>(nullptr));
        _exit(127);
    }
    close(ends[1]);
    std::string said;
    for (char letter = 0; said.find("ctrl+C") == std::string::npos && read(ends[0], &letter, 1) == 1;) said += letter;
    kill(process, SIGTERM);
    waitpid(process, nullptr, 0);
    close(ends[0]);
    std::filesystem::remove(file);
    return said;
}

TEST(Password, OfAFileIsNeverPrinted)
{
    for (const std::string &wrong : {std::string("x"), std::string("sixteenlettershi")}) {
        const std::string said = said_by_command(wrong);
        EXPECT_NE(said.find("has " + std::to_string(wrong.size()) + " letters; a password of VNC has exactly 8"),
                  std::string::npos)
            << said;
        EXPECT_EQ(said.find(" " + wrong), std::string::npos) << said;
    }
    std::string why_not;
    if (!contexts::make_offscreen(contexts::Kind::any, 8, 8, contexts::PixelFormat::rgba8888, why_not))
        END_WITHOUT_CONTEXT(contexts::Kind::any, why_not);
    const std::string said = said_by_command("secret78");
    EXPECT_NE(said.find("its password is that of the file"), std::string::npos) << said;
    EXPECT_EQ(said.find("secret78"), std::string::npos) << said;
}

}  // namespace
