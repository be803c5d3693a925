#include "writers.h"

#ifdef CLAQUE_HAS_SQLITE3
#include <sqlite3.h>
#endif
#ifdef CLAQUE_HAS_Z
#include <zlib.h>
#endif

#include <cstdio>

#include "lib/base/error.h"

namespace claque::testing
{

using base::text_of;

namespace
{

constexpr int first_frame = 10, frames = 11, people = 2;

double x_of(int person, int frame) { return person == 0 ? 0.2 * (frame - first_frame) : 2; }
double y_of(int person, int frame) { return person == 0 ? 1 : 3 - 0.1 * (frame - first_frame); }

// A line for each person and frame, people in the outer loop or in the inner one.
template <class Line>
std::string by_person(const Line &line)
{
    std::string out;
    for (int p = 0; p < people; ++p)
        for (int f = first_frame; f < first_frame + frames; ++f) out += line(p, f, x_of(p, f), y_of(p, f));
    return out;
}
template <class Line>
std::string by_frame(const Line &line)
{
    std::string out;
    for (int f = first_frame; f < first_frame + frames; ++f)
        for (int p = 0; p < people; ++p) out += line(p, f, x_of(p, f), y_of(p, f));
    return out;
}

std::string petrack_text(double units)
{
    return by_person([=](int p, int f, double x, double y) {
        return text_of("%d %d %.4f %.4f %.2f\n", p + 1, f, units * x, units * y, units * 1.75);
    });
}

std::string obsmat_text()
{
    return by_frame([](int p, int f, double x, double y) {
        return text_of("   %.6e   %.6e   %.6e   0.0e+00   %.6e   0.0e+00   0.0e+00   0.0e+00\n", 6.0 * f, p + 1.0, x,
                       y);
    });
}

#ifdef CLAQUE_HAS_EXPAT
std::string fcd_text(bool riders_inside)
{
    std::string out =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- options: <?xml version=\"1.0\"?> <x/> -->\n<fcd-export>\n";
    for (int f = first_frame; f < first_frame + frames; ++f) {
        out += text_of("<timestep time=\"%.2f\">\n<vehicle id=\"car\" x=\"9.00\" y=\"%d.00\" angle=\"0\" speed=\"5\">",
                       0.2 * f, f);
        if (riders_inside) out += text_of("<person id=\"rider\" x=\"9.00\" y=\"%d.00\" angle=\"0\" speed=\"5\"/>", f);
        out += "</vehicle>\n<container id=\"box\" x=\"1\" y=\"1\"/>\n";
        for (int p = 0; p < people; ++p)
            out += text_of("<person id=\"%d\" x=\"%.2f\" y=\"%.2f\" angle=\"%d\" speed=\"1\" pos=\"1\"/>\n", p + 1,
                           x_of(p, f), y_of(p, f), p == 0 ? 90 : 180);
        out += "</timestep>\n";
    }
    return out + "<timestep time=\"99.00\"/>\n</fcd-export>\n";
}
#endif

std::string vadere_text()
{
    std::string out =
        "#IDXCOL=2,DATACOL=6,SEP=' '\npedestrianId simTime endTime-PID7 startX-PID7 startY-PID7 "
        "endX-PID7 endY-PID7 targetId-PID2\n";
    for (int f = first_frame; f + 1 < first_frame + frames; ++f)
        for (int p = 0; p < people; ++p)
            out += text_of("%d %.1f %.1f %.4f %.4f %.4f %.4f 8\n", p + 1, 0.2 * f, 0.2 * (f + 1), x_of(p, f),
                           y_of(p, f), x_of(p, f + 1), y_of(p, f + 1));
    return out;
}

std::string pathfinder_text()
{
    return "\xef\xbb\xbf\"t\",\"id\",\"name\",\"active\",\"x\",\"y\",\"z\",\"v\"\r\n\"s\",\"\",\"\",\"\",\"m\",\"m\","
           "\"m\",\"m/s\"\r\n" +
           by_frame([](int p, int f, double x, double y) {
               return text_of("%.6f,%d,\"0000%d, a\",1,%.6f,%.6f,0.000000,1.0\r\n", 0.2 * f, p + 1, p, x, y);
           });
}

std::string pathfinder_json_text()
{
    std::string out;
    for (int p = 0; p < people; ++p) {
        out += text_of("%s\"%d\": {", p ? ", " : "{", p + 1);
        // As texts, "10.0" comes before "2.0".
        for (int f = first_frame + frames - 1; f >= first_frame; --f)
            out += text_of(
                "\"%.1f\": {\"name\": \"0\", \"isActive\": true, \"tagsApplied\": [[{\"x\": 7}], 4], "
                "\"velocity\": {\"x\": 9, \"y\": 9}, \"position\": {\"x\": %.4f, \"y\": %.4f, \"z\": 0}, "
                "\"distance\": 1}%s",
                0.2 * f, x_of(p, f), y_of(p, f), f == first_frame ? "}" : ", ");
    }
    return out + "}";
}

std::string crowdit_text()
{
    return "time,pedID,posX,posY\n" + by_frame([](int p, int f, double x, double y) {
               return text_of("%.2f,%d,%.2f,%.2f\n", 0.2 * f, p + 1, x, y);
           });
}

std::string viswalk_text()
{
    return "\xef\xbb\xbf$VISION\r\n* File: a \xe2\x80\x99\r\n* NO: "
           "No;x\r\n*\r\n$PEDESTRIAN:NO;SIMSEC;MOTIONSTATE;COORDCENTX;"
           "COORDCENTY;ORIENTATIONANGLE;SPEED\r\n" +
           by_frame([](int p, int f, double x, double y) {
               return text_of("%d;%.2f;Walking on level;%.4f;%.4f;%s;\r\n", p + 1, 0.2 * f, x, y,
                              p == 0 ? "0.00" : "270.00");
           });
}

std::string vsp_text()
{
    // Straight lines: two control points a person, 2 s of 50 frames. Pixels of a centimetre.
    return "2 - the number of splines\n"
           "2 - Num of control points\n"
           "0.0 100.0 50 -90.0 - (2D point, m_id)\n200.0 100.0 100 270 - (2D point, m_id)\n"
           "2 - Num of control points\n"
           "200 300 50 180 - (2D point, m_id)\n200 200 100 -180 - (2D point, m_id)\n"
           "1 - number of line obstacles\n0 0 1 1 0 - left(0,0) right(1,1), 0\n";
}

std::string trajnet_text()
{
    return "{\"scene\": {\"id\": 0, \"p\": 1, \"s\": 60, \"e\": 180, \"fps\": 5.0, \"tag\": [3, [2]]}}\n" +
           by_frame([](int p, int f, double x, double y) {
               return text_of("{\"track\": {\"f\": %d, \"p\": %d, \"x\": %.2f, \"y\": %.2f}}\n", 6 * f, p + 1, x, y);
           }) +
           "{\"track\": {\"f\": 66, \"p\": 1, \"x\": 0, \"y\": 0, \"prediction_number\": 0, \"scene_id\": 0}}";
}

std::string table_text()
{
    return "who;nothing;heading;y;t;x;z\n" + by_frame([](int p, int f, double x, double y) {
               return text_of("%d;text;%s;%.2f;%.2f;%.2f;0\n", p + 1, p == 0 ? "360" : "-90", 100 * y, 0.2 * f,
                              100 * x);
           });
}

}  // namespace

std::vector<std::string> jupedsim_statements(int version)
{
    const bool oriented = version < 3;
    std::vector<std::string> out{
        "CREATE TABLE metadata(key TEXT NOT NULL UNIQUE PRIMARY KEY, value TEXT NOT NULL)",
        text_of("INSERT INTO metadata VALUES('version','%d'),('fps','5.0'),('xmin','0.0')", version),
        text_of("CREATE TABLE trajectory_data(frame INTEGER NOT NULL, id INTEGER NOT NULL, pos_x REAL NOT NULL, "
                "pos_y REAL NOT NULL%s)",
                oriented ? ", ori_x REAL NOT NULL, ori_y REAL NOT NULL" : ""),
        "CREATE INDEX frame_id_idx ON trajectory_data(frame, id)"};
    const char *area = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 2, 1.5 2, 1.5 2.5, 1 2.5, 1 2))";
    if (version == 1) {
        out.push_back("CREATE TABLE geometry(wkt TEXT NOT NULL)");
        out.push_back(text_of("INSERT INTO geometry VALUES('%s')", area));
    } else {
        out.push_back("CREATE TABLE geometry(wkt TEXT NOT NULL, hash INTEGER NOT NULL DEFAULT 0)");
        out.push_back(text_of("INSERT INTO geometry VALUES('POLYGON EMPTY', 3),('%s', -8)", area));
        out.push_back("CREATE TABLE frame_data(frame INTEGER NOT NULL, geometry_hash INTEGER NOT NULL)");
        out.push_back(text_of("INSERT INTO frame_data VALUES(%d, 3),(%d, -8)", first_frame + 1, first_frame));
    }
    std::string rows = by_frame([=](int p, int f, double x, double y) {
        const char *ori = f == first_frame ? ", 0, 0" : p == 0 ? ", 1, 0" : ", 0, -1";
        return text_of("(%d, %d, %.4f, %.4f%s),", f, p + 1, x, y, oriented ? ori : "");
    });
    rows.pop_back();
    out.push_back("INSERT INTO trajectory_data VALUES" + rows);
    return out;
}

