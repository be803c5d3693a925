/* libclaque-assets: characters from files (glTF, GLB, BVH) and built-in characters, and the templates built from them.
 *
 * The library is separate from libclaque, which needs libc and libstdc++ only and loads templates that
 * clq_template_save wrote. Working memory comes from the C++ heap; templates are in the context's memory. */
#ifndef CLAQUE_ASSETS_H
#define CLAQUE_ASSETS_H

#include <claque/asset_info.h>
#include <claque/trajectories.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What becomes of glTF's alpha mode BLEND, as people are drawn without blending. A material whose alpha is 1 everywhere
 * is opaque in every case. */
typedef enum clq_blend {
    CLQ_BLEND_UNSET = 0,  /* as MASK, and a warning names each material, and OPAQUE unless it is of hair or eyes */
    CLQ_BLEND_OPAQUE = 1, /* all of it, whatever its alpha */
    CLQ_BLEND_MASK = 2    /* an alpha test: opaque where alpha is 0.5 and more, nothing elsewhere (hair, lashes) */
} clq_blend;

/* The colours of individuals in zones that have no colour range of their own. Zone keys with ranges, and maps of
 * colours, are not touched. */
typedef enum clq_colours {
    /* Near those of the file. Skin and hair stay human, all skin has one colour, and eyes, teeth and metal keep theirs
     * (docs/characters.md). */
    CLQ_COLOURS_NEAR = 0,
    CLQ_COLOURS_WILD = 1, /* most hues */
    CLQ_COLOURS_OWN = 2   /* those of the file */
} clq_colours;

typedef struct clq_asset_options {
    uint32_t struct_bytes; /* set by clq_asset_options_init */
    /* The folder of external buffers and images. NULL: clq_asset_load refuses them, clq_asset_load_file uses the folder
     * of the file. */
    const char *base_folder;
    const char *const *hidden_nodes; /* [hidden_node_count] names: templates leave out these nodes and all below them */
    uint32_t hidden_node_count;
    uint64_t memory_limit_bytes; /* 0: 1 GiB */
    double bvh_metres_per_unit;  /* metres in a unit of a BVH file, which does not say; 0: 1 */
    /* A picture whose file is missing fails with IO. false: it gives a warning, and its materials show their base
     * colour. */
    bool strict;
    /* Facing and size. The character is placed by a node without a name above the roots of its file, node 0, so rest
     * pose, clips, morphs, root motion and clips that are added later turn and grow alike.
     * turn_deg: degrees about y, from +z towards +x; any finite number. Characters face +z. A warning names one that
     * faces elsewhere in its clips, by its toes, eyes or legs, and the turn that it needs; without clips at rest. VRM
     * 0.x faces -z by its specification; it is turned by 180 degrees before this. 0 (default): no further turn */
    double turn_deg;
    /* The height of the rest pose in model units, without hidden parts: above 0, and at most 1e6 times or a millionth
     * of the file's own. 0 (default): the file's own. A file without vertices has no height. A warning names a
     * person with arms and legs below 0.6 or above 4 units, unless a height or a scale is given */
    double height_m;
    double scale; /* multiplies the size: [1e-6, 1e6], and not beside height_m. 0 (default): 1 */
    clq_blend blend;
    clq_colours colours;
} clq_asset_options;

CLQ_DEFINE_ZERO_INIT(clq_asset_options)

/* Loads a glTF 2.0, GLB or BVH file; the content decides which, not the name. The bytes may be anything. Warnings go to
 * the context's log, those of clq_asset_load_file with the path in front. KHR_draco_mesh_compression,
 * EXT_meshopt_compression and EXT_texture_webp are read if the library was built with their decoders; the text of
 * UNSUPPORTED says which it has. A BVH file gives a skeleton without parts and one clip named after the file
 * (clq_asset_load: "motion"): a source for clq_asset_add_clips.
 *
 * glTF files may extend the format by `extras`:
 *   in an animation   "extras": {"claque": {"markers": [{"name": "left foot down", "time_s": 0.25}],
 *                                           "root_motion": "hips"}}
 *     markers: as clq_marker_def, in any order, at most 4096 per animation; time_s on the axis of its keys, from the
 *     first to the last. root_motion: the name of the node of clq_root_motion_def; building the template fails if a
 *     node above it is animated. Both go with the clip in clq_asset_add_clips.
 *   in a node         "extras": {"claque": {"deactivation_m": 40, "lod_m": [0, 40], "dofs":
 *                                           [{"name": "gaze yaw", "kind": "rotation", "axis": [0, 1, 0],
 *                                             "min": -0.7, "max": 0.7, "rest": 0}]}}
 *     as clq_node_def, clq_part_def and clq_dof_def; a kind is rotation, translation, or morph with "morph_target" in
 *     place of the axis.
 * Unknown members are ignored. Known members that break these rules fail with FORMAT and their place in the file.
 *
 *   options   NULL means clq_asset_options_init()
 *   out       owned by the host until clq_asset_destroy
 * Fail: STRUCT_SIZE, ARGUMENT, FORMAT, UNSUPPORTED (names the feature), LIMIT, IO, OUT_OF_MEMORY.
 * Threads: any. GL: none. */
