// Three projectors on one wall: three contexts, frusta and threads, one crowd and one update. Writes each channel's
// picture, the three side by side, and the wall as one wide picture. Prints in how many pixels the last two differ:
// with a window for each screen, and with one surface that spans all screens.
#include <cstdio>
#include <cstdlib>

#include "samples/hosts/multichannel/room.h"
#include "samples/hosts/picture_file.h"

namespace
{

using namespace multichannel;

constexpr int width = 512, height = 384;

void write(const std::string &path, const std::vector<uint8_t> &rgb, int picture_width)
{
    hosts::write_picture(path, rgb.data(), picture_width, height);
}

void say_what_differs(const char *surfaces, const Room &room)
{
    const std::vector<uint8_t> wall = room.side_by_side();
    size_t other = 0;
    for (size_t i = 0; i < wall.size(); i += 3) other += !std::equal(&wall[i], &wall[i] + 3, &room.wide()[i]);
    std::printf("%s: %zu of %zu pixels differ from the wide picture\n", surfaces, other, wall.size() / 3);
}

void run(const std::string &prefix, double time_s)
{
    Room room(width, height);
    room.show(time_s);
    const char *const names[] = {"left", "middle", "right"};
    for (int i = 0; i < Wall::columns; ++i) {
        write(prefix + names[i] + ".png", room.picture(i), width);
        std::printf("%s: %u individuals, %s\n", names[i], room.channel(i).stats().visible,
                    room.channel(i).context_name().c_str());
    }
    write(prefix + "wall.png", room.side_by_side(), Wall::columns * width);
    write(prefix + "wide.png", room.wide(), Wall::columns * width);
    say_what_differs("windows of their own", room);
    Room spanned(width, height, Surfaces::spanning);
    spanned.show(time_s);
    say_what_differs("one surface behind all three", spanned);
}

}  // namespace

int main(int count, char **arguments)
{
    if (count < 2 || count > 3) {
        std::fprintf(stderr, "usage: %s PREFIX [TIME_S]   writes PREFIXleft.png and so on\n", arguments[0]);
        return 2;
    }
    try {
        run(arguments[1], count > 2 ? std::atof(arguments[2]) : 3.0);
        return 0;
    } catch (const std::exception &failure) {
        std::fprintf(stderr, "%s\n", failure.what());
        return 1;
    }
}
