// The crowd that a view shows, its surroundings and its renderer, in a context that is there already. It is drawn as
// any host draws claque.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <memory>

#include "samples/processes/tile_borders.h"
#include "samples/scenes/placement.h"
#include "samples/scenes/scene_renderer.h"
#include "samples/view/designer/dresser.h"
#include "samples/view/ground/findings.h"
#include "samples/view/ground/level_row.h"
#include "samples/view/ground/workbench.h"
#include "samples/view/model.h"
#include "samples/view/surface.h"
#include "samples/view/ui.h"

namespace view
{

// What a view shows. `keeps` lives as long as the scene that the options make.
struct Opened {
    scenes::SceneOptions options;
    std::shared_ptr<void> keeps;
    double first_s = 0, last_s = 60;
    bool begins_on_path = true;  // where there is a path; else with the overview
    std::function<void(scenes::Library &, const scenes::Scene &)> dress;  // the people, before they are shown
    // The character of a template of this name, whose textures can then be painted; empty: none can.
    std::function<scenes::Own<clq_asset>(scenes::Library &, const std::string &tmpl)> asset_of = {};
    std::string character_file;  // of options.character; empty: it is built in
    scenes::Placement placement = {};
};
using Open = std::function<Opened(scenes::Library &)>;

// What a dropped file changes: the scene, or the colours of its people.
struct Dropped {
    Open open;            // empty: the scene stays
    std::string colours;  // a colour map; empty: none
};
// Throws scenes::Failure, which the person reads.
using Drop = std::function<Dropped(const std::string &path)>;

using Now = double (*)();  // seconds; null: costs are not measured

// Templates with painted zones, which take the places of those that a scene would take. Those that no library owns are
// kept here.
struct Painted {
    std::vector<scenes::Own<clq_template>> kept;
    std::string failure;  // why a map could not be given; "": all are
};
Painted paint_templates(scenes::Library &library, Opened &opened, scenes::Lod lod, const std::vector<SharedMap> &maps);

// A scene that needs no GL yet, so that another thread than that of the window can make it.
struct Loaded {
    std::unique_ptr<scenes::Library> library;
    Opened opened;
    Painted painted;
    std::unique_ptr<scenes::Scene> scene;
};
// `people`: their number; 0: the scene's own. `maps`: painted zones. Throws scenes::Failure.
Loaded load(const Open &open, const Switches &switches, uint32_t people = 0, const std::vector<SharedMap> &maps = {});

class World
{
public:
    // `loaded`: by `open`, with the same switches. Throws scenes::Failure.
    World(Surface &surface, Open open, Loaded loaded, const Switches &switches, Now now);
    ~World();
    World(const World &) = delete;
    World &operator=(const World &) = delete;

    // Shows something else from now on. Throws scenes::Failure; what was shown is then there again.
    void open(const Open &open);
    // The surface's context is lost: shows the same in another. Throws scenes::Failure.
    void renew();
    // Whether GL said so in the last frame.
    bool context_lost() const { return context_lost_; }
    // Does what the model wishes, then updates.
    // The picture is the lower left corner of the surface but for `below` lines under it.
    void update(Model &model, int width, int height, int below);
    // Draws everything but the interface.
    void draw(Model &model);
    // Or shows it as others drew it: rows of `row_px` pixels of three bytes, the lowest first.
    void put(const uint8_t *rgb, int row_px);

    // From the next update on, draw() draws these columns alone. What is picked and counted is that of the whole
    // picture.
    void show_columns(const processes::Tile &columns) { columns_ = columns; }

    void finish() const { gl_.Finish(); }  // waits for GL

