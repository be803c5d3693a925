#include "samples/hosts/multichannel/room.h"

#include <exception>
#include <thread>

namespace multichannel
{
namespace
{

constexpr double tan_half_width = 4.0 / 3.0;  // 106 degrees in all
constexpr double eye[3] = {0, 2.3, 0}, target[3] = {0, 2.3, -1};

}  // namespace

Room::Room(int channel_width, int channel_height, Surfaces surfaces)
    : library_(1),
      people_(library_),
      wall_(tan_half_width, tan_half_width * channel_height / (Wall::columns * channel_width), 0.25, 400),
      surfaces_(surfaces)
{
    const int wide = Wall::columns * channel_width;
    for (int i = 0; i < Wall::columns; ++i) {
        const Pane pane = surfaces == Surfaces::apart ? Pane{channel_width, 0, channel_width, channel_height}
                                                      : Pane{wide, i * channel_width, channel_width, channel_height};
        channels_[static_cast<size_t>(i)] = std::make_unique<Channel>(library_, people_, forum_, pane);
    }
    channels_.back() = std::make_unique<Channel>(library_, people_, forum_, Pane{wide, 0, wide, channel_height});
}

void Room::show(double time_s)
{
    people_.place(time_s);
    clq_view *views[view_count];
    for (size_t i = 0; i < view_count; ++i) {
        const bool all = i == Wall::columns || surfaces_ == Surfaces::spanning;
        channels_[i]->set_camera(wall_.camera(eye, target, all ? 0 : static_cast<int>(i), all ? Wall::columns : 1));
        views[i] = channels_[i]->view();
    }
    scenes::check(clq_crowd_update(people_.crowd(), time_s, views, static_cast<uint32_t>(view_count)));

    std::array<std::exception_ptr, view_count> failures;
    std::vector<std::thread> threads;
    for (size_t i = 0; i < view_count; ++i)
        threads.emplace_back([this, i, &failures] {
            try {
                pictures_[i] = &channels_[i]->draw();
            } catch (...) {
                failures[i] = std::current_exception();
            }
        });
    for (std::thread &thread : threads) thread.join();
    for (const std::exception_ptr &failure : failures)
        if (failure) std::rethrow_exception(failure);
}

std::vector<uint8_t> Room::side_by_side() const
{
    const size_t row = 3 * static_cast<size_t>(channel(0).width()), rows = static_cast<size_t>(channel(0).height());
    std::vector<uint8_t> out;
    for (size_t y = 0; y < rows; ++y)
        for (int column = 0; column < Wall::columns; ++column) {
            const uint8_t *from = picture(column).data() + y * row;
            out.insert(out.end(), from, from + row);
        }
    return out;
}

}  // namespace multichannel
