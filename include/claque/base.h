/* claque: conventions, statuses, host services. Every other header includes this one.
 *
 * The headers are C99 and C++. libclaque is what claque/claque.h includes; libclaque-assets is claque/assets.h,
 * trajectories.h, levels.h, zones.h, prepare.h and colour_files.h; libclaque-stage is claque/stage.h, agents.h and
 * navigation.h.
 *
 * Calls. A call that can fail returns a clq_status. A failed call leaves everything as it was, except where its comment
 * says otherwise; clq_last_error() then holds one sentence that names the broken rule, with names and numbers. A
 * comment lists the statuses that its call may return besides OK. Every call that returns a status also fails with
 * ARGUMENT where a pointer is NULL and the comment does not give NULL a meaning. Out parameters come last and are
 * written on CLQ_OK only. An out array is followed by its capacity. Getters are named clq_<class>_get_...
 *
 * Structs that begin with struct_bytes may grow in later versions.
 *   Make one with its _init function, which sets struct_bytes and every default, then set the members that differ:
 *       clq_crowd_def def = clq_crowd_def_init();
 *   A member that is 0 means 0, unless its comment gives 0 another meaning. A struct that is only zeroed has
 *   struct_bytes 0 and is refused with STRUCT_SIZE.
 *   The library accepts the size that the struct had in any released version up to its own. Input members that a
 *   shorter struct lacks get their defaults. Of an out struct the library writes struct_bytes bytes at most. Every
 *   other size fails with STRUCT_SIZE. A longer size is among them: the host was compiled with newer headers than the
 *   library.
 * Structs that the library passes to callbacks may grow at their end and have no struct_bytes.
 * All other structs (ids, small values, elements of arrays) never change. A _def among them has an _init function too,
 * except for those that are members of another struct and get their defaults with it.
 *
 * Callbacks. A callback may throw a C++ exception. No exception passes through claque: the call fails with CALLBACK and
 * leaves everything as it was; a view keeps its list. Calls that the callback had taken before are not taken back, nor
 * is what GL has drawn. Where a comment of the callback says so, the call goes on instead. A callback must not leave by
 * longjmp, and its thread must not be cancelled in it.
 *
 * Floating point. claque computes to nearest, keeps denormal numbers, lets x87 compute with 64 bits, and traps nothing,
 * whatever the host has set. Every call sets this on its thread, as does a task on its own, and puts back what it
 * found, also when it fails: rounding, flush to zero, precision, traps and the flags of exceptions. Callbacks, and GL
 * that a call uses, run under the host's settings, which they may change for good.
 *
 * Units. A suffix names the unit: _s seconds, _ms milliseconds, _us microseconds, _hz per second, _rad radians, _deg
 * degrees, _px pixels, _m metres, _m2 square metres, _m_s metres per second, _m_s2 metres per second squared, _bytes
 * bytes, _count a number of things.
 * A length has one of three units:
 *   metres         if its name ends in _m, and in clq_trajectory_sample, which has what a file has. Every distance
 *                  between an eye and an actor is in metres: update periods, levels of detail, key-poses, shadows,
 *                  statistics.
 *   world units    if it is without suffix and lies in the world: positions, translations, heights, camera planes. One
 *                  world unit is clq_crowd_def.metres_per_unit metres.
 *   model units    if it is without suffix and lies in an actor's own space: vertices, nodes, root paths, bounding
 *                  spheres at scale 1. clq_transform.scale takes them to world units. By convention one is a metre.
 * Ranges are named x_min and x_max, both included where the comment does not say otherwise. A limit is named max_x.
 * Intervals in comments are [closed] or (open).
 *
 * Spaces are right-handed. Matrices are column-major and multiply column vectors from the left, as in GL.
 *
 * Comments cite S0 (Rodriguez et al. 2010), S1 (de Heras Ciechomski et al. 2005, odeon), S2 (de Heras Ciechomski et al.
 * 2005, shaders) and S3 (Lister et al. 2010). */
#ifndef CLAQUE_BASE_H
#define CLAQUE_BASE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#if defined(CLAQUE_STATIC)
#define CLQ_API
#elif defined(_WIN32)
#if defined(CLAQUE_BUILDING)
#define CLQ_API __declspec(dllexport)
#else
#define CLQ_API __declspec(dllimport)
#endif
#elif defined(__GNUC__)
#define CLQ_API __attribute__((visibility("default")))
#else
#define CLQ_API
#endif

/* The version of these headers. CLQ_VERSION is major * 10000 + minor * 100 + patch. */
#define CLQ_VERSION_MAJOR 0
#define CLQ_VERSION_MINOR 2
#define CLQ_VERSION_PATCH 0
#define CLQ_VERSION (CLQ_VERSION_MAJOR * 10000 + CLQ_VERSION_MINOR * 100 + CLQ_VERSION_PATCH)

/* No index. */
#define CLQ_NONE 0xffffffffu

/* Defines the _init function of a struct whose defaults are all zero. */
#define CLQ_DEFINE_ZERO_INIT(type)                   \
    static inline type type##_init(void)             \
    {                                                \
        type value;                                  \
        memset(&value, 0, sizeof value);             \
        value.struct_bytes = (uint32_t)sizeof value; \
        return value;                                \
    }

/* The same for a struct without struct_bytes. */
#define CLQ_DEFINE_PLAIN_INIT(type)      \
    static inline type type##_init(void) \
    {                                    \
        type value;                      \
        memset(&value, 0, sizeof value); \
        return value;                    \
    }

