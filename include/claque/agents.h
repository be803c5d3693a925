/* What a stage directs (libclaque-stage): state machines, agents, the events that they get and the variables that they
 * share. claque/stage.h has the stage itself and its flows; docs/stage.md describes the files.
 *
 * Threads: the calls belong to the stage's decisions, so one thread at a time makes them or clq_stage_step, except
 * clq_stage_send, clq_stage_set_variable and clq_stage_tell_view, which any thread may call at any time. Calls that
 * add, remove or place something fail with BUSY while another of them or clq_stage_step is at work. GL: none. */
#ifndef CLAQUE_AGENTS_H
#define CLAQUE_AGENTS_H

#include <claque/behave.h>
#include <claque/track.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct clq_stage clq_stage;

/* Machines and agents belong to one stage. {0} is none. The id of a removed agent is STALE_ID for ever. */
typedef struct clq_machine {
    uint32_t index1;
} clq_machine;

typedef struct clq_agent {
    uint32_t index1;
} clq_agent;

/* A text in TOML: a file, or bytes in memory. */
typedef struct clq_stage_text {
    const char *path;  /* of a regular file, at most 4 MiB; NULL: `text` */
    const char *text;  /* [text_bytes], not kept */
    size_t text_bytes; /* at most 4 MiB */
    const char *name;  /* of a text in memory, for messages; NULL: "text" */
} clq_stage_text;

CLQ_DEFINE_PLAIN_INIT(clq_stage_text)

/* A call of an action of the host. */
typedef struct clq_action_call {
    clq_agent agent;
    clq_actor actor;
    double time_s;    /* at which the agent acts, on the clock of clq_crowd_update */
    double value;     /* as the machine gives it; 0 without one */
    clq_crowd *crowd; /* for `show`; NULL for `decide` */
} clq_action_call;

/* An action of the host that machines call by name. One of the callbacks may be NULL. What they throw is written to the
 * context's log, and the stage goes on. */
typedef struct clq_action_def {
    uint32_t struct_bytes; /* set by clq_action_def_init */
    const char *name;
    /* Called by clq_stage_step, before the time is shown. Of the stage it may call clq_stage_send and
     * clq_stage_set_variable. */
    void (*decide)(void *user, const clq_action_call *call);
    /* Called by clq_stage_apply when the time is shown. It may change the crowd. */
    void (*show)(void *user, const clq_action_call *call);
    void *user;
} clq_action_def;

CLQ_DEFINE_ZERO_INIT(clq_action_def)

/* Adds an action of the host, for machines that are added later. Copied.
 * Fails: STRUCT_SIZE, ARGUMENT (no callback, a name that is empty or taken), OUT_OF_MEMORY. */
CLQ_API clq_status clq_stage_add_action(clq_stage *stage, const clq_action_def *def);

typedef struct clq_machine_def {
    uint32_t struct_bytes; /* set by clq_machine_def_init */
    clq_stage_text source;
    /* Templates of the agents that will run the machine. Each must have every clip, marker and node that the machine
     * names. They must live as long as the stage. */
    uint32_t template_count;              /* 1 or more */
    const clq_template *const *templates; /* [template_count], each once */
    /* [template_count] what agents of the templates walk with, each NULL for those that do not; or NULL: none walks.
     * They must live as long as the stage. */
    const clq_locomotion *const *locomotions;
} clq_machine_def;

CLQ_DEFINE_ZERO_INIT(clq_machine_def)

/* Reads a state machine. A text that breaks a rule is refused with its name, line, column and the rule.
 * Fails: STRUCT_SIZE, ARGUMENT, IO, FORMAT, LIMIT (numbers of states, variables, actions: docs/stage.md),
 * OUT_OF_MEMORY. */
CLQ_API clq_status clq_stage_add_machine(clq_stage *stage, const clq_machine_def *def, clq_machine *out);

typedef struct clq_agent_def {
    uint32_t struct_bytes; /* set by clq_agent_def_init */
    clq_machine machine;
    clq_actor actor;          /* of the crowd that clq_stage_apply gets; {0, 0}: it decides, but shows nothing */
    const clq_template *tmpl; /* of the actor; one of the machine's */
    const char *agent_class;  /* for events and searches; NULL: "" */
    uint64_t seed;            /* of its random choices, with the stage's seed; equal seeds give twins */
    double position[3];       /* world units */
    float heading_rad;        /* as in claque/track.h */
    float scale;              /* (> 0) of the actor's transform. Default 1 */
    clq_mechanism gaze;       /* that turns its eyes; attached to the actor already. {0}: it does not look */
    double start_s;           /* when it enters its first state; a time that is decided counts as the next tick */
} clq_agent_def;

static inline clq_agent_def clq_agent_def_init(void)
{
    clq_agent_def def;
    memset(&def, 0, sizeof def);
    def.struct_bytes = (uint32_t)sizeof def;
    def.scale = 1.0f;
    return def;
}

