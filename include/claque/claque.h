/* claque: a crowd library for the fixed-function OpenGL 1.1 target. This header includes all of libclaque.
 *
 * A host in four lines: create a crowd; create actors in a loop; each frame clq_crowd_update with the host's time and
 * views, then clq_renderer_draw. samples/hello.c is the whole of it. Characters come from claque/assets.h, from
 * prepared files or from the host's own arrays. */
#ifndef CLAQUE_CLAQUE_H
#define CLAQUE_CLAQUE_H

#include <claque/base.h>
#include <claque/behave.h>
#include <claque/colours.h>
#include <claque/context.h>
#include <claque/crowd.h>
#include <claque/drawn_actor.h>
#include <claque/group.h>
#include <claque/key_poses.h>
#include <claque/mesh.h>
#include <claque/play.h>
#include <claque/renderer.h>
#include <claque/save.h>
#include <claque/shadow.h>
#include <claque/simd.h>
#include <claque/template.h>
#include <claque/view.h>

#endif
