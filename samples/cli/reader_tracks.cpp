// Trajectories for `claque bench readers`.
#include <claque/trajectories.h>

#include "samples/cli/reader_parts.h"

namespace cli
{
namespace track_readers
{
namespace
{

const char *const petrack_head = "# PeTrack project: a\n# framerate: 5 fps\n# id frame x/cm y/cm z/cm\n";

// Where a person that walks to and fro is.
std::string walked(uint32_t i) { return digits(i % 100) + "." + digits(i % 7); }

std::string petrack_rows(uint32_t count)
{
    return repeated(petrack_head, count, [](uint32_t i) { return "1 " + digits(i) + " " + walked(i) + " 0 175\n"; });
}

std::string petrack_people(uint32_t count)
{
    return repeated(petrack_head, count, [](uint32_t i) { return digits(i + 1) + " 3 " + walked(i) + " 0 175\n"; });
}

// Each after a gap that begins a new person.
std::string petrack_gaps(uint32_t count)
{
    return repeated(petrack_head, count, [](uint32_t i) { return "1 " + digits(100 * i) + " 0 0 175\n"; });
}

// The last row of the file is the first of its person.
std::string petrack_disordered(uint32_t count)
{
    return repeated(petrack_head, count,
                    [=](uint32_t i) { return "1 " + digits(count - i) + " " + walked(i) + " 0 175\n"; });
}

std::string petrack_comments(uint32_t count)
{
    return repeated(petrack_rows(2), count, [](uint32_t i) { return "# " + digits(i) + "\n"; });
}

std::string jpsreport_rows(uint32_t count)
{
    return repeated("#framerate: 5\n#ID\tFR\tX\tY\n", count,
                    [](uint32_t i) { return "1\t" + digits(i) + "\t" + walked(i) + "\t0\n"; });
}

const char *const table_head = "# a table\n";

std::string table_rows(uint32_t count)
{
    return repeated(table_head, count, [](uint32_t i) { return "1;" + digits(i) + ";" + walked(i) + ";0\n"; });
}

std::string obsmat_rows(uint32_t count)
{
    return repeated("", count, [](uint32_t i) {
        return digits(6 * (i / 2)) + ".0 " + digits(i % 2) + ".0 " + walked(i) + " 0.0 1.0 0.0 0.0 0.0\n";
    });
}

std::string vadere_steps(uint32_t count)
{
    return repeated(
        "#IDXCOL=2,DATACOL=6,SEP=' '\npedestrianId simTime endTime-PID7 startX-PID7 startY-PID7 endX-PID7 endY-PID7\n",
        count, [](uint32_t i) {
            return "1 " + digits(i) + ".0 " + digits(i + 1) + ".0 " + digits(i % 2) + " 0 " + digits((i + 1) % 2) +
                   " 0\n";
        });
}

std::string pathfinder_rows(uint32_t count)
{
    return repeated("\"t\",\"id\",\"x\",\"y\",\"z\"\n", count,
                    [](uint32_t i) { return digits(i) + ".0,1," + digits(i % 9) + ".0,0.0,0.0\n"; });
}

std::string pathfinder_columns(uint32_t count)
{
    const std::string more = repeated("", count, [](uint32_t) { return ",0"; });
    return repeated(
               "\"t\",\"id\",\"x\",\"y\",\"z\"", count, [](uint32_t i) { return ",\"c" + digits(i) + "\""; }, "\n") +
           "0.0,1,0.0,0.0,0.0" + more + "\n1.0,1,1.0,0.0,0.0" + more + "\n";
}

std::string json_time(uint32_t i)
{
    return "\"" + digits(i) + ".0\": {\"position\": {\"x\": " + digits(i % 9) + ", \"y\": 0, \"z\": 0}}";
}

std::string json_times(uint32_t count)
{
    return repeated(
        "{\"1\": {", count, [](uint32_t i) { return (i ? ", " : "") + json_time(i); }, "}}");
}

std::string json_people(uint32_t count)
{
    return repeated(
        "{", count, [](uint32_t i) { return (i ? ", \"" : "\"") + digits(i) + "\": {" + json_time(i % 9) + "}"; }, "}");
}

std::string crowdit_rows(uint32_t count)
{
    return repeated("time,pedID,posX,posY\n", count,
                    [](uint32_t i) { return digits(i) + ".0,1," + digits(i % 9) + ".0,0.0\n"; });
}

std::string viswalk_rows(uint32_t count)
{
    return repeated("$VISION\n$PEDESTRIAN:NO;SIMSEC;COORDCENTX;COORDCENTY\n", count,
                    [](uint32_t i) { return "1;" + digits(i) + ".0;" + digits(i % 9) + ".0;0.0\n"; });
}

std::string control_points(uint32_t count)
{
    const std::string points =
        repeated("", count, [](uint32_t i) { return digits(i % 9) + " 100 " + digits(10 * i) + " 0\n"; });
    return "1 - the number of splines\n" + digits(count) + " - Num of control points\n" + points;
}

std::string splines(uint32_t count)
{
    return repeated(digits(count) + " - the number of splines\n", count,
                    [](uint32_t) { return std::string("2 - Num of control points\n0 100 50 0\n20 100 100 0\n"); });
}

std::string trajnet_rows(uint32_t count)
{
    return repeated("{\"scene\": {\"id\": 0, \"p\": 1, \"s\": 0, \"e\": 9, \"fps\": 5.0}}\n", count, [](uint32_t i) {
        return "{\"track\": {\"f\": " + digits(i) + ", \"p\": 1, \"x\": " + digits(i % 9) + ", \"y\": 0}}\n";
    });
}

std::string sumo_person(uint32_t id, uint32_t x)
{
    return "<person id=\"" + digits(id) + "\" x=\"" + digits(x) + ".0\" y=\"0\" angle=\"90\"/>";
}

std::string sumo_times(uint32_t count)
{
    return repeated(
        "<fcd-export>", count,
        [](uint32_t i) { return "<timestep time=\"" + digits(i) + "\">" + sumo_person(1, i % 9) + "</timestep>"; },
        "</fcd-export>");
}

std::string sumo_people(uint32_t count)
{
    return repeated(
        "<fcd-export><timestep time=\"0\">", count, [](uint32_t i) { return sumo_person(i, i % 9); },
        "</timestep></fcd-export>");
}

std::string sumo_attributes(uint32_t count)
{
    return repeated(
        "<fcd-export><timestep time=\"0\">" + sumo_person(1, 1) + "<container", count,
        [](uint32_t i) { return " a" + digits(i) + "=\"1\""; }, "/></timestep></fcd-export>");
}

Reading read_tracks(scenes::Library &library, const std::string &bytes)
{
    return timed([&] {
        clq_trajectories_def def = clq_trajectories_def_init();
        const bool is_vsp = bytes.find("splines") < 60;  // whose units are pixels
        if (is_vsp) def.metres_per_unit = 0.01;
        if (bytes.rfind(table_head, 0) == 0) def.columns = "id,frame,x,y", def.rate_hz = 5, def.metres_per_unit = 1;
        clq_trajectories *made = nullptr;
        const clq_status status = clq_trajectories_load_memory(library.context(), bytes.data(), bytes.size(),
                                                               is_vsp ? "a.vsp" : nullptr, &def, &made);
        clq_trajectories_destroy(made);
        return outcome_of(status);
    });
}

}  // namespace
}  // namespace track_readers

std::vector<ReaderElement> reader_elements_of_tracks()
{
    using namespace track_readers;
    return {{"tracks", "rows of PeTrack", most_elements, petrack_rows, read_tracks},
            {"tracks", "people of PeTrack", most_elements, petrack_people, read_tracks},
            {"tracks", "gaps of one person", most_elements, petrack_gaps, read_tracks},
            {"tracks", "rows out of order", most_elements, petrack_disordered, read_tracks},
            {"tracks", "lines of comment", most_elements, petrack_comments, read_tracks},
            {"tracks", "rows of JPSreport", most_elements, jpsreport_rows, read_tracks},
            {"tracks", "rows of a table", most_elements, table_rows, read_tracks},
            {"tracks", "rows of ETH", most_elements, obsmat_rows, read_tracks},
            {"tracks", "steps of Vadere", most_elements, vadere_steps, read_tracks},
            {"tracks", "rows of Pathfinder", most_elements, pathfinder_rows, read_tracks},
            {"tracks", "columns of Pathfinder", most_elements, pathfinder_columns, read_tracks},
            {"tracks", "times of Pathfinder's JSON", most_elements, json_times, read_tracks},
            {"tracks", "people of Pathfinder's JSON", most_elements, json_people, read_tracks},
            {"tracks", "rows of crowd:it", most_elements, crowdit_rows, read_tracks},
            {"tracks", "rows of Viswalk", most_elements, viswalk_rows, read_tracks},
            {"tracks", "control points of a spline", most_elements, control_points, read_tracks},
            {"tracks", "splines", most_elements, splines, read_tracks},
            {"tracks", "rows of TrajNet++", most_elements, trajnet_rows, read_tracks},
            {"tracks", "times of SUMO", most_elements, sumo_times, read_tracks},
            {"tracks", "people of SUMO", most_elements, sumo_people, read_tracks},
            {"tracks", "attributes of SUMO", 10000, sumo_attributes, read_tracks}};
}

}  // namespace cli
