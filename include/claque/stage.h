/* clq_stage: agents that decide (libclaque-stage, S1 2.1-2.2, S2 3.2). A stage runs state machines for agents and tells
 * a crowd's actors what to do, through claque's public calls alone, as any host could.
 *
 * Flows. Decisions (clq_stage_step) and drawing (clq_stage_apply, then clq_crowd_update) may run on two threads, and
 * scripts (clq_stage_send) on others; or all in turn on one. Each flow has one thread at a time. Between them are a
 * list of commands with times, which never blocks, and an inbox for what is sent, whose lock is held for an instant and
 * which the drawing flow never takes. Decisions run ahead of the time shown by a lead, say a second, so a slow decision
 * delays no frame. The library has no thread of its own.
 *
 *     decisions                                 drawing, at time t
 *     clq_stage_step(stage, t + 1.0);           clq_stage_apply(stage, crowd, t, NULL);
 *                                               clq_crowd_update(crowd, t, views, count);
 *
 * Time is decided in ticks. All that is decided is a function of the stage's calls with their times: not of when they
 * were made, if they were made before their time was decided; nor of threads, frames, or how time was cut into steps.
 * CLQ_STAGE_LIVE alone also depends on the speed of the machine.
 *
 * Tasks. What wakes an agent is a task: an event, a time, the end of a clip, a marker, a check. Nothing is asked every
 * frame. A task has a priority class, 0 (first) to 3, a time at which it is due, and a cost that its machine declares.
 * A tick has a budget. Tasks that it leaves over are run by later ticks and are late. Each class is guaranteed a share
 * of the budget, so no class starves: the oldest task of a class waits for at most
 *     ceil(cost / (share * budget)) + 3 ticks.
 *
 * Limits. At most 2^20 tasks wait, and 64 more for each agent. Messages that no step has taken have the same limit. At
 * most 2^20 commands wait to be applied, and 4096 more for each agent. A call that would bring more fails with LIMIT.
 *
 * GL: none. */
#ifndef CLAQUE_STAGE_H
#define CLAQUE_STAGE_H

#include <claque/agents.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CLQ_STAGE_CLASS_COUNT 4

typedef enum clq_stage_mode {
    CLQ_STAGE_REPRODUCIBLE = 0, /* the budget counts declared costs */
    CLQ_STAGE_LIVE = 1          /* the budget is in microseconds of the host's clock */
} clq_stage_mode;

typedef struct clq_stage_def {
    uint32_t struct_bytes; /* set by clq_stage_def_init */
    clq_stage_mode mode;
    uint64_t seed;                       /* of all random choices on this stage */
    double start_s;                      /* [-1e9, 1e9] what is decided begins after this time */
    double tick_s;                       /* [0.001, 10] default 0.05 */
    uint32_t budget;                     /* REPRODUCIBLE: cost of the tasks of one tick; 0: no limit */
    float budget_us;                     /* [>= 0] LIVE: microseconds of one tick; 0: no limit */
    float shares[CLQ_STAGE_CLASS_COUNT]; /* (> 0), together 1. Default 0.5, 0.25, 0.125, 0.125 */
    double (*now_s)(void *user); /* LIVE with a budget: a clock in seconds. What it throws counts as no time passed */
    void *now_user;
    float metres_per_unit; /* (> 0) as in clq_crowd_def. Default 1 */
} clq_stage_def;

static inline clq_stage_def clq_stage_def_init(void)
{
    clq_stage_def def;
    memset(&def, 0, sizeof def);
    def.struct_bytes = (uint32_t)sizeof def;
    def.tick_s = 0.05;
    def.shares[0] = 0.5f;
    def.shares[1] = 0.25f;
    def.shares[2] = def.shares[3] = 0.125f;
    def.metres_per_unit = 1.0f;
    return def;
}

/* Creates a stage without agents.
 *   context   of the crowds and templates; for its log. It must live as long as the stage
 *   def       copied; NULL means clq_stage_def_init()
 *   out       owned by the host until clq_stage_destroy
 * Fails: STRUCT_SIZE, ARGUMENT, OUT_OF_MEMORY. Threads: any. */
CLQ_API clq_status clq_stage_create(clq_context *context, const clq_stage_def *def, clq_stage **out);

/* Destroys a stage; NULL is ignored. Actors stay. Threads: no other call may use the stage at the same time. */
CLQ_API void clq_stage_destroy(clq_stage *stage);

