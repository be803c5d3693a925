/* Recording a run and playing it back: every call of a host that changes a crowd, in order, with the times of its
 * updates and the tracks that it used. A crowd into which a record is played shows the same draw lists, bit for bit.
 *
 * A step is a clq_crowd_update. It shows what the calls before it have made; so playing to a step makes all calls that
 * the recorded host made before that update, and an update of the playing host at the step's time shows what was shown.
 * The ids of actors, groups, attachments, layers, mechanisms, paths, gaits and masks are those of the recorded run.
 *
 * What is recorded: the state of the crowd where the record begins (claque/save.h); actors, clips, fades, layers,
 * colours as they became, texture sets, priorities, attachments, groups, mechanisms, root paths and commands; tracks
 * and their locomotions, each written once, when an actor first follows it; clq_crowd_restore, as the state that it
 * led to; the members of clq_crowd_def that change what is shown.
 * What is not recorded: services that the host lends, which are code: hooks (clq_actor_set_hooks), the ground
 * (clq_crowd_set_ground; which actors follow it is recorded) and what host mechanisms run
 * (clq_record_lend_mechanism); templates, which the playing host supplies as for clq_crowd_restore; views and cameras;
 * clq_crowd_add_track.
 * With CLQ_CLOCK_LIVE, lod_hysteresis or host mechanisms that have memory, draw lists depend on the updates before:
 * equal lists then need the same updates in the same order.
 *
 * docs/records.md shows how records are used, and what they cost. GL: none. */
#ifndef CLAQUE_RECORD_H
#define CLAQUE_RECORD_H

#include <claque/behave.h>
#include <claque/save.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct clq_recording_def {
    uint32_t struct_bytes; /* set by clq_recording_def_init */
    /* Gets the pieces of the file, during calls that change the crowd: one at the end of each update, and more where
     * many calls come between two updates. Must not call claque for this crowd. */
    clq_write_function write;
    void *user;
    /* A key state is written before an update when as many bytes have been written since the last state as that state
     * had, and at least so many. Default 65536. A larger number makes a smaller record and slower seeking. */
    uint64_t key_bytes;
} clq_recording_def;

static inline clq_recording_def clq_recording_def_init(void)
{
    clq_recording_def def;
    memset(&def, 0, sizeof def);
    def.struct_bytes = (uint32_t)sizeof def;
    def.key_bytes = 65536;
    return def;
}

typedef struct clq_recording_info {
    uint32_t struct_bytes; /* set by clq_recording_info_init */
    clq_status status;     /* OK: it goes on. Else it has ended because of this; nothing is written any more */
    char text[240];        /* the reason as a sentence, or "" */
    uint64_t bytes;        /* that the writer took */
    uint64_t calls, steps; /* recorded; calls without updates */
    uint64_t tracks, key_states;
    uint64_t held_bytes; /* memory of the piece that is being made */
} clq_recording_info;

CLQ_DEFINE_ZERO_INIT(clq_recording_info)

/* Begins to record a crowd, with its present state. The recording goes on until clq_crowd_end_recording or
 * clq_crowd_destroy. If the writer refuses a piece later, or memory is refused, the recording ends: calls for the crowd
 * succeed as without it, and a warning is logged.
 *   def   copied
 * Fails: STRUCT_SIZE, ARGUMENT (also a crowd that is recorded already), LIMIT (more than 256 locomotions), IO,
 * OUT_OF_MEMORY, BUSY, CALLBACK; nothing is recorded then. Threads: the crowd's writer. */
CLQ_API clq_status clq_crowd_begin_recording(clq_crowd *crowd, const clq_recording_def *def);

/* Ends the recording of a crowd and writes its end.
 *   out   made by clq_recording_info_init; may be NULL. It is also written where the status is that of the recording
 * Fails: STRUCT_SIZE, ARGUMENT (a crowd that is not recorded), BUSY; the status with which the recording ended before,
 * or ends now: IO, CALLBACK, LIMIT, OUT_OF_MEMORY. A record that failed plays up to what was written.
 * Threads: the crowd's writer. */
CLQ_API clq_status clq_crowd_end_recording(clq_crowd *crowd, clq_recording_info *out);

/* Gets how the recording of a crowd goes.
 *   out   made by clq_recording_info_init
 * Fails: STRUCT_SIZE, ARGUMENT (a crowd that is not recorded), BUSY. Threads: any. */
CLQ_API clq_status clq_crowd_get_recording(const clq_crowd *crowd, clq_recording_info *out);

typedef struct clq_record clq_record;

/* Opens a record. The bytes may be anything: what was changed is refused; what is cut off, because the recording host
 * ended before its time, plays up to the cut. The time is proportional to the size.
 *   bytes   [size_bytes], which must stay as they are until clq_record_destroy
 *   out     owned by the host until clq_record_destroy
 * Fails: ARGUMENT (NULL), FORMAT (with the place), OUT_OF_MEMORY. Threads: any. */
CLQ_API clq_status clq_record_load(clq_context *context, const void *bytes, size_t size_bytes, clq_record **out);