/* Adds an agent. An agent in view runs its tasks in the priority classes that the machine names, any other one class
 * lower; it counts as in view until clq_stage_tell_view says otherwise.
 * Fails: STRUCT_SIZE, ARGUMENT, LIMIT (16 million agents; tasks: claque/stage.h), OUT_OF_MEMORY. */
CLQ_API clq_status clq_stage_add_agent(clq_stage *stage, const clq_agent_def *def, clq_agent *out);

/* Removes an agent. Its actor stays and shows what it was told so far. Fails: STALE_ID, OUT_OF_MEMORY. */
CLQ_API clq_status clq_stage_remove_agent(clq_stage *stage, clq_agent agent);

/* Says where an agent is that does not walk, for distances and radii. The host moves its actor.
 *   position   finite, in world units
 * Fails: STALE_ID, ARGUMENT. */
CLQ_API clq_status clq_stage_set_place(clq_stage *stage, clq_agent agent, const double position[3]);

typedef struct clq_agent_info {
    uint32_t struct_bytes; /* set by clq_agent_info_init */
    clq_actor actor;
    const char *state;    /* the innermost state that it is in; valid as long as the stage. "" before its first one */
    uint32_t depth;       /* number of states that it is in */
    double entered_s;     /* when it entered the innermost one */
    uint64_t transitions; /* so far */
    double position[3];   /* at the time decided, world units */
    bool in_view;
    bool walks; /* it is on its way */
} clq_agent_info;

CLQ_DEFINE_ZERO_INIT(clq_agent_info)

/* Gets the state of an agent.
 *   out   made by clq_agent_info_init
 * Fails: STRUCT_SIZE, STALE_ID, ARGUMENT. */
CLQ_API clq_status clq_stage_get_agent(const clq_stage *stage, clq_agent agent, clq_agent_info *out);

/* An event for one agent, or for all agents that fulfil each condition that is given. */
typedef struct clq_stage_event {
    uint32_t struct_bytes; /* set by clq_stage_event_init */
    const char *name;      /* an event that a machine declares, or "arrived", "blocked", "seen", "unseen" */
    double at_s;           /* when it happens; a time that is decided counts as the next tick, and as late */
    double value;          /* `value` in conditions. Finite */
    clq_agent to;          /* {0}: not one agent alone */
    clq_agent sender;      /* {0}: none. It does not get the event itself */
    const char *to_class;  /* agents of this class; NULL: of any */
    float radius_m;        /* agents within this distance of `position`; 0: anywhere */
    double position[3];    /* where it happens, world units; `distance` in conditions is measured from here */
    float delay_s_per_m;   /* [>= 0] it spreads: an agent gets it so much later for each metre from `position` */
} clq_stage_event;

CLQ_DEFINE_ZERO_INIT(clq_stage_event)

/* Sends an event. Events of one time arrive in an order that depends on their contents, never on the threads that sent
 * them. Fails: STRUCT_SIZE, STALE_ID, ARGUMENT, LIMIT (as many messages wait as may: claque/stage.h), OUT_OF_MEMORY.
 * Threads: any. */
CLQ_API clq_status clq_stage_send(clq_stage *stage, const clq_stage_event *event);

/* Sets a variable of an agent, or one of the crowd.
 *   agent   {0}: a variable of the crowd
 *   value   finite; of a variable that is true or false: 0 or 1
 *   at_s    when it changes; a time that is decided counts as the next tick
 * Fails: STALE_ID, ARGUMENT (a name that is not declared), LIMIT (as clq_stage_send), OUT_OF_MEMORY. Threads: any. */
CLQ_API clq_status clq_stage_set_variable(clq_stage *stage, clq_agent agent, const char *name, double value,
                                          double at_s);

/* Gets a variable at the time decided.
 *   agent   {0}: a variable of the crowd
 * Fails: STALE_ID, ARGUMENT (a name that is not declared). */
CLQ_API clq_status clq_stage_get_variable(const clq_stage *stage, clq_agent agent, const char *name, double *out);

/* Tells the stage that agents have come into view or left it. Those that changed get the event "seen" or "unseen".
 *   agents, in_view   [count]
 *   at_s              when they did; a time that is decided counts as the next tick
 * Fails: STALE_ID, ARGUMENT, LIMIT (as clq_stage_send), OUT_OF_MEMORY. Threads: any. */
CLQ_API clq_status clq_stage_tell_view(clq_stage *stage, const clq_agent *agents, const bool *in_view, uint32_t count,
                                       double at_s);

/* Adds a timetable of events (docs/stage.md).
 *   offset_s   seconds that are added to its times
 * Fails: ARGUMENT, IO, FORMAT, LIMIT, OUT_OF_MEMORY. */
CLQ_API clq_status clq_stage_add_timetable(clq_stage *stage, const clq_stage_text *source, double offset_s);

#ifdef __cplusplus
}
#endif

#endif
