// What a picture draws first: whatever hides most of the rest.
#include "samples/scenes/scene_renderer.h"
#include "tests/gl/support/absent.h"

namespace scenes
{
namespace
{

using Part = SceneRenderer::Part;
using Order = std::array<Part, 3>;

Order order_of(const char *scene, ShadowChoice::Form shadows = ShadowChoice::Form::painted)
{
    Library library(1);
    SceneOptions options;
    options.scene = scene;
    options.crowd_options.count = 20;
    options.width = 64, options.height = 48;
    options.shadows.form = shadows;
    return SceneRenderer(library, options).order();
}

TEST(DrawOrder, BeginsWithPeopleUnlessTheSceneHidesThemOrTheyCastShadows)
{
    const std::string absent = gltest::absent_gl(contexts::Kind::any);
    if (!absent.empty()) GTEST_SKIP() << absent;
    const Order people_first = {Part::crowd, Part::environment, Part::shadows};
    const Order people_last = {Part::environment, Part::shadows, Part::crowd};
    EXPECT_EQ(order_of("plaza"), people_first);
    EXPECT_EQ(order_of("town_sky"), people_last);
    EXPECT_EQ(order_of("plaza", ShadowChoice::Form::blob), people_last);
}

}  // namespace
}  // namespace scenes