    clq_crowd *crowd() const { return scene_->crowd(); }
    clq_context *context() const { return library_->context(); }
    const clq_view *view() const { return view_.get(); }
    const clq_camera &camera() const { return camera_; }
    bool can_paint() const { return static_cast<bool>(opened_.asset_of); }
    const clq_template *character() const { return opened_.options.character.tmpl; }
    const std::string &character_file() const { return opened_.character_file; }
    const scenes::Placement &placement() const { return opened_.placement; }
    bool has_path() const { return path_.has_value(); }
    bool begins_on_path() const { return path_ && opened_.begins_on_path; }
    double shown_s() const { return time_s_; }  // the time of the last frame
    double first_s() const { return opened_.first_s; }
    double last_s() const { return opened_.last_s; }
    const std::vector<clq_template *> &templates() const { return templates_; }
    std::vector<std::string> warnings() const { return library_->warnings(); }
    // What `examine` found of a character; null: not examined yet.
    const Findings *findings(const clq_template *tmpl) const;
    // The levels of the picked individual beside it; null: they are not shown.
    const LevelRow *level_row() const { return level_row_.get(); }
    const Workbench &workbench() const { return *workbench_; }

    std::vector<clq_actor> everyone() const;
    // Whether an individual is there; all about it.
    bool find(clq_actor actor, clq_actor_info &out) const;
    // The ray of a point of the picture of the last frame.
    Picked pick(float x, float y) const;
    // The colours of an individual in the picture, by zone; empty if it is not there.
    std::vector<uint8_t> colours(clq_actor actor) const;
    int width() const { return width_; }
    int height() const { return height_; }
    // Its vertices on the last picture, in pixels from the upper left corner; false: it is not in it.
    bool outline(clq_actor actor, Box &out) const;
    // The sphere of its body there; false: behind the eye.
    bool on_picture(clq_actor actor, float &x, float &y, float &radius) const;
    // A point of the picture, in pixels, where a click meets individual `index1`; false: it is nowhere to be seen.
    bool point_on(uint32_t index1, float &x, float &y) const;

private:
    bool body(clq_actor actor, Point &centre, double &radius) const;
    bool drawn(clq_actor actor, uint32_t &index, clq_drawn_actor &out) const;
    void make(const Switches &switches);
    bool count_people(uint32_t wanted);
    void show(Loaded loaded, const Switches &switches);
    void propose(Model &model);
    void unmake();
    void use_renderer(const Switches &switches);
    void follow(Model &model);
    void place_camera(Model &model, double aspect);
    void tint(Model &model);
    void dress(Model &model);
    Served served_of(clq_actor actor, const clq_actor_info &info);
    clq_view *view_of_columns();
    bool shows_part() const { return columns_ && columns_->x0 < std::min(columns_->x1, width_); }
    void clear() const;
    void look_for_loss();
    void show_levels(Model &model);
    double now_s() const { return now_ ? now_() : 0; }
    double ms_since(double start_s) const { return now_ ? (now_() - start_s) * 1000 : -1; }

    Surface &surface_;
    Open open_;
    Now now_;
    scenes::Gl gl_;
    Switches made_;
    std::unique_ptr<scenes::Library> library_;
    Opened opened_;
    std::unique_ptr<Workbench> workbench_;  // ends after the crowd, which calls its mechanisms
    std::unique_ptr<scenes::Scene> scene_;
    std::vector<clq_template *> templates_;
    std::optional<scenes::CameraPath> path_;
    scenes::Own<clq_view> view_;
    std::optional<processes::Tile> columns_;
    scenes::Own<clq_view> tile_view_;                     // of the columns
    clq_scene *index_ = nullptr;                          // of the crowd
    std::array<scenes::Own<clq_renderer>, 6> renderers_;  // by strategy, then with textures of their own
    clq_renderer *renderer_ = nullptr;
    clq_camera camera_ = {};
    scenes::Eye eye_ = {};
    double time_s_ = 0;
    unsigned (*get_error_)() = nullptr;  // glGetError
    bool context_lost_ = false;
    std::map<const clq_template *, Findings> findings_;
    std::unique_ptr<LevelRow> level_row_;
    clq_actor level_row_of_ = {};
    int width_ = 1, height_ = 1, below_ = 0;
    Dresser dresser_;
    std::vector<SharedMap> maps_;  // of the design, that templates were made with
    Painted painted_;
    uint32_t people_ = 0;               // that were wished for; 0: as many as the scene has
    std::map<uint32_t, double> ticks_;  // by index1, as the last tint found them
};

}  // namespace view