/* Opens a record by its index, which clq_crowd_end_recording writes: a file that is mapped into memory is read where it
 * is played. Each part is read and checked when it is first needed. A record has no index if it was cut
 * off, or if an earlier version of the library wrote it (form 1). It is then read whole, as by clq_record_load. Both
 * ways play the same.
 *   bytes, out   as for clq_record_load
 * Fails: as clq_record_load, for the index. A part that was changed is refused by the call that plays it (FORMAT).
 * Threads: any. */
CLQ_API clq_status clq_record_open(clq_context *context, const void *bytes, size_t size_bytes, clq_record **out);

/* Destroys a record; NULL is ignored. Crowds into which it was played keep what they need. Threads: any, not while
 * another call uses the record. */
CLQ_API void clq_record_destroy(clq_record *record);

typedef struct clq_record_info {
    uint32_t struct_bytes; /* set by clq_record_info_init */
    bool whole;            /* false: it was cut off */
    uint32_t template_count, track_count;
    uint64_t step_count, call_count, state_count;
    double start_s, end_s; /* the earliest and the latest time of a step; 0 without steps */
    uint64_t bytes;        /* memory held, without the host's bytes */
    /* Of the host's bytes, how many were looked at so far: all after clq_record_load. After clq_record_open each track
     * that was needed counts besides the part in which it lies. */
    uint64_t read_bytes;
} clq_record_info;

CLQ_DEFINE_ZERO_INIT(clq_record_info)

/* Gets what a record holds.
 *   out   made by clq_record_info_init
 * Fails: STRUCT_SIZE, ARGUMENT. Threads: any. */
CLQ_API clq_status clq_record_get_info(const clq_record *record, clq_record_info *out);

/* Gets the definition of the recorded crowd, with which the playing host should create its own. Only the cache, its
 * budget and the cull mode may differ. now_s and update_budget_ms are 0.
 *   out   made by clq_crowd_def_init
 * Fails: STRUCT_SIZE, ARGUMENT. Threads: any. */
CLQ_API clq_status clq_record_get_crowd_def(const clq_record *record, clq_crowd_def *out);

/* Returns the name of a template that the record needs; "" beyond the last one. It lives as long as the record.
 *   index   [0, clq_record_info.template_count)
 * Threads: any. */
CLQ_API const char *clq_record_get_template_name(const clq_record *record, uint32_t index);

/* Gives a record its templates, once, before it is played, and loads its tracks.
 *   templates   [template_count], as for clq_crowd_restore: for each template of the record one of the same name and
 *               structure. The record holds those that it uses
 * Fails: ARGUMENT (a missing template, by name; another structure; another locomotion; a second time), FORMAT (a track
 * that is broken), OUT_OF_MEMORY. Threads: any, not while another call uses the record. */
CLQ_API clq_status clq_record_set_templates(clq_record *record, clq_template *const *templates,
                                            uint32_t template_count);

/* Lends what a host mechanism of the recorded run does. One that is not lent gets the callback that the played crowd's
 * own mechanism of that number has, as in clq_crowd_restore.
 *   mechanism   its number, as in the recorded run
 *   def         copied; has_memory is that of the recorded run
 * Fails: ARGUMENT, OUT_OF_MEMORY. Threads: any, not while another call uses the record. */
CLQ_API clq_status clq_record_lend_mechanism(clq_record *record, clq_mechanism mechanism,
                                             const clq_host_mechanism_def *def);

/* Gets the time of a step.
 *   step   [0, clq_record_info.step_count)
 * Fails: ARGUMENT. Threads: any. */
CLQ_API clq_status clq_record_get_time(const clq_record *record, uint64_t step, double *out_s);

/* Makes in a crowd the calls that the recorded host had made before a step; clq_crowd_update with the step's time then
 * shows what the recorded crowd showed. The crowd is the record's from then on: what else the host changes in it ends
 * with the next call of this function. Hooks and the ground stay, as in clq_crowd_restore. Any number of crowds, each
 * in its thread, may play one record.
 *
 * From one step to a later one near it, the calls in between are made. Otherwise the last state before the step is
 * restored, and the calls since then are made: at most as many bytes as that state has, or clq_recording_def.key_bytes,
 * besides the calls of one step.
 *   step    [0, clq_record_info.step_count]; the last number: all calls, also those after the last update
 *   crowd   of the record's context, not recorded itself
 * Fails: ARGUMENT (also a record without templates; a host mechanism that is not lent, by number), FORMAT (calls that
 * no crowd accepts), OUT_OF_MEMORY, BUSY. The crowd is then in a state between; the next call begins with a state of
 * the record. Threads: the crowd's writer. */
CLQ_API clq_status clq_record_play_step(const clq_record *record, clq_crowd *crowd, uint64_t step);

/* The same for a time: up to the last step at or before it. Times before the first step show the first one. Times after
 * the last one show all calls. Where the recorded clock went back, a time that came more than once is its last one.
 *   time_s   finite
 * Fails: as clq_record_play_step. Threads: the crowd's writer. */
CLQ_API clq_status clq_record_play(const clq_record *record, clq_crowd *crowd, double time_s);

#ifdef __cplusplus
}
#endif

#endif
