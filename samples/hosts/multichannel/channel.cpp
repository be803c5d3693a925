#include "samples/hosts/multichannel/channel.h"

namespace multichannel
{

using namespace scenes;

Channel::Channel(Library &library, const People &people, const Forum &forum, const Pane &pane)
    : people_(people), forum_(forum), pane_(pane)
{
    std::string why_not;
    offscreen_ = contexts::make_offscreen(contexts::Kind::any, pane.surface_width, pane.height,
                                          contexts::PixelFormat::rgba8888, why_not);
    if (!offscreen_) throw Failure("no OpenGL context: " + why_not);
    if (!load(gl_, offscreen_->get_proc_address(), offscreen_->user(), why_not))
        throw Failure("this OpenGL context lacks " + why_not);
    pictures_.emplace(gl_);
    keep_to_pane();

    clq_renderer_def def = clq_renderer_def_init();
    def.get_proc_address = offscreen_->get_proc_address();
    def.user = offscreen_->user();
    clq_renderer *renderer = nullptr;
    check(clq_renderer_create(library.context(), &def, &renderer));
    renderer_.reset(renderer);
    for (clq_template *tmpl : people.templates()) check(clq_renderer_prepare(renderer, tmpl));

    clq_view *view = nullptr;
    check(clq_view_create(people.crowd(), &view));
    view_.reset(view);
    check(clq_view_set_height(view, static_cast<float>(pane.height)));
    cull_by_pane();
    offscreen_->release();
}

// GL gets only the actors of these columns, chosen as for the whole surface.
void Channel::cull_by_pane()
{
    const float whole = static_cast<float>(pane_.surface_width);
    const float tile[4] = {static_cast<float>(pane_.left) / whole, 0,
                           static_cast<float>(pane_.left + pane_.width) / whole, 1};
    if (pane_.left + pane_.width <= pane_.surface_width) check(clq_view_set_tile(view_.get(), tile));
}

void Channel::show_columns(int left, int width)
{
    if (!offscreen_->make_current()) throw Failure("the OpenGL context of a channel could not be made current");
    pane_.left = left, pane_.width = width;
    keep_to_pane();
    cull_by_pane();
    offscreen_->release();
}

// Later draws inherit the viewport and the scissor box.
void Channel::keep_to_pane()
{
    gl_.Viewport(0, 0, pane_.surface_width, pane_.height);
    gl_.Disable(gl::scissor_test);
    if (pane_.width == pane_.surface_width) return;
    gl_.Scissor(pane_.left, 0, pane_.width, pane_.height);
    gl_.Enable(gl::scissor_test);
}

Channel::~Channel()
{
    offscreen_->make_current();  // textures are freed with their owner, which needs their context current
}

void Channel::set_camera(const clq_camera &camera)
{
    eye_ = eye_of(camera);
    check(clq_view_set_camera(view_.get(), &camera));
}

const std::vector<uint8_t> &Channel::draw()
{
    if (!offscreen_->make_current()) throw Failure("the OpenGL context of a channel could not be made current");
    gl_.DepthMask(1);
    gl_.ClearColor(0, 0, 0, 1);
    gl_.Clear(gl::color_buffer_bit | gl::depth_buffer_bit);
    forum_.draw(gl_, eye_, *pictures_, people_.places());
    check(clq_renderer_draw(renderer_.get(), view_.get(), nullptr));
    offscreen_->read_rgb(surface_);
    offscreen_->release();
    const auto bytes = [](int pixels) { return 3 * static_cast<std::ptrdiff_t>(pixels); };
    rgb_.clear();
    for (int y = 0; y < pane_.height; ++y) {
        const auto from = surface_.begin() + bytes(y * pane_.surface_width + pane_.left);
        rgb_.insert(rgb_.end(), from, from + bytes(pane_.width));
    }
    return rgb_;
}

clq_view_stats Channel::stats() const
{
    clq_view_stats stats = clq_view_stats_init();
    check(clq_view_get_stats(view_.get(), &stats));
    return stats;
}

}  // namespace multichannel
