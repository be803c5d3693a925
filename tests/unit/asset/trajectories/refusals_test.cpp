// What is refused, and that the sentence says what to do.
#include "fixture.h"

namespace claque::testing
{
namespace
{

TEST(TrajectoryRefusals, WhatTheFileDoesNotSayIsAskedForByOptionAndMember)
{
    const std::string archive = "1 43 79.0 774.0 183\n1 44 79.1 764.5 183\n";
    expect_refused(
        archive, CLQ_ARGUMENT,
        "the file does not say the rate of its frames and the unit of its coordinates: give --rate (rate_hz) "
        "and --unit (metres_per_unit)");
    asset::TrajectoryOptions options;
    options.rate_hz = 16;
    expect_refused(archive, CLQ_ARGUMENT, "does not say the unit of its coordinates: give --unit (metres_per_unit)",
                   options);
    expect_refused("# framerate: 25 fps\n# id frame x y z\n1 0 1 2 3\n", CLQ_OK, "read");
    expect_refused("# PeTrack project\n# framerate: 25 fps\n# id frame x y z\n1 0 1 2 3\n", CLQ_ARGUMENT,
                   "give --unit (metres_per_unit)");
    expect_refused("a 1 2 3 4\n", CLQ_ARGUMENT, "does not say which axis is up: give --up (up)",
                   of_table("id,frame,x,y,z", 1, 1));
    expect_refused("a 1 2 3\n", CLQ_ARGUMENT, "the unit of its coordinates", of_table("id,time,x,y", 0, 0));
    expect_refused("1 5 0 0 0 0 0 0\n2 6 0 0 0 0 0 0\n", CLQ_ARGUMENT, "give --rate (rate_hz)");
    expect_refused("{\"track\": {\"f\": 1, \"p\": 1, \"x\": 0, \"y\": 1}}\n", CLQ_ARGUMENT, "give --rate (rate_hz)");
    expect_refused("1 - the number of splines\n1\n0 0 0 0\n", CLQ_ARGUMENT,
                   "put H.txt beside it, or give --unit (metres_per_unit) or picture_to_metres");
    expect_refused(
        "name,speed\na,3\n", CLQ_ARGUMENT,
        "for a table give --columns id,frame,x,y (columns), --unit m (metres_per_unit) and, unless its times "
        "are in seconds, --rate 25 (rate_hz); the first row is 'name,speed'");
}

TEST(TrajectoryRefusals, OfARecordSayWhatReadsIt)
{
    expect_refused("claqueR\x1a\2", CLQ_ARGUMENT,
                   "record of claque: clq_record_open and Record.load of Python play it");
}

TEST(TrajectoryRefusals, OfAFileWithoutPeopleNameTheOptionThatReadsOthers)
{
    asset::TrajectoryOptions late = of_table("id,time,x,y", 1, 1);
    late.start_s = 100;
    expect_refused("a 1 2 3\n", CLQ_ARGUMENT,
                   "from 100 to inf s: --vehicles (vehicles) reads vehicles too, and start_s and end_s choose", late);
}

TEST(TrajectoryRefusals, ColumnsThatDoNotMakeATableAreNamed)
{
    expect_refused("1 2 3\n", CLQ_ARGUMENT, "has to name id, x, y, and frame or time: 'id,x,y'", of_table("id,x,y"));
    expect_refused("1 2 3\n", CLQ_ARGUMENT, "has to name id, x, y, and frame or time", of_table("id,x,y,frame,time"));
    expect_refused("1 2 3\n", CLQ_ARGUMENT, "names x twice", of_table("id,frame,x,x,y"));
    expect_refused("1 2 3 4 5\n", CLQ_ARGUMENT,
                   "unknown name 'head': id, frame, time, x, y, z and heading are known, - skips a column",
                   of_table("id,frame,x,y,head"));
    expect_refused("1 2 3 4 5\n", CLQ_ARGUMENT, "unknown name ''", of_table("id,frame,x,y,"));
    asset::TrajectoryOptions options;
    options.format = CLQ_TRAJECTORY_TABLE;
    expect_refused("1 2 3\n", CLQ_ARGUMENT, "give --columns id,frame,x,y (columns)", options);
}

TEST(TrajectoryRefusals, RowsThatAreNoneAreNamedByLine)
{
    const asset::TrajectoryOptions table = of_table("id,time,x,y");
    expect_refused("a 1 2 3\na 2 2\na 3 2 3\n", CLQ_FORMAT, "line 2 has 3 columns: 4 are wanted", table);
    expect_refused("a 1 2 3\na 2 two 3\n", CLQ_FORMAT, "line 2, column 3: 'two' instead of a number", table);
    expect_refused("a;1;2,5;3\nb;1;2,5;3\n", CLQ_FORMAT, "line 1, column 3: '2,5' instead of a number", table);
    expect_refused("", CLQ_FORMAT, "the file has no rows");
    expect_refused("", CLQ_FORMAT, "no positions of people, in 0 rows", table);
    expect_refused("# framerate: 0 fps\n1 2 3 4 5\n", CLQ_FORMAT, "line 1 has no rate between 0 and 1e6");
    expect_refused("$VISION\n* nothing\n", CLQ_FORMAT, "no line begins with $PEDESTRIAN:");
    expect_refused("$VISION\n$PEDESTRIAN:NO;SIMSEC;COORDCENTX\n", CLQ_FORMAT, "line 2 names no column COORDCENTY");
    expect_refused("pedestrianId simTime endTime-PID1\n1 2 3\n", CLQ_FORMAT, "the file has no column startX");
    expect_refused("pedestrianId simTime endTime startX startY endX endY\n1 3 2 0 0 0 0\n", CLQ_FORMAT,
                   "line 2: the step ends at 2 s, before it begins at 3 s");
    asset::TrajectoryOptions film;
    film.metres_per_unit = 1;
    expect_refused("2 - the number of splines\n1\n0 0 0 0\n", CLQ_FORMAT,
                   "ends after line 3, where a number of control", film);
    expect_refused("2 - the number of splines\n1\n0 0 0\n", CLQ_FORMAT, "line 3, column 4: '' instead of a number",
                   film);
    expect_refused("1.5 - the number of splines\n", CLQ_FORMAT, "line 1: '1.5' instead of the number of splines", film);
    film.picture_to_metres = std::array<double, 9>{1, 0, 0, 0, 1, 0, 0, 0, 1};
    expect_refused("1 - the number of splines\n1\n0 0 0 0\n", CLQ_ARGUMENT, "one is wanted", film);
    expect_refused(std::string(300, 'a') + " 1 2 3\n", CLQ_LIMIT, "has 300 bytes: 256 are allowed", table);
}

TEST(TrajectoryRefusals, JsonThatIsNoneIsNamedByPlace)
{
    expect_refused("{\"scene\": {\"fps\": 2.5}}\n{\"track\": {\"f\": 1, \"p\": 1, \"x\": \"a\", \"y\": 1}}\n",
                   CLQ_FORMAT, "line 2: ");
    expect_refused("{\"scene\": {\"fps\": 2.5}}\n{\"scene\": {\"fps\": 5}}\n", CLQ_FORMAT,
                   "line 2: fps is 5 here and 2.5 before");
    expect_refused("{\"track\": {\"f\": 1, \"p\": 1, \"x\": 1}}\n", CLQ_FORMAT, "track.y");
    expect_refused("{\"1\": {\"1.0\": {\"position\": {\"x\": 1, \"y\": 2}}", CLQ_FORMAT, "the JSON is broken at byte");
    expect_refused("{\"1\": {\"soon\": {\"position\": {\"x\": 1, \"y\": 2}}}}", CLQ_FORMAT,
                   "entry 1, person '1': the time 'soon' is no number");
    expect_refused("{\"1\": [1, 2]}", CLQ_FORMAT, "an array instead of the times of a person");
    expect_refused("{\"1\": {\"1.0\": 3}}", CLQ_FORMAT, "a number instead of an entry for a time");
    expect_refused("{\"1\": {\"1.0\": {\"position\": {\"y\": 2}}}}", CLQ_FORMAT, "no positions of people, in 1 row");
    asset::TrajectoryOptions options;
    options.format = CLQ_TRAJECTORY_PATHFINDER_JSON;
    expect_refused("[]", CLQ_FORMAT, "an array instead of an object of people", options);
    expect_refused("7", CLQ_FORMAT, "a number instead of an object of people", options);
}

TEST(TrajectoryRefusals, XmlThatIsNotSumosIsNamedByLine)
{
#ifndef CLAQUE_HAS_EXPAT
    expect_refused("<fcd-export/>", CLQ_UNSUPPORTED, "XML is read by libexpat");
    GTEST_SKIP() << "this build has no expat";
#endif
    expect_refused("<routes/>", CLQ_FORMAT, "line 1: the root element is <routes>: <fcd-export> of SUMO is wanted");
    expect_refused("<fcd-export>\n<timestep>", CLQ_FORMAT, "line 2: a timestep has no time");
    expect_refused("<fcd-export><timestep time=\"now\">", CLQ_FORMAT, "a timestep has the time 'now'");
    expect_refused("<fcd-export><timestep time=\"1\">\n<person x=\"1\" y=\"2\"/>", CLQ_FORMAT,
                   "line 2: a person has no id");
    expect_refused("<fcd-export><timestep time=\"1\"><person id=\"p\" x=\"1\"/>", CLQ_FORMAT, "person 'p' has no y");
    expect_refused("<fcd-export>\n<timestep time=\"1\"></fcd-export>", CLQ_FORMAT,
                   "line 2: the XML is broken: mismatched tag");
    expect_refused("<fcd-export/>", CLQ_FORMAT, "no positions of people, in 0 rows");
    expect_refused("<!--\n<fcd-output.geo value=\"true\"/>\n-->\n<fcd-export/>", CLQ_UNSUPPORTED,
                   "geographic degrees: write it without --fcd-output.geo");
    expect_refused("<!-- <fcd-output.geo value=\"false\"/> -->\n<fcd-export/>", CLQ_FORMAT, "no positions of people");
}

TEST(TrajectoryRefusals, DatabasesThatAreNotJuPedSimsAreNamed)
{
    const std::string magic("SQLite format 3\0", 16);
#ifndef CLAQUE_HAS_SQLITE3
    expect_refused(magic, CLQ_UNSUPPORTED, "libsqlite3");
    GTEST_SKIP() << "this build has no sqlite3";
#endif
    expect_refused(magic, CLQ_FORMAT, "the database cannot be read");
    const auto refused = [](std::vector<std::string> statements, size_t changed, const std::string &statement) {
        statements[changed] = statement;
        return refusal_of(database_of(statements));
    };
    const std::vector<std::string> good = jupedsim_statements(2);
    const auto expect = [](const Refusal &refusal, int status, const char *sentence) {
        EXPECT_EQ(refusal.status, status) << refusal.text;
        EXPECT_NE(refusal.text.find(sentence), std::string::npos) << refusal.text;
    };
    expect(refusal_of(database_of({"CREATE TABLE a(b)"})), CLQ_FORMAT, "no table metadata: it is not of JuPedSim");
    expect(refused(good, 1, "INSERT INTO metadata VALUES('version','4'),('fps','5')"), CLQ_UNSUPPORTED,
           "version 4 of JuPedSim's format: 1 to 3 are read");
    expect(refused(good, 1, "INSERT INTO metadata VALUES('version','2')"), CLQ_FORMAT, "no fps in metadata");
    expect(refused(good, 1, "INSERT INTO metadata VALUES('version','2'),('fps','0')"), CLQ_FORMAT,
           "metadata has the fps 0: more than 0");
    expect(refused(good, 1, "INSERT INTO metadata VALUES('version','two'),('fps','5')"), CLQ_FORMAT,
           "metadata has the version 'two' instead of a number");
    Bytes wal = database_of(good);
    wal[18] = wal[19] = 2;
    expect(refusal_of(wal), CLQ_UNSUPPORTED, "the database is in WAL mode");
}

// A view could compute for ever; a function could, too.
TEST(TrajectoryRefusals, DatabasesThatComputeAreNotRead)
{
#ifndef CLAQUE_HAS_SQLITE3
    GTEST_SKIP() << "this build has no sqlite3";
#endif
    std::vector<std::string> statements = jupedsim_statements(3);
    statements.resize(2);
    statements.push_back(
        "CREATE VIEW trajectory_data(frame, id, pos_x, pos_y) AS WITH RECURSIVE r(i) AS (SELECT 1 "
        "UNION ALL SELECT i + 1 FROM r) SELECT i, 1, 0.0, 0.0 FROM r");
    const Refusal view = refusal_of(database_of(statements));
    EXPECT_EQ(view.status, CLQ_FORMAT);
    EXPECT_NE(view.text.find("'trajectory_data' is a view and no table"), std::string::npos) << view.text;
    statements[2] =
        "CREATE TABLE trajectory_data(frame INTEGER, id INTEGER, pos_y REAL, pos_x REAL GENERATED ALWAYS AS "
        "(length(hex(zeroblob(4000)))) VIRTUAL)";
    statements.push_back("INSERT INTO trajectory_data(frame, id, pos_y) VALUES(1, 1, 2.0)");
    const Refusal generated = refusal_of(database_of(statements));
    EXPECT_EQ(generated.status, CLQ_FORMAT);
    EXPECT_NE(generated.text.find("'trajectory_data' has columns that are computed"), std::string::npos)
        << generated.text;
    statements.resize(2);
    statements.push_back("CREATE VIRTUAL TABLE trajectory_data USING fts5(frame, id, pos_x, pos_y)");
    const Refusal fts = refusal_of(database_of(statements));
    EXPECT_EQ(fts.status, CLQ_FORMAT);
    EXPECT_NE(fts.text.find("'trajectory_data' is a virtual table"), std::string::npos) << fts.text;
}

TEST(TrajectoryRefusals, PackedDataThatAreDamagedAreNamed)
{
#ifdef CLAQUE_HAS_Z
    const Refusal refusal = refusal_of({0x1f, 0x8b, 8, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
    EXPECT_EQ(refusal.status, CLQ_FORMAT);
    EXPECT_NE(refusal.text.find("the gzip data are damaged"), std::string::npos) << refusal.text;
#else
    const Refusal refusal = refusal_of({0x1f, 0x8b, 8, 0});
    EXPECT_EQ(refusal.status, CLQ_UNSUPPORTED);
    EXPECT_NE(refusal.text.find("gzip is read by zlib"), std::string::npos) << refusal.text;
#endif
}

}  // namespace
}  // namespace claque::testing