#ifdef CLAQUE_HAS_SQLITE3
Bytes database_of(const std::vector<std::string> &statements)
{
    sqlite3 *handle = nullptr;
    EXPECT_EQ(sqlite3_open(":memory:", &handle), SQLITE_OK);
    for (const std::string &statement : statements) {
        char *error = nullptr;
        EXPECT_EQ(sqlite3_exec(handle, statement.c_str(), nullptr, nullptr, &error), SQLITE_OK)
            << statement.substr(0, 100) << ": " << (error ? error : "");
    }
    sqlite3_int64 size = 0;
    unsigned char *bytes = sqlite3_serialize(handle, "main", &size, 0);
    const Bytes out(bytes, bytes + size);
    sqlite3_free(bytes);
    sqlite3_close(handle);
    return out;
}
#else
Bytes database_of(const std::vector<std::string> &) { return {}; }
#endif

#ifdef CLAQUE_HAS_Z
Bytes packed(const Bytes &bytes)
{
    z_stream stream{};
    EXPECT_EQ(deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 9, Z_DEFAULT_STRATEGY), Z_OK);
    Bytes out(deflateBound(&stream, bytes.size()) + 32);
    stream.next_in = const_cast<Bytef *>(bytes.data()), stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = out.data(), stream.avail_out = static_cast<uInt>(out.size());
    EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
    out.resize(stream.total_out);
    deflateEnd(&stream);
    return out;
}
#else
Bytes packed(const Bytes &bytes) { return bytes; }
#endif