#ifdef __cplusplus
extern "C" {
#endif

/* The result of a call. Numbers are never reused. */
typedef enum clq_status {
    CLQ_OK = 0,
    CLQ_ARGUMENT = 1,       /* an argument breaks its stated limit */
    CLQ_STRUCT_SIZE = 2,    /* struct_bytes is no size of a released version: header and library differ */
    CLQ_STALE_ID = 3,       /* the id names nothing that exists now */
    CLQ_OUT_OF_MEMORY = 4,  /* the host's allocator or the C++ heap refused */
    CLQ_LIMIT = 5,          /* a stated limit of the library or of a setting is reached */
    CLQ_FORMAT = 6,         /* the bytes break the rules of their format */
    CLQ_UNSUPPORTED = 7,    /* the input is legal but needs a feature that claque lacks; the text names it */
    CLQ_KEY_RESOLUTION = 8, /* the strategy cannot tell that many zones apart on this target */
    CLQ_GL_MISSING = 9,     /* no GL context is current, or a GL 1.1 function is missing */
    CLQ_GL_STATE = 10,      /* the host's GL state would spoil the picture; the text names it */
    CLQ_BUSY = 11,          /* another call works on the same crowd, view or renderer */
    CLQ_IN_USE = 12,        /* something that still exists needs the object */
    CLQ_IO = 13,            /* a file could not be read or written */
    CLQ_CALLBACK = 14       /* a callback of the host threw an exception; the text repeats it */
} clq_status;

/* Returns CLQ_VERSION of the library, which may differ from that of the headers. Threads: any. GL: none. */
CLQ_API uint32_t clq_version(void);

/* Returns the name of a status, for example "CLQ_STALE_ID"; "CLQ_?" for an unknown number. Never NULL. Threads: any.
 * GL: none. */
CLQ_API const char *clq_status_name(clq_status status);

/* Returns the last failure of a claque call on this thread as one sentence; "" if there was none. The string is valid
 * until the next claque call on this thread. Successful calls leave it alone. Threads: any. GL: none. */
CLQ_API const char *clq_last_error(void);

/* For libraries and bindings on top of claque: sets this thread's last error to `text` and returns `status`, so that
 * they can write return clq_report(CLQ_IO, "...").
 *   text   copied, cut at 1023 bytes; NULL means ""
 * Threads: any. GL: none. */
CLQ_API clq_status clq_report(clq_status status, const char *text);

/* Memory from the host. The threads that call claque and the tasks call both functions, several at once. */
typedef struct clq_allocator {
    void *user;
    /* Returns at least size_bytes, aligned to alignment_bytes (a power of two), or NULL to refuse. An exception counts
     * as a refusal. */
    void *(*allocate)(void *user, size_t size_bytes, size_t alignment_bytes);
    /* Gets the sizes that were given to allocate. An exception is ignored, and the memory counts as released. */
    void (*release)(void *user, void *memory, size_t size_bytes, size_t alignment_bytes);
} clq_allocator;

/* For libraries on top of claque, whose results should not depend on the host's floating-point settings either: sets
 * this thread's to those under which claque computes, until clq_floats_leave. Calls of claque in between leave them
 * alone, and callbacks of these calls run under the host's. Returns false, and does nothing, where the thread has
 * entered already. Threads: any. GL: none. */
CLQ_API bool clq_floats_enter(void);

/* Puts back the settings that clq_floats_enter found, as such a library does at its end and before it calls a callback
 * of its host. Returns false, and does nothing, where the thread has not entered. Threads: any; the host may have moved
 * its work to another one in a callback. GL: none. */
CLQ_API bool clq_floats_leave(void);

/* Returns whether the settings that clq_floats_enter found on this thread are others than claque's, so that a library
 * may save leaving them for calls that are short and many. False where the thread has not entered. Threads: any. GL:
 * none. */
CLQ_API bool clq_floats_differ(void);

typedef enum clq_log_level { CLQ_LOG_INFO = 0, CLQ_LOG_WARNING = 1 } clq_log_level;

/* Receives notes and warnings, on the thread that calls claque; on several at once where several threads call it.
 * claque itself prints nothing. */
typedef struct clq_log {
    void *user;
    /* `text` is one sentence and valid during the call. An exception is ignored. */
    void (*write)(void *user, clq_log_level level, const char *text);
} clq_log;

/* Threads from the host. Results never depend on them. */
typedef struct clq_tasks {
    void *user;
    /* Calls job(job_data, i) once for each i in [0, count), in any order and on any threads, and returns when all calls
     * have returned. If it throws, no call of job may still be at work; claque then makes the calls that are missing on
     * the calling thread and logs a warning, and the result is the same. */
    void (*run)(void *user, uint32_t count, void (*job)(void *job_data, uint32_t index), void *job_data);
} clq_tasks;

/* Receives the pieces of a file in order. Returns 0 if the piece was taken; any other value stops the call with IO. It
 * must not call claque for the object that is written. */
typedef int (*clq_write_function)(void *user, const void *bytes, size_t size_bytes);

/* Returns the height of the ground, in world units, below or above a point of the world: its y, or for shadows its
 * distance along clq_shadow_def.up from the world's origin. NaN means that there is no ground. The result depends on
 * the point alone. It must not call claque. */
typedef double (*clq_height_function)(void *user, const double point[3]);

#ifdef __cplusplus
}
#endif

#endif
