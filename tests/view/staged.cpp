#include "tests/view/staged.h"

#include "samples/view/designer/line_up.h"
#include "tests/gl/support/absent.h"

namespace view_test
{
namespace
{

bool meet(const view::Box &a, const view::Box &b)
{
    constexpr float touch = 0.5f;
    return a.x0 < b.x1 - touch && b.x0 < a.x1 - touch && a.y0 < b.y1 - touch && b.y0 < a.y1 - touch;
}

}  // namespace

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
        END_WITHOUT_CONTEXT(contexts::Kind::any, why_not);
}

view::Session &Staged::open(const Stage &stage)
{
    const auto of_stage = [stage](scenes::Library &library) {
        view::Opened opened;
        opened.options.scene = stage.scene;
        opened.options.crowd_options.count = stage.count;
        if (!stage.line_up.empty()) opened.options.make = line_up_of(stage.line_up);
        opened.asset_of = [](scenes::Library &of, const std::string &name) {
            clq_asset *made = nullptr;
            scenes::check(clq_asset_builtin(of.context(), name.c_str(), &made));
            return scenes::Own<clq_asset>(made);
        };
        if (!stage.file.empty()) {
            clq_asset *asset = nullptr;
            scenes::check(clq_asset_load_file(library.context(), stage.file.c_str(), nullptr, &asset));
            const scenes::Own<clq_asset> held(asset);
            clq_template *made = nullptr;
            scenes::check(clq_asset_build(library.context(), asset, 0, &made));
            opened.keeps = std::shared_ptr<clq_template>(made, clq_template_destroy);
            opened.options.character.tmpl = made;
            opened.character_file = stage.file;
            opened.asset_of = [](scenes::Library &of, const std::string &path) {
                clq_asset *again = nullptr;
                scenes::check(clq_asset_load_file(of.context(), path.c_str(), nullptr, &again));
                return scenes::Own<clq_asset>(again);
            };
        }
        if (!stage.character.empty()) opened.options.character.tmpl = library.builtin(stage.character);
        return opened;
    };
    return open_with(of_stage, stage);
}

view::Session &Staged::open_with(const view::Open &open, const Stage &stage)
{
    session_.reset();
    surface_.reset();
    stage_ = stage;
    surface_ = view::make_offscreen_surface(contexts::Kind::any, stage.width, stage.height);
    session_.emplace(*surface_, open, view::Switches(), stage.scale, nullptr);
    return *session_;
}

void Staged::play(const std::vector<std::string> &steps)
{
    std::string toml = "steps = [";
    for (const std::string &step : steps) toml += "'" + step + "', ";
    play(view::read_script(toml + "]", "test"), [](const view::Input &) {});
}

void Staged::play(view::Script script, const std::function<void(const view::Input &)> &each)
{
    view::Player player(std::move(script), stage_.width, stage_.height);
    view::Input input;
    while (player.next(input, session_->ui(), session_->world())) {
        session_->frame(input);
        each(input);
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

void expect_in_order(const view::Ui &ui, const std::string &at)
{
    std::vector<view::Widget> all = ui.widgets();
    all.insert(all.end(), ui.texts().begin(), ui.texts().end());
    for (size_t i = 0; i < all.size(); ++i) {
        EXPECT_GE(all[i].box.x0, all[i].clip.x0) << at << all[i].name;
        EXPECT_LE(all[i].box.x1, all[i].clip.x1) << at << all[i].name;
        for (size_t k = 0; k < i; ++k) {
            if (all[i].clip.y0 != all[k].clip.y0) continue;  // of another panel
            EXPECT_FALSE(meet(all[i].box, all[k].box)) << at << all[i].name << " and " << all[k].name;
        }
    }
    // Nothing of the lower bar needs scrolling.
    for (const view::Widget &one : all) {
        if (one.clip.y0 > 0) {
            EXPECT_LE(one.box.y1, one.clip.y1) << at << one.name;
        }
    }
}

}  // namespace view_test
