#include "samples/hosts/multichannel/channel.h"

namespace multichannel
{

using namespace scenes;

Channel::Channel(Library &library, const People &people, const Forum &forum, int width, int height)
    : people_(people), forum_(forum)
{
    std::string why_not;
    offscreen_ = contexts::make_offscreen(contexts::Kind::any, width, height, contexts::PixelFormat::rgba8888, why_not);
    if (!offscreen_) throw Failure("no OpenGL context: " + why_not);
    if (!load(gl_, offscreen_->get_proc_address(), offscreen_->user(), why_not))
        throw Failure("this OpenGL context lacks " + why_not);
    pictures_.emplace(gl_);

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
    check(clq_view_set_height(view, static_cast<float>(height)));
    offscreen_->release();
}

Channel::~Channel()
{
    offscreen_->make_current();  // textures go with what holds them, and need their context for it
}

void Channel::look(const clq_camera &camera)
{
    eye_ = eye_of(camera);
    check(clq_view_look(view_.get(), &camera));
}

const std::vector<uint8_t> &Channel::draw()
{
    if (!offscreen_->make_current()) throw Failure("the OpenGL context of a channel could not be made current");
    gl_.Viewport(0, 0, width(), height());
    gl_.DepthMask(1);
    gl_.ClearColor(0, 0, 0, 1);
    gl_.Clear(gl::color_buffer_bit | gl::depth_buffer_bit);
    forum_.draw(gl_, eye_, *pictures_, people_.places());
    check(clq_renderer_draw(renderer_.get(), view_.get(), nullptr));
    offscreen_->read_rgb(rgb_);
    offscreen_->release();
    return rgb_;
}

clq_view_stats Channel::stats() const
{
    clq_view_stats stats = {};
    check(clq_view_get_stats(view_.get(), &stats));
    return stats;
}

}  // namespace multichannel