CLQ_API clq_status clq_asset_load(clq_context *context, const void *bytes, size_t size_bytes,
                                  const clq_asset_options *options, clq_asset **out);
CLQ_API clq_status clq_asset_load_file(clq_context *context, const char *path, const clq_asset_options *options,
                                       clq_asset **out);

/* Makes a built-in character, which needs no file. Four are people of 1078 to 1092 triangles and 33 nodes, 1.75 to
 * 1.8 units tall:
 *   "citizen"    a man in a girded tunic, 8 zones
 *   "patrician"  a rich woman in stola and palla, 10 zones
 *   "decurion"   an older man in a toga, 9 zones
 *   "plebeian"   a young working man in an exomis, 9 zones
 * Clips of the people:
 *   stand, walk, applaud, cheer
 *   sit, sit_lean, sit_look, sit_talk, sit_applaud, sit_cheer, sit_laugh, sit_wave
 *     Loops of 4 to 9 s that begin and end in one pose and so may follow each other. The top of the seat is 0.43 m
 *     above the feet, its front edge 0.14 m behind the origin.
 *   rise, sit_down
 *     About 2 s, once: from that pose to the beginning of stand, and back.
 *   stand_wave, stand_laugh, stand_applaud, stand_cheer
 *     They begin and end as stand.
 *   jog, walk_slow, turn
 *     In step with walk: in all of them the left foot comes down at the beginning, the right one in the middle. turn
 *     steps on the spot, for people that turn while they stand (claque/track.h).
 *   stand_look, stand_shift
 *     They begin and end as stand: looking round, and resting on one leg after the other.
 * Two are flying actors of rigid parts on 14 nodes with 19 degrees of freedom, levels of detail (S0 7.1), and the clips
 * fly, glide and hover:
 *   "herald"     a winged youth with trumpet and scroll, 10 zones
 *   "owl"        an owl that carries a letter, 8 zones
 *
 *   out   owned by the host until clq_asset_destroy
 * Fails: ARGUMENT (names what there is), OUT_OF_MEMORY. Threads: any. GL: none. */
CLQ_API clq_status clq_asset_builtin(clq_context *context, const char *name, clq_asset **out);

/* Makes one of the four people with more clips (S1 8: 150 clips): its own twenty-three, and variants of each in turn,
 * until there are clip_count. Variants differ in tempo, timing, amplitude, the leading hand and an added swaying. They
 * are named "sit_talk.03" and the like. What holds for a clip (loops, seats, common beginnings and ends) holds for its
 * variants. All calls give the same bytes.
 *   clip_count   [23, 2000]
 * Fails: ARGUMENT (names what there is), OUT_OF_MEMORY. Threads: any. GL: none. */
CLQ_API clq_status clq_asset_builtin_varied(clq_context *context, const char *name, uint32_t clip_count,
                                            clq_asset **out);

/* Destroys an asset; NULL is ignored. Templates built from it stay. Threads: any. GL: none. */
CLQ_API void clq_asset_destroy(clq_asset *asset);

/* Adds a texture set to an asset (clq_texture_set_def). KHR_materials_variants of a glTF file are texture sets already;
 * each of the four built-in people has a second one.
 *   name     for clq_template_find_texture_set
 *   images   [image_count], copied; image_count is clq_asset_info.material_count. rgba NULL: the material's own image.
 *            The material must have an image, and the meaning of both alphas must agree
 * Fails: ARGUMENT, LIMIT (63 sets), OUT_OF_MEMORY; the asset then stays. Threads: one per asset. GL: none. */
CLQ_API clq_status clq_asset_add_texture_set(clq_context *context, clq_asset *asset, const char *name,
                                             const clq_image_def *images, uint32_t image_count);

