/* Trajectories: where people walked, time by time, as the files of pedestrian simulators and trackers give it, and the
 * areas that people can walk on (libclaque-assets). docs/trajectories.md lists the formats. */
#ifndef CLAQUE_TRAJECTORIES_H
#define CLAQUE_TRAJECTORIES_H

#include <claque/context.h>

#include <math.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The trajectories of one file, in metres, z up. It never changes after loading; any thread may read it. */
typedef struct clq_trajectories clq_trajectories;

typedef enum clq_trajectory_format {
    CLQ_TRAJECTORY_AUTO = 0,           /* by content, then by name */
    CLQ_TRAJECTORY_JUPEDSIM = 1,       /* SQLite of JuPedSim, versions 1 to 3 */
    CLQ_TRAJECTORY_PETRACK = 2,        /* text of PeTrack and of the archive in Jülich: id frame x y z */
    CLQ_TRAJECTORY_JPSREPORT = 3,      /* text of JPSreport: the same columns, in metres */
    CLQ_TRAJECTORY_SUMO = 4,           /* floating car data of SUMO: XML, plain or gzip */
    CLQ_TRAJECTORY_VADERE = 5,         /* foot steps of Vadere */
    CLQ_TRAJECTORY_PATHFINDER_CSV = 6, /* Pathfinder: t, id, x, y, z by name */
    CLQ_TRAJECTORY_PATHFINDER_JSON = 7,
    CLQ_TRAJECTORY_CROWDIT = 8,  /* crowd:it: time, pedID, posX, posY by name, plain or gzip */
    CLQ_TRAJECTORY_VISWALK = 9,  /* Viswalk: NO, SIMSEC, COORDCENTX, COORDCENTY by name */
    CLQ_TRAJECTORY_OBSMAT = 10,  /* ETH and UCY: frame id x z y vx vz vy */
    CLQ_TRAJECTORY_VSP = 11,     /* UCY: control points in the pixels of a film */
    CLQ_TRAJECTORY_TRAJNET = 12, /* TrajNet++: a JSON object a line */
    CLQ_TRAJECTORY_TABLE = 13    /* any table, by clq_trajectories_def.columns */
} clq_trajectory_format;

/* The coordinate of a file that points up. */
typedef enum clq_up_axis { CLQ_UP_OF_FILE = 0, CLQ_UP_Z = 1, CLQ_UP_Y = 2 } clq_up_axis;

typedef struct clq_trajectories_def {
    uint32_t struct_bytes; /* set by clq_trajectories_def_init */
    clq_trajectory_format format;
    /* The columns of a table from left to right, by names with commas between: id, frame or time, x, y, z, heading;
     * - passes over a column. time is in seconds, heading in degrees, counter-clockwise from +x. Blanks,
     * tabs, commas or semicolons separate columns; the first row of numbers decides. NULL: the format knows. */
    const char *columns;
    /* [0, 1e6] frame numbers in a second. 0: the file says it, or the load is refused. Files with times ignore it. */
    double rate_hz;
    /* [0, 1e6] metres in a unit of the file's coordinates. 0: the file or its format says it, or the load is refused.
     * For CLQ_TRAJECTORY_VSP: metres in a pixel, where there is no picture_to_metres. */
    double metres_per_unit;
    /* A table of three coordinates does not say which one is up, and is refused without this. With CLQ_UP_Y, (x, y, z)
     * becomes (x, -z, y). */
    clq_up_axis up;
    /* SUMO: read vehicles too, and people while they ride in one. false: these rows are left out with a warning. */
    bool vehicles;
    /* [9] rows of a matrix from (row, column, 1) of the film to metres, for CLQ_TRAJECTORY_VSP. NULL: H.txt beside the
     * file, else metres_per_unit. */
    const double *picture_to_metres;
    /* (> 0) a step to the next sample that is faster than this starts a new person there. Default 12; INFINITY: no
     * step does. */
    double max_speed_m_s;
    /* [0, INFINITY] a gap between two samples that is longer than this starts a new person. 0: 2.5 s, or 4 times the
     * file's usual step where that is longer. Foot steps and control points have no gaps. */
    double max_gap_s;
    /* Samples outside [start_s, end_s] of the file's time are left out. Default: -INFINITY, INFINITY. */
    double start_s, end_s;
    uint64_t memory_limit_bytes; /* 0: 4 GiB */
} clq_trajectories_def;