std::vector<Written> written_files()
{
    const auto text = [](const std::string &t) { return Bytes(t.begin(), t.end()); };
    const asset::TrajectoryOptions none;
    asset::TrajectoryOptions archive, film, table;
    archive.rate_hz = 5, archive.metres_per_unit = 0.01;
    film.metres_per_unit = 0.01;
    table.columns = "id,-,heading,y,time,x,z", table.metres_per_unit = 0.01, table.up = CLQ_UP_Z;
    std::vector<Written> out{
        {"petrack.txt", CLQ_TRAJECTORY_PETRACK,
         text("# PeTrack project: a\n# framerate: 5 fps\n# id frame x/cm y/cm z/cm\n" + petrack_text(100)), none, 2,
         0.2, false, 11},
        {"archive.txt", CLQ_TRAJECTORY_PETRACK, text(petrack_text(100)), archive, 2, 0.2, false, 11},
        {"report.txt", CLQ_TRAJECTORY_JPSREPORT,
         text("#description: a\n#framerate: 5\n#geometry: g.xml\n#ID: the agent ID\n\n#ID\tFR\tX\tY\tZ\n" +
              petrack_text(1)),
         none, 2, 0.2, false, 11},
        {"obsmat.txt", CLQ_TRAJECTORY_OBSMAT, text(obsmat_text()), none, 4, 0.4, false, 11},
        {"a.traj", CLQ_TRAJECTORY_VADERE, text(vadere_text()), none, 2, 0.2, false, 11},
        {"pathfinder.csv", CLQ_TRAJECTORY_PATHFINDER_CSV, text(pathfinder_text()), none, 2, 0.2, false, 11},
        {"pathfinder.json", CLQ_TRAJECTORY_PATHFINDER_JSON, text(pathfinder_json_text()), none, 2, 0.2, false, 11},
        {"crowdit.csv", CLQ_TRAJECTORY_CROWDIT, text(crowdit_text()), none, 2, 0.2, false, 11},
        {"viswalk.pp", CLQ_TRAJECTORY_VISWALK, text(viswalk_text()), none, 2, 0.2, true, 11},
        {"a.vsp", CLQ_TRAJECTORY_VSP, text(vsp_text()), film, 2, 2, true, 2},
        {"a.ndjson", CLQ_TRAJECTORY_TRAJNET, text(trajnet_text()), none, 2, 0.2, false, 11},
        {"table.csv", CLQ_TRAJECTORY_TABLE, text(table_text()), table, 2, 0.2, true, 11},
    };
#ifdef CLAQUE_HAS_EXPAT
    out.push_back({"a.fcd.xml", CLQ_TRAJECTORY_SUMO, text(fcd_text(false)), none, 2, 0.2, true, 11});
    out.push_back({"rider.fcd.xml", CLQ_TRAJECTORY_SUMO, text(fcd_text(true)), none, 2, 0.2, true, 11});
#endif
#if defined CLAQUE_HAS_EXPAT && defined CLAQUE_HAS_Z
    out.push_back({"a.fcd.xml.gz", CLQ_TRAJECTORY_SUMO, packed(text(fcd_text(false))), none, 2, 0.2, true, 11});
#endif
#ifdef CLAQUE_HAS_Z
    out.push_back({"crowdit.csv.gz", CLQ_TRAJECTORY_CROWDIT, packed(text(crowdit_text())), none, 2, 0.2, false, 11});
#endif
#ifdef CLAQUE_HAS_SQLITE3
    for (const int version : {1, 2, 3})
        out.push_back({"a.sqlite", CLQ_TRAJECTORY_JUPEDSIM, database_of(jupedsim_statements(version)), none, 2, 0.2,
                       version < 3, 11});
#endif
    return out;
}

}  // namespace claque::testing