/* A degree of freedom for a node that is found by its name. */
typedef struct clq_asset_dof {
    const char *node_name; /* the first node of this name */
    clq_dof_def dof;       /* without its node: that member is not read */
} clq_asset_dof;

CLQ_DEFINE_PLAIN_INIT(clq_asset_dof)

/* Adds degrees of freedom to an asset, behind those that it has. Control mechanisms may then move characters whose
 * files have none, such as the built-in people: a gaze turns the head of any character with a neck.
 *   dofs   [dof_count], copied
 * Fails: ARGUMENT (names a node that is missing, and degrees of freedom that break the rules of clq_dof_def),
 * OUT_OF_MEMORY; the asset then stays. Threads: one per asset. GL: none. */
CLQ_API clq_status clq_asset_add_dofs(clq_context *context, clq_asset *asset, const clq_asset_dof *dofs,
                                      uint32_t dof_count);

/* Computes the animated positions of all parts, in model space, in file order: nodes depth first, primitives in order.
 *   clip              CLQ_NONE: the rest pose with default morph weights
 *   time_s            on the clip's own key axis, clamped to it
 *   out_xyz           [capacity_floats]
 *   capacity_floats   3 * clq_asset_info.vertex_count or more
 * Fails: ARGUMENT, OUT_OF_MEMORY. Threads: any. GL: none. */
CLQ_API clq_status clq_asset_get_positions(const clq_asset *asset, uint32_t clip, float time_s, float *out_xyz,
                                           size_t capacity_floats);

/* The orientation of a joint that corresponds to the rest pose of the clips' skeleton. */
typedef enum clq_rest_alignment {
    CLQ_REST_KEEP = 0, /* its own rest orientation */
    /* Its rest orientation, turned so that the bone points where the other skeleton's bone points; for A-poses and
     * T-poses. A joint with no or several bound joints below it turns like the bound joint above it. */
    CLQ_REST_ALIGN = 1
} clq_rest_alignment;

typedef struct clq_joint_pair {
    const char *source; /* a joint of the clips' skeleton */
    const char *target; /* a joint of the character, once at most */
    clq_rest_alignment rest;
} clq_joint_pair;

/* A joint without a source that follows a bound joint, as cloth follows a thigh. A joint with several leaders follows
 * the one that turns it farthest. Of a leader that turns away from the side on which the joint lies only 0.3 of the
 * share counts. */
typedef struct clq_follower {
    const char *joint, *leader; /* joints of the character */
    float share;                /* [0, 1] of the leader's rotation from its rest, as seen by the joint's parent */
} clq_follower;

typedef enum clq_retarget_mode {
    CLQ_RETARGET_AUTOMATIC = 0, /* CHANNELS if the skeletons agree and start_s, end_s and close_s are 0; else MOTION */
    CLQ_RETARGET_CHANNELS = 1,  /* copies keys, steps and splines */
    /* Joints turn from their rest orientation as the source's do, in model space. The topmost joint takes the source's
     * root motion, scaled by the length of the legs and lowered so that the feet stand on y = 0. */
    CLQ_RETARGET_MOTION = 2
} clq_retarget_mode;

/* The pose of the clips' skeleton that corresponds to the character's rest pose. */
typedef enum clq_source_rest {
    /* CHARACTER if the bones' names and offsets are equal: each within 1 % of its limb, at one common scale. Else BONES
     * if all bones lie along one axis in the file's rest pose. Else CHARACTER if bones then point as in the clips, and
     * with FILE 15 degrees or more elsewhere. Else FILE. The log names each choice but the first and the last. */
    CLQ_SOURCE_REST_AUTOMATIC = 0,
    CLQ_SOURCE_REST_FILE = 1,  /* the file's rest pose */
    CLQ_SOURCE_REST_FRAME = 2, /* the pose of the key rest_frame of the first clip that is taken */
    /* The pose of a clip in which the bones point most as the character's do. All joints are CLQ_REST_ALIGN but those
     * of a trunk that stands in it. */
    CLQ_SOURCE_REST_BONES = 3,
    CLQ_SOURCE_REST_CHARACTER = 4 /* the character's: local rotations are copied, whatever the rest of the file is */
} clq_source_rest;

typedef enum clq_root_travel {
    CLQ_ROOT_TRAVEL_IN_PLACE = 0, /* removes the straight line from the clip's first position to its last */
    CLQ_ROOT_TRAVEL_KEEP = 1
} clq_root_travel;