static inline clq_trajectories_def clq_trajectories_def_init(void)
{
    clq_trajectories_def def;
    memset(&def, 0, sizeof def);
    def.struct_bytes = (uint32_t)sizeof def;
    def.max_speed_m_s = 12;
    def.start_s = -HUGE_VAL;
    def.end_s = HUGE_VAL;
    return def;
}

/* Bits of clq_trajectory_sample.flags. */
#define CLQ_TRAJECTORY_VEHICLE 1u /* of a vehicle, not of a person */
#define CLQ_TRAJECTORY_RIDES 2u   /* of a person in a vehicle */

/* Where a person is at a time. Metres, z up. z is 0 in files of the plane. */
typedef struct clq_trajectory_sample {
    double time_s; /* of the file, or frame number / rate */
    double x, y, z;
    float heading_rad; /* counter-clockwise from +x, (-pi, pi]; NaN where the file has none */
    uint32_t flags;
} clq_trajectory_sample;

/* Load a file of trajectories. Coordinates, times and headings are what the file has, only converted: nothing is
 * smoothed or filled in. The samples of a person are put in order of time; of several rows of a person at one time the
 * first is kept; rows with a missing, infinite or impossible number are left out. A gap longer than max_gap_s and a
 * step faster than max_speed_m_s start a new person, whose id ends in #2, #3 and so on. Each of these gives a
 * warning. A rate, unit or axis that is missing is refused with the member's name and the option of
 * the claque command.
 *   path    a regular file; H.txt may stand beside it
 *   name    of bytes in memory: messages use it and AUTO reads its ending; may be NULL
 *   def     NULL means clq_trajectories_def_init()
 *   out     owned by the host until clq_trajectories_destroy
 * A sample takes 40 bytes. While it loads, the call takes at most 64 bytes for each byte of the file, as it is after
 * unpacking, and 16 MB. Unpacked, a gzip file has at most 200 times its bytes and 1 MB.
 * Fail: STRUCT_SIZE, ARGUMENT (a number out of its range; what is missing in the file), FORMAT (line or row, and rule),
 * UNSUPPORTED (a format whose library the build lacks; a database of a later version; geographic degrees), LIMIT
 * (memory_limit_bytes; nesting; an id of more than 256 bytes), IO, OUT_OF_MEMORY. Threads: any. GL: none. */
CLQ_API clq_status clq_trajectories_load(clq_context *context, const char *path, const clq_trajectories_def *def,
                                         clq_trajectories **out);
CLQ_API clq_status clq_trajectories_load_memory(clq_context *context, const void *bytes, size_t size_bytes,
                                                const char *name, const clq_trajectories_def *def,
                                                clq_trajectories **out);

/* Destroys trajectories; NULL is ignored. Threads: any. GL: none. */
CLQ_API void clq_trajectories_destroy(clq_trajectories *trajectories);

typedef struct clq_trajectories_info {
    uint32_t struct_bytes;        /* set by clq_trajectories_info_init */
    clq_trajectory_format format; /* never AUTO */
    uint32_t person_count;
    uint32_t id_count; /* ids in the file: fewer than people where people became several */
    uint64_t sample_count;
    uint64_t row_count;  /* rows of positions in the file, also those that were left out */
    double min_s, max_s; /* times of the first and the last sample */
    double step_s;       /* the usual time between two samples of a person; 0: no person has two */
    double box_min_m[3], box_max_m[3];
    uint32_t most_at_once; /* people between their first and last sample at one time */
    double most_at_once_s; /* the first such time */
    bool has_headings;     /* some sample has one */
    uint32_t warning_count;
} clq_trajectories_info;

/* One person: samples [first_sample, first_sample + sample_count), one or more. */
typedef struct clq_trajectory_person {
    uint32_t struct_bytes; /* set by clq_trajectory_person_init */
    const char *id;        /* UTF-8, as in the file; lives as long as the trajectories */
    uint64_t first_sample, sample_count;
    float height_m; /* of the head over the ground, where the file has it (PeTrack, JPSreport); else NaN */
} clq_trajectory_person;

