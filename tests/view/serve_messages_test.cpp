// Viewers that say what no viewer says: the window goes on, and one that behaves sees it to the end.
#include <atomic>
#include <cstdlib>
#include <fstream>
#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "samples/view/serve/server.h"
#include "tests/view/rfb_viewer.h"
#include "tests/view/vnc_client.h"

namespace
{

using view_test::Bytes;
using view_test::put16;
using view_test::put32;
using view_test::RfbViewer;

// CLAQUE_VIEW_MESSAGES: how many, in place of a number that takes seconds.
int message_count()
{
    const char *text = std::getenv("CLAQUE_VIEW_MESSAGES");
    return text ? std::atoi(text) : 10000;
}

class Malformed
{
public:
    explicit Malformed(unsigned seed) : random_(seed) {}

    uint32_t below(uint32_t limit) { return static_cast<uint32_t>(random_()) % limit; }
    Bytes noise(size_t size)
    {
        Bytes bytes(size);
        for (uint8_t &byte : bytes) byte = static_cast<uint8_t>(random_());
        return bytes;
    }
    // Mostly of a known kind and length, so that the server reads on after it.
    Bytes message();

private:
    Bytes pixel_format();
    Bytes encodings();
    Bytes clipboard();

    std::mt19937 random_;
};

Bytes Malformed::pixel_format()
{
    Bytes bytes = {0, 0, 0, 0};
    const uint8_t bits[] = {8, 16, 32, 24};
    bytes.push_back(below(8) == 0 ? static_cast<uint8_t>(below(256)) : bits[below(4)]);
    const Bytes rest = noise(15);
    bytes.insert(bytes.end(), rest.begin(), rest.end());
    return bytes;
}

Bytes Malformed::encodings()
{
    const uint32_t said = below(40), sent = below(20) == 0 ? below(40) : said;
    Bytes bytes = {2, 0};
    put16(bytes, said);
    for (uint32_t k = 0; k < sent; ++k)
        put32(bytes, below(3) == 0 ? static_cast<uint32_t>(random_()) : below(2) == 0 ? below(32) : 0u - below(400));
    return bytes;
}

Bytes Malformed::clipboard()
{
    const uint32_t size = below(300);
    Bytes bytes = {6, 0, 0, 0};
    // A negative length is that of the extended clipboard.
    put32(bytes, below(4) == 0 ? static_cast<uint32_t>(random_()) : below(2) == 0 ? 0u - size : size);
    const Bytes rest = noise(size);
    bytes.insert(bytes.end(), rest.begin(), rest.end());
    return bytes;
}

Bytes Malformed::message()
{
    switch (below(12)) {
        case 0:
            return pixel_format();
        case 1:
            return encodings();
        case 2: {
            Bytes bytes = noise(10);
            bytes[0] = 3;
            return bytes;
        }
        case 3: {
            Bytes bytes = noise(8);
            bytes[0] = 4;
            return bytes;
        }
        case 4: {
            Bytes bytes = noise(6);
            bytes[0] = 5;
            return bytes;
        }
        case 5:
            return clipboard();
        case 6:  // a scale of UltraVNC's, and of PalmVNC's
            return {static_cast<uint8_t>(below(2) == 0 ? 8 : 15), static_cast<uint8_t>(below(256)), 0, 0};
        case 7: {
            Bytes bytes = noise(4 + below(24));
            bytes[0] = static_cast<uint8_t>(7 + below(8));  // files, chat, windows
            return bytes;
        }
        case 8: {
            Bytes bytes = noise(4 + below(24));
            bytes[0] = static_cast<uint8_t>(248 + below(8));
            return bytes;
        }
        case 9: {
            Bytes bytes = {251, 0};  // another size of the desktop
            put16(bytes, below(65536)), put16(bytes, below(65536));
            bytes.push_back(static_cast<uint8_t>(below(8))), bytes.push_back(0);
            const Bytes rest = noise(16 * bytes[6]);
            bytes.insert(bytes.end(), rest.begin(), rest.end());
            return bytes;
        }
        case 10:
            return below(4) == 0 ? noise(1 + below(200)) : encodings();
        default: {
            Bytes bytes = noise(10);
            bytes[0] = 3, bytes[1] = 0;
            for (size_t k = 2; k < 10; k += 2) bytes[k] = 0;  // within the window, so that it is answered
            return bytes;
        }
    }
}

// Says malformed things, before or after the password, until the server has enough.
void connect_and_say(Malformed &malformed, int port, const std::string &password, std::atomic<int> &left)
{
    const RfbViewer viewer(port, 1 << 16);
    int width = 0, height = 0;
    if (malformed.below(8) == 0) {
        Bytes version;
        if (malformed.below(2) == 0) viewer.read(12, version);
        if (malformed.below(2) == 0) {
            static const char ours[] = "RFB 003.";
            viewer.send(Bytes(ours, ours + 8));
        }
        for (int k = 0; k < 4 && --left > 0; ++k)
            if (!viewer.send(malformed.noise(1 + malformed.below(64)))) return;
        return;
    }
    if (!viewer.log_in(password, width, height)) return;
    for (int k = 0; k < 20 && --left > 0; ++k)
        if (!viewer.send(malformed.message())) return;
}

// AddressSanitizer keeps freed memory for a while.
#ifdef __SANITIZE_ADDRESS__
constexpr uint64_t most_bytes = 1u << 30;
#else
constexpr uint64_t most_bytes = 200u << 20;
#endif

uint64_t resident_pages()
{
    std::ifstream file("/proc/self/statm");
    uint64_t all = 0, resident = 0;
    file >> all >> resident;
    return resident;
}

TEST(MalformedMessages, HarmNeitherTheWindowNorAViewerThatBehaves)
{
    constexpr int side = 128;
    view::InputQueue queue;
    view::serve::Options options;
    options.port = 0, options.refusal_s = 0, options.handshake_s = 1;
    view::serve::Server server(options, "rough", side, side, queue);
    view_test::VncClient good(server.port(), server.password());
    ASSERT_TRUE(good.connected());
    const uint64_t pages = resident_pages();
    std::atomic<int> left{message_count()};
    std::vector<std::thread> rough;
    for (unsigned seed = 1; seed <= 6; ++seed)
        rough.emplace_back([&, seed] {
            Malformed malformed(seed);
            while (left > 0) connect_and_say(malformed, server.port(), server.password(), left);
        });
    view::Input input;
    int frames = 0;
    while (left > 0 || frames == 0) {
        const std::vector<uint8_t> rgb(3 * side * side, static_cast<uint8_t>(++frames));
        server.show(rgb);
        queue.next(input);
        int waits = 0;
        while (good.rgb() != rgb && ++waits < 3000) ASSERT_TRUE(good.listen(20)) << "after " << frames << " frames";
        ASSERT_LT(waits, 3000) << "frame " << frames;
    }
    for (std::thread &one : rough) one.join();
    EXPECT_LT(resident_pages(), pages + most_bytes / 4096) << "memory for viewers that are gone";
    RecordProperty("frames", frames);
}

}  // namespace
