#include "samples/hosts/osg/application.h"

#include "samples/scenes/town/landmarks.h"

namespace osg_host
{
namespace
{

using namespace scenes;

constexpr uint64_t seed = 1;
constexpr int threads = 1;
constexpr float ghost_rgb = 0.72f;

CrowdOptions casting_of(uint32_t people)
{
    CrowdOptions crowd_options;
    crowd_options.count = people;
    crowd_options.seed = seed;
    return crowd_options;
}

}  // namespace

Application::Application(contexts::Offscreen &context, uint32_t people)
    : context_(context), library_(threads), town_(seed), passengers_(library_, casting_of(people), town_)
{
    clq_renderer_def def = clq_renderer_def_init();
    def.get_proc_address = context.get_proc_address();
    def.user = context.user();
    clq_renderer *renderer = nullptr;
    check(clq_renderer_create(library_.context(), &def, &renderer));
    renderer_.reset(renderer);
    for (clq_template *tmpl : passengers_.templates()) check(clq_renderer_prepare(renderer, tmpl));
    crowd_ = new CrowdNode(passengers_.crowd(), renderer);
    crowd_->set_height(static_cast<float>(context.height()));
    life_ = std::make_unique<StreetLife>(passengers_, *crowd_);

    TownGraph town = graph_of(town_);
    root_ = new osg::Group, scene_ = new osg::Group;
    light(*scene_);
    scene_->addChild(town.root);
    scene_->addChild(&life_->root());
    scene_->addCullCallback(narrow_);
    root_->addChild(scene_);
    for (const osg::ref_ptr<osg::Node> &piece : town.pieces) pieces_.watch(*piece);
    for (const osg::ref_ptr<osg::Node> &omnibus : life_->omnibuses()) omnibuses_.watch(*omnibus);

    viewer_.setThreadingModel(osgViewer::Viewer::SingleThreaded);
    viewer_.setUpViewerAsEmbeddedInWindow(0, 0, context.width(), context.height());
    viewer_.setLightingMode(osg::View::NO_LIGHT);
    viewer_.getCamera()->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    viewer_.getCamera()->setCullingMode(osg::CullSettings::VIEW_FRUSTUM_CULLING);
    viewer_.setSceneData(root_);
    if (!crowd_->failure().empty()) throw Failure(crowd_->failure());
}

Application::~Application()
{
    context_.make_current();
    viewer_.setSceneData(nullptr);
    life_.reset();
    crowd_ = nullptr;
}

osg::Vec3d Application::over(double u, double v, double metres) const
{
    const town::Point p = town_.plan().at(u, v);
    return {p.x, town_.height(p.x, p.z) + metres, p.z};
}

Viewpoint Application::from_the_roofs() const
{
    const town::SquarePlan square = town::square_plan(town_.plan());
    return {over(square.fountain_u - 31, square.fountain_v + 21, 6.5),
            over(square.fountain_u + 9, square.fountain_v - 2, 1.2), 46, 0.5, 5500};
}

Viewpoint Application::from_outside() const
{
    const town::SquarePlan square = town::square_plan(town_.plan());
    return {over(square.fountain_u - 28, square.fountain_v + 150, 88),
            over(square.fountain_u + 6, square.fountain_v - 8, 0), 44, 2, 5500};
}

void Application::aim(const Viewpoint &viewpoint)
{
    osg::Camera &camera = *viewer_.getCamera();
    camera.setViewMatrixAsLookAt(viewpoint.from, viewpoint.at, {0, 1, 0});
    camera.setProjectionMatrixAsPerspective(viewpoint.fov_y_deg, double(context_.width()) / context_.height(),
                                            viewpoint.near_m, viewpoint.far_m);
}

void Application::frame(double time_s)
{
    life_->move(time_s);
    pieces_.clear();
    omnibuses_.clear();
    viewer_.frame(time_s);
    if (!crowd_->failure().empty()) throw Failure(crowd_->failure());
    context_.read_rgb(rgb_);
}

const std::vector<uint8_t> &Application::picture(const Viewpoint &viewpoint, double time_s, double cull_share)
{
    osg::ref_ptr<osg::Node> margin;
    if (cull_share < 1) root_->addChild(margin = margin_lines(cull_share));
    narrow_->share = cull_share;
    crowd_->set_cull_scale(static_cast<float>(cull_share));
    aim(viewpoint);
    frame(time_s);
    if (margin) root_->removeChild(margin);
    return rgb_;
}

const std::vector<uint8_t> &Application::picture_of_culling(const Viewpoint &viewpoint, double time_s)
{
    for (const clq_actor actor : passengers_.cast().actors()) {
        if (crowd_->is_shown(actor)) continue;
        clq_actor_info info = clq_actor_info_init();
        clq_template_info tmpl = clq_template_info_init();
        check(clq_actor_get_info(passengers_.crowd(), actor, &info));
        check(clq_template_get_info(info.tmpl, &tmpl));
        const std::vector<float> grey(3 * size_t(tmpl.zone_count), ghost_rgb);
        check(clq_actor_set_colours(passengers_.crowd(), actor, grey.data(), tmpl.zone_count));
    }
    pieces_.show_culled_as_ghosts();
    omnibuses_.show_culled_as_ghosts();
    const osg::Camera &camera = *viewer_.getCamera();
    const osg::Matrixd narrow =
        camera.getProjectionMatrix() * osg::Matrixd::scale(1 / narrow_->share, 1 / narrow_->share, 1);
    const osg::ref_ptr<osg::Node> lines = frustum_lines(camera.getViewMatrix(), narrow, 120);
    root_->addChild(lines);
    narrow_->share = 1;
    crowd_->set_cull_scale(1);
    aim(viewpoint);
    frame(time_s);
    root_->removeChild(lines);
    pieces_.show_as_they_are();
    omnibuses_.show_as_they_are();
    return rgb_;
}

}  // namespace osg_host
