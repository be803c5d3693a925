#include "tests/view/staged.h"

#include "samples/view/designer/line_up.h"

namespace view_test
{

std::function<std::unique_ptr<scenes::Scene>(scenes::Library &, const scenes::CrowdOptions &)> line_up_of(
    const std::vector<std::string> &names)
{
    return [names](scenes::Library &library, const scenes::CrowdOptions &crowd_options) {
        std::vector<scenes::Character> characters;
        for (const std::string &name : names)
            characters.push_back(view::builtin_person(library, name, crowd_options.lod));
        return view::make_line_up(library, crowd_options, characters);
    };
}

void Staged::SetUp()
{
    std::string why_not;
    if (!contexts::make_offscreen(contexts::Kind::any, 8, 8, contexts::PixelFormat::rgba8888, why_not))
        GTEST_SKIP() << why_not;
}

view::Session &Staged::open(const Stage &stage)
{
    session_.reset();
    surface_.reset();
    stage_ = stage;
    surface_ = view::make_offscreen_surface(contexts::Kind::any, stage.width, stage.height);
    session_.emplace(
        *surface_,
        [stage](scenes::Library &library) {
            view::Opened opened;
            opened.options.scene = stage.scene;
            opened.options.crowd_options.count = stage.count;
            if (!stage.line_up.empty()) opened.options.make = line_up_of(stage.line_up);
            opened.asset_of = [](scenes::Library &of, const std::string &name) {
                clq_asset *made = nullptr;
                scenes::check(clq_asset_builtin(of.context(), name.c_str(), &made));
                return scenes::Own<clq_asset>(made);
            };
            if (!stage.character.empty()) opened.options.character.tmpl = library.builtin(stage.character);
            return opened;
        },
        view::Switches(), stage.scale, nullptr);
    return *session_;
}

void Staged::play(const std::vector<std::string> &steps)
{
    view::Script script;
    std::string toml = "steps = [";
    for (const std::string &step : steps) toml += "'" + step + "', ";
    view::Player player(view::read_script(toml + "]", "test"), stage_.width, stage_.height);
    view::Input input;
    while (player.next(input, session_->ui(), session_->world())) {
        session_->frame(input);
        seen();
    }
}

std::vector<uint8_t> Staged::window()
{
    std::vector<uint8_t> rgb;
    surface_->read(0, stage_.width, stage_.height, rgb);
    return rgb;
}

std::vector<uint8_t> Staged::picture()
{
    const int width = session_->world().width(), height = session_->world().height();
    std::vector<uint8_t> rgb;
    surface_->read(stage_.height - height, width, height, rgb);
    return rgb;
}

}  // namespace view_test
