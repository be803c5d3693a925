/* clq_scene: finds the individuals of a crowd by id, by what they show, by category, in an order of the host's own, and
 * by place (S2 3.1: several indices of the same individuals).
 *
 * A host makes one or more scenes on a crowd; a crowd without a scene pays nothing. Calls that change the crowd mark
 * what they change, and the next clq_crowd_update or clq_scene_update of the crowd takes it over. Queries are exact
 * at any moment: what has been marked since is tested one by one. Their cost follows the number of answers, and grows
 * with the number of individuals changed since the last update and, for those on tracks, with the difference between
 * the time asked for and that of the last update.
 *
 * The place of an individual is its Skeleton Root: its Reference Point, moved by its group, its track and its root
 * path, but not put on the ground. It is found for the time that the query names, which may be any. Its body is the
 * Sklsroot Bsphere there, larger by as much as the ground may move it. Individuals are absent before and after their
 * track; members of disabled groups are found. An individual whose place is not finite has no place.
 *
 * Answers go to the host's array and depend on the crowd, the time and the query alone. A call writes the first
 * `capacity` of them in the order that it names, and their whole number to *out_count; the array may be NULL with
 * capacity 0. Queries change nothing and allocate nothing: any number of threads may ask at once between the calls of
 * the crowd's writer. */
#ifndef CLAQUE_SCENE_H
#define CLAQUE_SCENE_H

#include <claque/view.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct clq_scene clq_scene;

/* Creates a scene of all actors of a crowd.
 *   out   owned by the crowd; ends with clq_scene_destroy or with the crowd
 * Fails: ARGUMENT, OUT_OF_MEMORY, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_scene_create(clq_crowd *crowd, clq_scene **out);

/* Destroys a scene; NULL is ignored. Fails: BUSY; the scene then stays. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_scene_destroy(clq_scene *scene);

/* Takes over what has changed in the crowd, so that queries about times near time_s cost least. clq_crowd_update does
 * the same; this call is for hosts that ask more often than they draw.
 * Fails: ARGUMENT (a time that is not finite), OUT_OF_MEMORY (the answers stay right), BUSY. Threads: the crowd's
 * writer. GL: none. */
CLQ_API clq_status clq_scene_update(clq_scene *scene, double time_s);

/* Sets the categories of individuals, in place of those they had: for all or, when it fails, for none. A category is a
 * number from 0 to 63 to which the host gives a meaning, such as seated or owl; an individual has any set of them, one
 * bit each, so that a set is one number and queries combine them at no cost. They end with the actor, and are not
 * saved with the crowd; after clq_crowd_restore individuals with the same id have kept them.
 *   actors   [count]
 * Fails: STALE_ID (names the first), ARGUMENT, OUT_OF_MEMORY, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_scene_set_categories(clq_scene *scene, const clq_actor *actors, uint32_t count,
                                            uint64_t categories);

/* Sets the keys of individuals, numbers that put them into an order of the host's own: for all or, when it fails, for
 * none. Keys end as categories do.
 *   actors, keys   [count]; NaN: the individual has no key any more
 * Fails: STALE_ID (names the first), ARGUMENT, OUT_OF_MEMORY, BUSY. Threads: the crowd's writer. GL: none. */
CLQ_API clq_status clq_scene_set_keys(clq_scene *scene, const clq_actor *actors, const double *keys, uint32_t count);

/* Which individuals a query is about: those to which all conditions apply. */
typedef struct clq_scene_filter {
    uint32_t struct_bytes;    /* set by clq_scene_filter_init */
    const clq_template *tmpl; /* NULL: any */
    uint32_t texture_set;     /* CLQ_NONE: any */
    /* Level of detail in the draw list of the last clq_crowd_update that showed the individual while the scene existed;
     * CLQ_NONE: any, also individuals never shown. */
    uint32_t level;
    uint64_t any_of, all_of, none_of; /* categories as bits; 0: no condition */
} clq_scene_filter;

/* Returns a filter that all individuals pass. */
static inline clq_scene_filter clq_scene_filter_init(void)
{
    clq_scene_filter filter;
    memset(&filter, 0, sizeof filter);
    filter.struct_bytes = (uint32_t)sizeof filter;
    filter.texture_set = CLQ_NONE;
    filter.level = CLQ_NONE;
    return filter;
}

