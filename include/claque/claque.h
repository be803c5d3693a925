/* claque: a crowd library for the fixed-function OpenGL 1.1 target. This header includes all of libclaque.
 *
 * Use in four steps: create a crowd; create actors; in each frame call clq_crowd_update with the host's time and views;
 * then call clq_renderer_draw for each view. samples/hello.c is a complete program. Characters come from
 * claque/assets.h, from prepared files (clq_template_load) or from the host's own arrays (clq_template_build). Read
 * claque/base.h first. */
#ifndef CLAQUE_CLAQUE_H
#define CLAQUE_CLAQUE_H

#include <claque/base.h>
#include <claque/behave.h>
#include <claque/colours.h>
#include <claque/context.h>
#include <claque/crowd.h>
#include <claque/crowd_stats.h>
#include <claque/drawn_actor.h>
#include <claque/group.h>
#include <claque/key_poses.h>
#include <claque/mesh.h>
#include <claque/play.h>
#include <claque/record.h>
#include <claque/renderer.h>
#include <claque/save.h>
#include <claque/scene.h>
#include <claque/shadow.h>
#include <claque/simd.h>
#include <claque/speed.h>
#include <claque/template.h>
#include <claque/template_info.h>
#include <claque/track.h>
#include <claque/update_times.h>
#include <claque/view.h>
#include <claque/visibility.h>

#endif
