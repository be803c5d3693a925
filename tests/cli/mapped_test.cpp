// A file that becomes shorter while it is mapped: the command says so and ends, whichever thread reads it.
#include "samples/io/mapped.h"

#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <poll.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "samples/io/unfinished.h"
#include "tests/cli/run.h"
#include "tests/cli/running.h"

namespace cli_test
{
namespace
{

namespace fs = std::filesystem;

class MappedFile : public Command
{
protected:
    void SetUp() override { std::ofstream(path("data")) << std::string(100000, 'x'); }

    // The file loses all but its first page; then a thread reads behind that.
    void lose(bool in_another_thread) const
    {
        const io::Unfinished draft(path("draft")), folder(path("folder"));
        std::ofstream(path("draft")) << "part";
        fs::create_directory(path("folder"));
        io::Mapped file;
        if (!file.open(path("data")).empty()) return;
        fs::resize_file(path("data"), 4096);
        const auto read = [&] { return static_cast<const volatile char *>(file.data())[50000]; };
        if (in_another_thread) std::thread(read).join();
        else read();
    }
    std::string says() const { return "claque: " + path("data") + " could not be read further: it became shorter"; }
};

class MappedRecord : public Drawing
{
protected:
    // One minute of 100 walkers.
    void write_record() const
    {
        std::ofstream table(path("many.csv"));
        table << "id,frame,x,y\n";
        for (int frame = 0; frame <= 60; ++frame)
            for (int person = 0; person < 100; ++person)
                table << person << ',' << frame << ',' << 0.1 * frame + person % 20 << ',' << person / 20 << '\n';
        table.close();
        const Outcome done = claque({"play", path("many.csv"), "--columns", "id,frame,x,y", "--rate", "1", "--unit",
                                     "m", "--size", "32x24", "--frames", "0:60", "--fps", "1", "--record",
                                     path("run.clt"), "--out", path("f-%03d.png")});
        ASSERT_EQ(done.code, 0) << done.err;
    }
};

}  // namespace

TEST_F(MappedFile, ThatBecomesShorterEndsTheProcessWithASentence)
{
    for (const bool in_another_thread : {false, true}) {
        SCOPED_TRACE(in_another_thread);
        SetUp();
        EXPECT_EXIT(lose(in_another_thread), testing::ExitedWithCode(1), says());
        EXPECT_EQ(left(), std::vector<std::string>{"data"}) << "what is unfinished is removed";
    }
}

TEST_F(MappedFile, LeavesOtherBusErrorsToTheSystem)
{
    const auto fail = [&](bool is_sent) {
        io::Mapped file;
        if (!file.open(path("data")).empty()) return;
        if (is_sent) raise(SIGBUS);
        const int other = open(path("data").c_str(), O_RDWR | O_CLOEXEC);
        void *page = mmap(nullptr, 4096, PROT_READ, MAP_PRIVATE, other, 0);
        if (page == MAP_FAILED || ftruncate(other, 0) != 0) return;
        static_cast<void>(*static_cast<const volatile char *>(page));
    };
    for (const bool is_sent : {true, false}) EXPECT_EXIT(fail(is_sent), testing::KilledBySignal(SIGBUS), "^$");
}

// The pipe is full after the first pictures, so the command waits until the record has become shorter.
TEST_F(MappedRecord, ThatBecomesShorterWhileItIsPlayedIsNamed)
{
    write_record();
    int ends[2];
    ASSERT_EQ(pipe2(ends, O_CLOEXEC), 0);
    fcntl(ends[0], F_SETPIPE_SZ, 4096);
    const int err = open(path("err").c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    Running running({"play", path("run.clt"), "--size", "160x120", "--fps", "1", "--out", "-"}, ends[1], err);
    close(ends[1]), close(err);
    pollfd first = {ends[0], POLLIN, 0};
    ASSERT_EQ(poll(&first, 1, 60000), 1);
    fs::resize_file(path("run.clt"), 4096);
    char bytes[4096];
    while (read(ends[0], bytes, sizeof bytes) > 0) continue;
    close(ends[0]);
    const int state = running.wait_for_end();
    EXPECT_TRUE(WIFEXITED(state) && WEXITSTATUS(state) == 1) << state;
    const std::string said = file_text(path("err"));
    EXPECT_EQ(said.find("claque: " + path("run.clt") + " could not be read further: it became shorter"), 0u) << said;
}

}  // namespace cli_test