CLQ_DEFINE_ZERO_INIT(clq_trajectories_info)
CLQ_DEFINE_ZERO_INIT(clq_trajectory_person)

/* Get what was loaded. People are in the order of their first rows in the file.
 *   out   made by its _init function
 * Fail: STRUCT_SIZE, ARGUMENT (NULL, an index that is too large). Threads: any. GL: none. */
CLQ_API clq_status clq_trajectories_get_info(const clq_trajectories *trajectories, clq_trajectories_info *out);
CLQ_API clq_status clq_trajectories_get_person(const clq_trajectories *trajectories, uint32_t person,
                                               clq_trajectory_person *out);

/* Returns all samples, sorted by person, then by time: times of a person ascend strictly. NULL for NULL. The array
 * lives as long as the trajectories. Threads: any. GL: none. */
CLQ_API const clq_trajectory_sample *clq_trajectories_get_samples(const clq_trajectories *trajectories);

/* Returns a warning as one sentence; "" beyond the last one. Equal faults are one warning, with their number and the
 * line or row of the first. Threads: any. GL: none. */
CLQ_API const char *clq_trajectories_get_warning(const clq_trajectories *trajectories, uint32_t warning);

/* A walkable area: polygons with holes in metres, z up, triangles that fill them, and the walls around them. It never
 * changes after loading; any thread may read it. */
typedef struct clq_area clq_area;

/* A closed ring of points: [first_point, first_point + point_count), the first point not repeated. The outer ring of a
 * polygon comes first and runs counter-clockwise seen from above; its holes follow and run clockwise. */
typedef struct clq_area_ring {
    uint32_t polygon;
    uint32_t first_point, point_count;
    bool hole;
} clq_area_ring;

/* Pointers live as long as the area. */
typedef struct clq_area_info {
    uint32_t struct_bytes; /* set by clq_area_info_init */
    uint32_t polygon_count;
    uint32_t ring_count, point_count, triangle_count, wall_count, warning_count;
    const clq_area_ring *rings; /* [ring_count] */
    const double *points_m;     /* [3 * point_count] */
    const uint32_t *triangles;  /* [3 * triangle_count] points, counter-clockwise from above, of the rings' points */
    const uint32_t *walls;      /* [2 * wall_count] points: the ends of a piece of wall */
    double area_m2;             /* of the polygons without their holes, in the plane */
    double box_min_m[3], box_max_m[3]; /* all 0 where there are no points */
} clq_area_info;

CLQ_DEFINE_ZERO_INIT(clq_area_info)

/* Load a walkable area, the content deciding how: WKT (POLYGON, MULTIPOLYGON and GEOMETRYCOLLECTION of these, nested,
 * EMPTY), the geometry of a JuPedSim database (the one of its first frame), geo.xml of JPSreport, a .nav mesh of Menge
 * (a polygon a node, with heights), the topography of a Vadere .scenario. Metres. Walls are the rings, in a mesh its
 * obstacles. Polygons of a file may overlap; each is filled by itself.
 *   name   of bytes in memory, for messages; may be NULL
 *   out    owned by the host until clq_area_destroy
 * Fail: ARGUMENT, FORMAT (place and rule; a ring that crosses itself), UNSUPPORTED (other kinds of WKT; a library that
 * the build lacks), LIMIT (256 MB; 10 000 points of a polygon; 128 collections in each other), IO, OUT_OF_MEMORY.
 * Threads: any. GL: none. */
CLQ_API clq_status clq_area_load(clq_context *context, const char *path, clq_area **out);
CLQ_API clq_status clq_area_load_memory(clq_context *context, const void *bytes, size_t size_bytes, const char *name,
                                        clq_area **out);

/* Destroys an area; NULL is ignored. Threads: any. GL: none. */
CLQ_API void clq_area_destroy(clq_area *area);

/* Gets what an area holds.
 *   out   made by clq_area_info_init
 * Fails: STRUCT_SIZE, ARGUMENT. Threads: any. GL: none. */
CLQ_API clq_status clq_area_get_info(const clq_area *area, clq_area_info *out);

/* Returns a warning as one sentence; "" beyond the last one. Threads: any. GL: none. */
CLQ_API const char *clq_area_get_warning(const clq_area *area, uint32_t warning);

#ifdef __cplusplus
}
#endif

#endif
