// Chooses a format by the beginning of a file, then by its name.
#include <algorithm>

#include "lib/asset/trajectories/database.h"
#include "lib/asset/trajectories/readers.h"
#include "lib/asset/trajectories/text.h"
#include "lib/base/error.h"

namespace claque::asset
{

using base::fail;

namespace
{

constexpr size_t looked_at = 1 << 16;

bool ends_with(std::string_view text, std::string_view end)
{
    return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

// Comment lines and the first other line.
struct Head {
    std::string comments;  // lower case
    std::string_view first;
};

Head head_of(std::string_view text)
{
    Head head;
    Lines lines(text);
    for (std::string_view line; lines.next(line);) {
        line = trimmed(line);
        if (line.empty()) continue;
        if (line[0] != '#') {
            head.first = line;
            break;
        }
        head.comments += lower_case(line) + "\n";
    }
    return head;
}

bool has_all(const Fields &fields, std::initializer_list<const char *> names)
{
    return std::all_of(names.begin(), names.end(), [&](const char *name) { return fields.find(name) >= 0; });
}

// A table whose first row has names.
clq_trajectory_format by_names(const Head &head)
{
    Fields names;
    names.split(head.first, separator_of(head.first));
    if (has_all(names, {"t", "id", "x", "y"})) return CLQ_TRAJECTORY_PATHFINDER_CSV;
    if (has_all(names, {"time", "pedID", "posX", "posY"})) return CLQ_TRAJECTORY_CROWDIT;
    if (has_all(names, {"pedestrianId", "simTime"})) return CLQ_TRAJECTORY_VADERE;
    return CLQ_TRAJECTORY_AUTO;
}

// A table of numbers alone, blanks between.
clq_trajectory_format by_numbers(const Head &head, const std::string &name)
{
    Fields fields;
    fields.split(head.first, blanks);
    double number = 0;
    for (int i = 0; i < static_cast<int>(fields.count()); ++i)
        if (!read_number(fields[i], number)) return CLQ_TRAJECTORY_AUTO;
    double z = 1, speed_z = 1;
    if (fields.count() == 8 && read_number(fields[3], z) && read_number(fields[6], speed_z) && z == 0 && speed_z == 0 &&
        head.comments.empty())
        return CLQ_TRAJECTORY_OBSMAT;
    if (contains(name, "obsmat")) return CLQ_TRAJECTORY_OBSMAT;
    if (fields.count() < 4) return CLQ_TRAJECTORY_AUTO;
    const bool petrack =
        contains(head.comments, "petrack") || contains(head.comments, "x/m") || contains(head.comments, "x/cm");
    const bool report =
        contains(head.comments, "framerate") && (contains(head.comments, "#id") || contains(head.comments, "# id"));
    return report && !petrack ? CLQ_TRAJECTORY_JPSREPORT : CLQ_TRAJECTORY_PETRACK;
}

clq_trajectory_format by_content(const TrajectoryInput &input)
{
    if (is_sqlite(input.bytes, input.size)) return CLQ_TRAJECTORY_JUPEDSIM;
    std::string_view text = input.text().substr(0, looked_at);
    if (starts_with(text, "\xef\xbb\xbf")) text.remove_prefix(3);
    const size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
    text.remove_prefix(begin);
    if (starts_with(text, "<") || starts_with(text, "\xff\xfe") || starts_with(text, "\xfe\xff"))
        return CLQ_TRAJECTORY_SUMO;
    if (starts_with(text, "$VISION")) return CLQ_TRAJECTORY_VISWALK;
    if (starts_with(text, "{")) {
        const std::string_view first = text.substr(0, text.find_first_of(":}", 1));
        return contains(first, "\"scene\"") || contains(first, "\"track\"") ? CLQ_TRAJECTORY_TRAJNET
                                                                            : CLQ_TRAJECTORY_PATHFINDER_JSON;
    }
    const Head head = head_of(text);
    if (contains(head.first, "the number of splines")) return CLQ_TRAJECTORY_VSP;
    const clq_trajectory_format named = by_names(head);
    return named != CLQ_TRAJECTORY_AUTO ? named : by_numbers(head, input.name);
}

}  // namespace

clq_trajectory_format detect(const TrajectoryInput &input, const TrajectoryOptions &options)
{
    if (!options.columns.empty()) return CLQ_TRAJECTORY_TABLE;
    const clq_trajectory_format found = by_content(input);
    if (found != CLQ_TRAJECTORY_AUTO) return found;
    if (ends_with(lower_case(input.name), ".vsp")) return CLQ_TRAJECTORY_VSP;
    if (input.text().substr(0, 7) == "claqueR")
        fail(
            CLQ_ARGUMENT,
            "the file is a record of claque: clq_record_open and Record.load of Python play it, and 'claque tracks RUN "
            "--out RUN.txt' writes its positions");
    const Head head = head_of(input.text().substr(0, looked_at));
    if (head.first.empty()) fail(CLQ_FORMAT, "the file has no rows");
    fail(CLQ_ARGUMENT,
         "the format is not known: for a table give --columns id,frame,x,y (columns), --unit m (metres_per_unit) and, "
         "unless its times are in seconds, --rate 25 (rate_hz); the first row is %s",
         in_quotes(head.first).c_str());
}

}  // namespace claque::asset
