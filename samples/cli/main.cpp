// claque: draws pictures of crowds, describes and prepares characters, measures and compares.
#include <cstdlib>

#include "samples/cli/program.h"
#include "samples/scenes/roles/roles_scene.h"
#include "samples/scenes/walkers/scenario_walkers.h"
#ifdef CLAQUE_STAGED
#include "samples/stage/staged_scene.h"
#endif

int main(int argc, char **argv)
{
    using namespace cli;
    setenv("EGL_LOG_LEVEL", "fatal", 0);  // one sentence says why there is no context, without Mesa's guesses around it
    scenes::draw_tracks_with(scenes::walkers::make_scenario);
    scenes::draw_people_with(scenes::roles::make_scenario);
#ifdef CLAQUE_STAGED
    scenes::draw_stages_with(staged::make_scenario);
#endif
    return run_program(argc, argv,
                       {
                           add_render, add_sheet,  add_inspect, add_dump,    add_split,  add_variety, add_colours,
                           add_lods,   add_blend,  add_prepare, add_convert, add_bench,  add_plot,    add_cost,
                           add_parity, add_tracks, add_play,    add_frames,  add_labels, add_view,    add_stage,
                       });
}
