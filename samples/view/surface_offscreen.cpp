#include <cstring>

#include "samples/scenes/check.h"
#include "samples/view/surface.h"

namespace view
{
namespace
{

class OffscreenSurface final : public Surface
{
public:
    OffscreenSurface(contexts::Kind kind, int width, int height) : kind_(kind), width_(width), height_(height)
    {
        renew();
    }

    GetProcAddress get_proc_address() const override { return offscreen_->get_proc_address(); }
    void *user() const override { return offscreen_->user(); }
    const std::string &name() const override { return offscreen_->name(); }
    bool flushes_cheaply() const override { return offscreen_->flushes_cheaply(); }
    void read(int below, int width, int height, std::vector<uint8_t> &out) override
    {
        if (width == offscreen_->width() && height == offscreen_->height()) return offscreen_->read_rgb(out);
        offscreen_->read_rgb(whole_);
        const size_t row = 3 * static_cast<size_t>(width), whole_row = 3 * static_cast<size_t>(offscreen_->width());
        out.resize(row * static_cast<size_t>(height));
        const int above = offscreen_->height() - height - below;
        for (int y = 0; y < height; ++y)
            std::memcpy(out.data() + row * static_cast<size_t>(y),
                        whole_.data() + whole_row * static_cast<size_t>(above + y), row);
    }

    void renew() override
    {
        offscreen_.reset();
        std::string why_not;
        offscreen_ = contexts::make_offscreen(kind_, width_, height_, contexts::PixelFormat::rgba8888, why_not);
        if (!offscreen_) throw scenes::Failure("no OpenGL context: " + why_not);
    }

private:
    contexts::Kind kind_;
    int width_, height_;
    std::unique_ptr<contexts::Offscreen> offscreen_;
    std::vector<uint8_t> whole_;
};

}  // namespace

std::unique_ptr<Surface> make_offscreen_surface(contexts::Kind kind, int width, int height)
{
    return std::make_unique<OffscreenSurface>(kind, width, height);
}

}  // namespace view