typedef struct clq_clips_def {
    uint32_t struct_bytes;        /* set by clq_clips_def_init */
    const clq_joint_pair *joints; /* [joint_count]; with joint_count 0 joints of equal names correspond */
    uint32_t joint_count;
    const char *const *clips; /* [clip_count] names in the source; with clip_count 0 all clips */
    uint32_t clip_count;
    const char *prefix; /* of the names of the added clips; may be NULL */
    clq_retarget_mode mode;
    /* The remaining members are for CLQ_RETARGET_MOTION. */
    clq_root_travel travel;
    float rate_hz;                 /* of keys, [1, 1000]; 0: 30 */
    float start_s, end_s;          /* the part of each clip to take, from the clip's start on; end_s 0: to its end */
    const clq_follower *followers; /* [follower_count] */
    uint32_t follower_count;
    /* The clip turns into its first pose over this time before its end, so that it loops. 0: it does not. */
    float close_s;
    clq_source_rest rest;
    uint32_t rest_frame; /* for CLQ_SOURCE_REST_FRAME: from 0 */
} clq_clips_def;

CLQ_DEFINE_ZERO_INIT(clq_clips_def)

typedef struct clq_clips_report {
    uint32_t struct_bytes;  /* set by clq_clips_report_init */
    clq_retarget_mode mode; /* CHANNELS or MOTION */
    uint32_t clip_count;    /* clips that were added, the last ones of the asset */
    uint32_t joint_count;   /* joints that are bound */
} clq_clips_report;

CLQ_DEFINE_ZERO_INIT(clq_clips_report)

/* Adds clips of one asset to another, before templates are built from it. Joints are bound by name, or as the parts of
 * a human body if more of them are found so: by the humanoid bones of VRM files, or by the usual names. The context's
 * log and the asset's warnings name the joints that are not bound, and the clips that show a head below the hips, feet
 * above the ground or arms in the trunk where the clips' own skeleton does not. A clip whose name is taken gets a
 * number.
 * A character that rests above the ground, as one saved in a jump, turns from the pose in which its skin was bound.
 *   source       any asset with clips: glTF with or without meshes, BVH, a built-in character; not kept
 *   def          NULL means clq_clips_def_init()
 *   out_report   made by clq_clips_report_init; may be NULL
 * Fails: STRUCT_SIZE, ARGUMENT (no joint is bound; a clip that is missing; a number out of range), LIMIT,
 * OUT_OF_MEMORY; the asset then stays. Threads: one per asset. GL: none. */
CLQ_API clq_status clq_asset_add_clips(clq_context *context, clq_asset *asset, const clq_asset *source,
                                       const clq_clips_def *def, clq_clips_report *out_report);

/* Builds a template from an asset, as clq_template_build does.
 *   max_texture_px   larger images are reduced; 0: 1024
 *   out              owned by the host until clq_template_destroy
 * Fails: as clq_template_build. Threads: any. GL: none. */
CLQ_API clq_status clq_asset_build(clq_context *context, const clq_asset *asset, uint32_t max_texture_px,
                                   clq_template **out);

/* Load a glTF file, or make a built-in character, and build its template in levels of detail, in one call.
 *
 * Levels are those of clq_asset_make_levels with NULL; parts with distances of their own keep them. A character that
 * it refuses with LIMIT is built without levels, and a warning says why. Levels take seconds, so the template is kept
 * on disk as by clq_template_prepare, in $XDG_CACHE_HOME/claque, else $HOME/.cache/claque; without a folder it is made
 * in each call. The template of the same bytes and options then comes from there, in milliseconds, without the warnings
 * of the file. A built-in character that was installed with the library comes from there at once
 * (clq_prepare_def.folder). For one without levels, or nothing on disk: clq_asset_load or clq_asset_builtin, then
 * clq_asset_build.
 *   out   owned by the host until clq_template_destroy
 * Fail: as clq_asset_load or clq_asset_builtin, and clq_asset_build. Threads: any. GL: none. */
CLQ_API clq_status clq_template_load_gltf(clq_context *context, const void *bytes, size_t size_bytes,
                                          const clq_asset_options *options, clq_template **out);
CLQ_API clq_status clq_template_builtin(clq_context *context, const char *name, clq_template **out);

#ifdef __cplusplus
}
#endif

#endif