typedef struct clq_scene_actor {
    uint32_t struct_bytes;    /* set by clq_scene_actor_init */
    bool present;             /* false: absent at that time, or its place is not finite; the next three are 0 then */
    double position[3];       /* its place, in world units */
    double centre[3], radius; /* its body */
    const clq_template *tmpl;
    uint32_t texture_set;
    uint32_t level; /* as in clq_scene_filter; CLQ_NONE: never shown */
    uint64_t categories;
    double key; /* NaN: none */
} clq_scene_actor;

CLQ_DEFINE_ZERO_INIT(clq_scene_actor)

/* Gets what a scene knows of one individual, in constant time.
 *   out   made by clq_scene_actor_init
 * Fails: STRUCT_SIZE, STALE_ID, ARGUMENT, BUSY. Threads: any. GL: none. */
CLQ_API clq_status clq_scene_get_actor(const clq_scene *scene, clq_actor actor, double time_s, clq_scene_actor *out);

/* Finds individuals by what they show and by category, present or not; in the order of index1.
 *   filter       NULL: all
 *   out_actors   [capacity]
 * Fails: STRUCT_SIZE, ARGUMENT, BUSY. Threads: any. GL: none. */
CLQ_API clq_status clq_scene_find(const clq_scene *scene, const clq_scene_filter *filter, clq_actor *out_actors,
                                  uint32_t capacity, uint32_t *out_count);

/* Finds individuals whose key is in [low, high]; in the order of keys, then of index1.
 * Fails: STRUCT_SIZE, ARGUMENT (a NaN), BUSY. Threads: any. GL: none. */
CLQ_API clq_status clq_scene_find_keys(const clq_scene *scene, double low, double high, const clq_scene_filter *filter,
                                       clq_actor *out_actors, uint32_t capacity, uint32_t *out_count);

/* Finds the individual after another one in the order of keys, or before it.
 *   actor   one with a key
 *   back    true: before it
 *   out     {0, 0}: there is none
 * Fails: STRUCT_SIZE, STALE_ID, ARGUMENT, BUSY. Threads: any. GL: none. */
CLQ_API clq_status clq_scene_find_next(const clq_scene *scene, clq_actor actor, bool back,
                                       const clq_scene_filter *filter, clq_actor *out);

/* An individual found by place. */
typedef struct clq_scene_hit {
    clq_actor actor;
    double position[3]; /* its place at the time asked for */
    double distance;    /* world units; each call says from where */
} clq_scene_hit;

/* Queries about places at a time.
 *   time_s     on the clock of clq_crowd_update; any
 *   filter     NULL: all
 *   out_hits   [capacity]
 * Fail: STRUCT_SIZE, ARGUMENT (NULL; a number that is not finite, negative or out of order), BUSY. GL: none. */

/* Places nearest to a point; in the order of distance, then of index1. *out_count is at most capacity, and the call
 * looks no further than for that many.
 *   max_distance   [>= 0] may be infinite
 * Threads: any. */
CLQ_API clq_status clq_scene_find_nearest(const clq_scene *scene, double time_s, const double point[3],
                                          double max_distance, const clq_scene_filter *filter, clq_scene_hit *out_hits,
                                          uint32_t capacity, uint32_t *out_count);

/* All places within a distance from a point; in the order of distance, then of index1.
 *   radius   [>= 0] may be infinite
 * Threads: any. */
CLQ_API clq_status clq_scene_find_within(const clq_scene *scene, double time_s, const double point[3], double radius,
                                         const clq_scene_filter *filter, clq_scene_hit *out_hits, uint32_t capacity,
                                         uint32_t *out_count);

/* Places within a box along the axes of the world, its sides included; in the order of index1. Distances are 0.
 *   low, high   low[k] <= high[k]; either may be infinite
 * Threads: any. */
CLQ_API clq_status clq_scene_find_in_box(const clq_scene *scene, double time_s, const double low[3],
                                         const double high[3], const clq_scene_filter *filter, clq_scene_hit *out_hits,
                                         uint32_t capacity, uint32_t *out_count);