/* Decides all ticks that end at or before a time. Agents act at the times at which their tasks are due; late tasks at
 * the end of the tick that runs them. If memory runs out or a limit is reached, the task at work is undone and waits
 * for the next call. Earlier decisions stay.
 *   until_s   finite; a time that is decided already does nothing
 * Fails: ARGUMENT, LIMIT (more than a million ticks in one call; tasks, after events that send too many events;
 * commands that clq_stage_apply has not taken), OUT_OF_MEMORY, BUSY (another thread decides).
 * Threads: the decisions' flow. */
CLQ_API clq_status clq_stage_step(clq_stage *stage, double until_s);

/* Returns the time up to which all is decided; 0 for NULL. Threads: any. */
CLQ_API double clq_stage_get_decided_s(const clq_stage *stage);

typedef struct clq_stage_applied {
    uint32_t struct_bytes; /* set by clq_stage_applied_init */
    uint32_t commands;     /* that were given to the crowd */
    uint32_t late;         /* of these, commands whose time an earlier call had already passed (LIVE) */
    uint32_t cut;          /* fades for which an actor had no room: their clips began at once */
    uint32_t refused; /* commands that the crowd refused, as of an actor that no longer exists; the log has the text */
    double behind_s;  /* by which time_s is after the time decided (LIVE); 0: it is not */
} clq_stage_applied;

CLQ_DEFINE_ZERO_INIT(clq_stage_applied)

/* Gives a crowd the commands up to a time, in their order. Never waits for a step. Call it before clq_crowd_update with
 * the same time.
 *   crowd   the same one in every call, of the stage's context
 *   out     made by clq_stage_applied_init; NULL: not wanted
 * Fails: STRUCT_SIZE, ARGUMENT (REPRODUCIBLE: a time that is not decided), OUT_OF_MEMORY and BUSY (of the crowd: the
 * commands that are left are given by the next call). Threads: the crowd's writer, the drawing flow. */
CLQ_API clq_status clq_stage_apply(clq_stage *stage, clq_crowd *crowd, double time_s, clq_stage_applied *out);

/* What the tasks of one priority class did since the stage was created or restored. */
typedef struct clq_stage_class_info {
    uint64_t done;         /* tasks that were run */
    uint64_t late;         /* of these, tasks that a later tick than their own ran */
    double longest_wait_s; /* from the end of its own tick to the end of the one that ran it */
    uint64_t cost;         /* declared */
    uint32_t waiting;      /* tasks that are due and were left over by the last tick */
} clq_stage_class_info;

typedef struct clq_stage_info {
    uint32_t struct_bytes; /* set by clq_stage_info_init */
    uint32_t agents, machines;
    double decided_s;
    uint64_t ticks, transitions, events, commands;
    uint64_t late_messages; /* sent for a time that was decided already */
    uint64_t runaways;      /* tasks that were stopped after 32 instant transitions; the log names the first */
    uint64_t tasks;         /* that wait for their time */
    uint64_t hash;          /* of all commands so far: equal runs have equal hashes on every machine */
    clq_stage_class_info classes[CLQ_STAGE_CLASS_COUNT];
} clq_stage_info;

CLQ_DEFINE_ZERO_INIT(clq_stage_info)

/* Gets what the last step left.
 *   out   made by clq_stage_info_init
 * Fails: STRUCT_SIZE, ARGUMENT. Threads: any. */
CLQ_API clq_status clq_stage_get_info(const clq_stage *stage, clq_stage_info *out);

/* Writes the state of a stage: agents, variables, tasks, commands that are not applied, tracks that actors follow. Save
 * the crowd at the same moment. Machines and actions are not written.
 * Fails: ARGUMENT, IO, CALLBACK, OUT_OF_MEMORY, BUSY (the last step failed within a tick: step again).
 * Threads: no other call may use the stage at the same time. */
CLQ_API clq_status clq_stage_save(const clq_stage *stage, clq_write_function write, void *user);

/* Replaces the state of a stage by one that clq_stage_save wrote. The stage must have been made with the same settings,
 * and have got the same actions and machines in the same order. Its future is then that of the saved stage. The bytes
 * may be anything.
 *   crowd   gets the tracks that its actors follow, so call this before clq_crowd_restore; NULL: no agent walks
 * Fails: ARGUMENT (other settings, machines or actions), FORMAT, OUT_OF_MEMORY, BUSY. Threads: as clq_stage_save. */
CLQ_API clq_status clq_stage_restore(clq_stage *stage, clq_crowd *crowd, const void *bytes, size_t size_bytes);

#ifdef __cplusplus
}
#endif

#endif
