/* claque: statuses, host services, identifiers. Included by every other header.
 *
 * C99 and C++. Every call that can fail returns a clq_status and, when it fails, leaves everything as it was;
 * clq_last_error() then holds one sentence that says which rule was broken, with names and numbers.
 * Suffixes of names carry units: _s seconds, _hz per second, _rad radians, _px pixels, _bytes, _count.
 * Definition structs ("defs") are made by their clq_..._init() function: all else zero means the sensible default. */
#ifndef CLAQUE_BASE_H
#define CLAQUE_BASE_H

#include <stddef.h>
#include <stdint.h>

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

#define CLQ_VERSION_MAJOR 0
#define CLQ_VERSION_MINOR 1
#define CLQ_VERSION_PATCH 0

#ifdef __cplusplus
extern "C" {
#endif

/* What a call came to. Numbers are never reused. */
typedef enum clq_status {
    CLQ_OK = 0,
    CLQ_ARGUMENT = 1,       /* an argument breaks its stated limit */
    CLQ_STRUCT_SIZE = 2,    /* struct_bytes is not one this library knows: header and library differ */
    CLQ_STALE_ID = 3,       /* the id names nothing that exists now */
    CLQ_OUT_OF_MEMORY = 4,  /* the host's allocator, or the C++ heap, refused */
    CLQ_LIMIT = 5,          /* a stated limit of the library or of a setting is reached */
    CLQ_FORMAT = 6,         /* the bytes break the rules of their format */
    CLQ_UNSUPPORTED = 7,    /* legal, but needs a feature that claque does not have; named in the text */
    CLQ_KEY_RESOLUTION = 8, /* more zones than the strategy can tell apart on this target */
    CLQ_GL_MISSING = 9,     /* no current context, or a GL 1.1 function is missing */
    CLQ_GL_STATE = 10,      /* the host's GL state would spoil the picture; named in the text */
    CLQ_BUSY = 11,          /* called while an update of the same crowd runs */
    CLQ_IN_USE = 12,        /* something that still exists needs it */
    CLQ_IO = 13             /* a file could not be read or written */
} clq_status;

/* The name of a status, for example "CLQ_STALE_ID"; "CLQ_?" for a number that is none. Never NULL. Any thread. */
CLQ_API const char *clq_status_name(clq_status status);

/* The last failure of a claque call on this thread, as one sentence; "" if there was none.
 * Valid until the next claque call on this thread. Successful calls leave it alone. */
CLQ_API const char *clq_last_error(void);

/* For libraries and bindings built on claque: makes `text` (copied, cut at 1023 bytes; NULL is "") this thread's
 * last error and returns `status`, so that `return clq_report(CLQ_IO, "...")` reads well. Any thread. */
CLQ_API clq_status clq_report(clq_status status, const char *text);

/* Memory from the host. `allocate` returns at least `size_bytes` aligned to `alignment_bytes` (a power of two), or
 * NULL when it refuses. `release` gets the same size back. Called from the thread that calls claque and from tasks. */
typedef struct clq_allocator {
    void *user;
    void *(*allocate)(void *user, size_t size_bytes, size_t alignment_bytes);
    void (*release)(void *user, void *memory, size_t size_bytes, size_t alignment_bytes);
} clq_allocator;

typedef enum clq_log_level { CLQ_LOG_INFO = 0, CLQ_LOG_WARNING = 1 } clq_log_level;

/* Where warnings and notes go; claque prints nothing itself. `text` is one sentence, valid during the call. */
typedef struct clq_log {
    void *user;
    void (*write)(void *user, clq_log_level level, const char *text);
} clq_log;

/* Threads from the host. `run` calls job(job_data, i) once for each i in [0, count), in any order, on any threads, and
 * returns when all are done. Left zero, claque works on the calling thread. Results never depend on it. */
typedef struct clq_tasks {
    void *user;
    void (*run)(void *user, uint32_t count, void (*job)(void *job_data, uint32_t index), void *job_data);
} clq_tasks;

#ifdef __cplusplus
}
#endif

#endif