/* Bodies that meet what a camera sees; in the order of index1. A body at an outer edge of the pyramid may be found too.
 * Distances are from the eye to the place. Threads: any. */
CLQ_API clq_status clq_scene_find_in_frustum(const clq_scene *scene, double time_s, const clq_camera *camera,
                                             const clq_scene_filter *filter, clq_scene_hit *out_hits, uint32_t capacity,
                                             uint32_t *out_count);

/* A half-line, or a piece of it. */
typedef struct clq_ray {
    double origin[3];
    double direction[3]; /* of any length but 0 */
    double max_distance; /* [>= 0] world units; may be infinite */
} clq_ray;

/* Bodies that a ray meets; in the order of the distance at which it enters them (0: it begins within), then of
 * index1. Threads: any. */
CLQ_API clq_status clq_scene_find_on_ray(const clq_scene *scene, double time_s, const clq_ray *ray,
                                         const clq_scene_filter *filter, clq_scene_hit *out_hits, uint32_t capacity,
                                         uint32_t *out_count);

/* Gets the ray through a point of a picture, from the near plane on, without an end.
 *   x, y   [-1, 1] from left to right and from bottom to top
 * Fails: ARGUMENT (a camera that clq_view_set_camera would refuse, or whose projection has no inverse). Threads: any.
 * GL: none. */
CLQ_API clq_status clq_camera_get_ray(const clq_camera *camera, float x, float y, clq_ray *out);

/* What a ray meets first in a picture. */
typedef struct clq_scene_pick {
    uint32_t struct_bytes; /* set by clq_scene_pick_init */
    clq_actor actor;       /* {0, 0}: nothing; all others are 0 then */
    uint32_t index;        /* of the individual in the draw list, for clq_view_get_drawn_actor */
    uint32_t part;         /* of its level: a bit of clq_drawn_actor.parts */
    uint32_t zone;         /* of its template; CLQ_NONE: none */
    uint32_t vertices[3];  /* the triangle's corners, as in clq_view_get_vertices */
    float barycentric[3];  /* weights of the corners at the point met; their sum is 1 */
    double distance;       /* world units, from the ray's origin */
    double position[3];    /* of the point met, in the world */
} clq_scene_pick;

CLQ_DEFINE_ZERO_INIT(clq_scene_pick)

/* Finds the triangle that a ray meets first among those that a view's draw list draws: in the poses and at the places
 * of the last update. Backs of single-sided surfaces and holes are not met. The zone of a dirty triangle is that of the
 * texel at the point met. Actors destroyed since are not met.
 *   view   of the scene's crowd
 *   out    made by clq_scene_pick_init
 * Fails: STRUCT_SIZE, ARGUMENT, OUT_OF_MEMORY (parts that GL's matrix stack places are skinned for the call), BUSY
 * (also: another thread draws or reads the view). Threads: any, one at a time for a view. GL: none. */
CLQ_API clq_status clq_scene_pick_triangle(const clq_scene *scene, const clq_view *view, const clq_ray *ray,
                                           const clq_scene_filter *filter, clq_scene_pick *out);

typedef struct clq_scene_stats {
    uint32_t struct_bytes; /* set by clq_scene_stats_init */
    uint32_t actor_count;  /* individuals taken over */
    uint32_t marked;       /* individuals changed since, not counting members of groups that moved; all: actor_count */
    uint32_t moving;       /* individuals that follow a track */
    uint32_t keyed;        /* individuals that have a key */
    uint32_t height;       /* of the tree of places */
    uint64_t placed;       /* times that an individual got a new place in the tree, since the scene was created */
    uint64_t bytes;        /* memory of the scene; nodes of the order by keys are estimated */
} clq_scene_stats;

CLQ_DEFINE_ZERO_INIT(clq_scene_stats)

/* Gets the statistics of a scene.
 *   out   made by clq_scene_stats_init
 * Fails: STRUCT_SIZE, ARGUMENT, BUSY. Threads: any. GL: none. */
CLQ_API clq_status clq_scene_get_stats(const clq_scene *scene, clq_scene_stats *out);

#ifdef __cplusplus
}
#endif

#endif
