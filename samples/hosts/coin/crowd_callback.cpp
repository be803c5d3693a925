#include "samples/hosts/coin/crowd_callback.h"

#include <Inventor/C/glue/gl.h>
#include <Inventor/SbRotation.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/bundles/SoMaterialBundle.h>
#include <Inventor/elements/SoCacheElement.h>
#include <Inventor/elements/SoModelMatrixElement.h>
#include <Inventor/elements/SoProjectionMatrixElement.h>
#include <Inventor/elements/SoViewingMatrixElement.h>
#include <Inventor/elements/SoViewportRegionElement.h>

#include "samples/scenes/check.h"

namespace coin_host
{
namespace
{

using scenes::check;

clq_gl_function get_gl_function(void *glue, const char *name)
{
    return reinterpret_cast<clq_gl_function>(cc_glglue_getprocaddress(static_cast<const cc_glglue *>(glue), name));
}

clq_camera camera_of(SoState *state)
{
    SbMatrix to_eye = SoModelMatrixElement::get(state);
    to_eye.multRight(SoViewingMatrixElement::get(state));
    clq_camera camera = {};
    for (int k = 0; k < 3; ++k) camera.eye[k] = static_cast<double>(to_eye.inverse()[3][k]);
    SbRotation(to_eye).getValue(camera.rotation_xyzw[0], camera.rotation_xyzw[1], camera.rotation_xyzw[2],
                                camera.rotation_xyzw[3]);
    const SbMatrix &projection = SoProjectionMatrixElement::get(state);
    for (int k = 0; k < 16; ++k) camera.projection[k] = projection[k / 4][k % 4];
    return camera;
}

}  // namespace

CrowdCallback::CrowdCallback(clq_context *context, clq_crowd *crowd, std::vector<clq_template *> templates,
                             const SbBox3f &bounds)
    : context_(context), crowd_(crowd), templates_(std::move(templates)), bounds_(bounds)
{
    node_->ref();
    node_->setCallback(called, this);
    check(clq_view_create(crowd, &view_));
}

CrowdCallback::~CrowdCallback()
{
    node_->setCallback(nullptr);  // a scenegraph may keep the node
    node_->unref();
    for (const auto &[number, renderer] : renderers_) clq_renderer_abandon(renderer);  // no context is current here
    clq_view_destroy(view_);
}

void CrowdCallback::called(void *user, SoAction *action)
{
    CrowdCallback &self = *static_cast<CrowdCallback *>(user);
    if (action->isOfType(SoGetBoundingBoxAction::getClassTypeId()))
        static_cast<SoGetBoundingBoxAction *>(action)->extendBy(self.bounds_);
    if (!action->isOfType(SoGLRenderAction::getClassTypeId())) return;
    try {
        self.failure_.clear();
        self.draw(*static_cast<SoGLRenderAction *>(action));
    } catch (const scenes::Failure &failure) {
        self.failure_ = failure.what();
    }
}

clq_renderer *CrowdCallback::renderer_of(uint32_t context_id)
{
    clq_renderer *&renderer = renderers_[context_id];
    if (!renderer) {
        clq_renderer_def def = clq_renderer_def_init();
        def.get_proc_address = get_gl_function;
        def.user = const_cast<cc_glglue *>(cc_glglue_instance(static_cast<int>(context_id)));
        check(clq_renderer_create(context_, &def, &renderer));
    }
    // Each time: what was refused in the first frame is tried again.
    for (clq_template *tmpl : templates_) check(clq_renderer_prepare(renderer, tmpl));
    return renderer;
}

void CrowdCallback::draw(SoGLRenderAction &action)
{
    SoState *state = action.getState();
    // No display list of a separator above keeps one picture of the crowd.
    SoCacheElement::invalidate(state);
    // Coin sends light model and material when it needs them. After this GL has them; claque leaves all as it was.
    SoMaterialBundle(&action).sendFirst();
    const clq_camera camera = camera_of(state);
    check(clq_view_set_camera(view_, &camera));
    check(clq_view_set_height(view_, SoViewportRegionElement::get(state).getViewportSizePixels()[1]));
    check(clq_crowd_update(crowd_, time_s_, &view_, 1));
    check(clq_renderer_draw(renderer_of(action.getCacheContext()), view_, &drawn_));
}

}  // namespace coin_host
