// claque bench keypose-choice, -path, -script, -error: the experiments of S3, and the errors of its key-poses.
#include "samples/cli/bench_keypose.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace cli
{

bool is_of_key_poses(const BenchArguments &a)
{
    return a.subject == "keypose-choice" || a.subject == "keypose-path" || a.subject == "keypose-script" ||
           a.subject == "keypose-error";
}

Json chart_of_lines(const std::string &title, const std::string &x, const std::string &y)
{
    return {{"claque", version()},
            {"kind", "lines"},
            {"title", title},
            {"x", {{"title", x}}},
            {"y", {{"title", y}, {"from", 0}}},
            {"series", Json::array()},
            {"columns", Json::array()},
            {"runs", Json::array()}};
}

const std::vector<std::string> &multitude_clips()
{
    static const std::vector<std::string> clips = {"cheer", "applaud", "stand_laugh", "stand_wave", "stand"};
    return clips;
}

double rate_of_200_hz(const clq_template *tmpl)
{
    std::vector<double> durations_s;
    double sum = 0;
    for (const std::string &name : multitude_clips()) {
        clq_clip_info clip = clq_clip_info_init();
        scenes::check(clq_template_get_clip(tmpl, clq_template_find_clip(tmpl, name.c_str()), &clip));
        durations_s.push_back(static_cast<double>(clip.duration_s));
        sum += durations_s.back();
    }
    // Each clip has a whole number of key-poses: lower the rate, starting from the one of 200 in all, until the
    // numbers add up to at most 200.
    double rate = 200 / sum;
    const auto poses = [&] {
        double all = 0;
        for (const double duration_s : durations_s) all += std::max(1.0, std::round(duration_s * rate));
        return all;
    };
    while (poses() > 200) rate *= 0.999;
    return rate;
}

Json bench_key_poses(const BenchArguments &a)
{
    if (a.subject == "keypose-choice") return key_pose_choice();
    scenes::Library library(thread_count(a.setup));
    if (a.subject == "keypose-error") return key_pose_error(library);
    return a.subject == "keypose-path" ? key_poses_along_path(a, library) : key_poses_by_script(a, library);
}

namespace
{

std::string cell(const Json &value)
{
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number_integer()) return std::to_string(value.get<long long>());
    char text[32];
    const double number = value.get<double>();
    std::snprintf(text, sizeof text, std::fabs(number) < 999.5 ? "%.3g" : "%.0f", number);
    return text;
}

}  // namespace

std::string markdown_of_key_poses(const Json &report)
{
    std::string text = report["note"].get<std::string>() + "\n\n|", line = "|";
    for (const Json &name : report["columns"]) {
        text += " " + name.get<std::string>() + " |";
        line += "---|";
    }
    text += "\n" + line + "\n";
    for (const Json &run : report["runs"]) {
        text += "|";
        for (const Json &name : report["columns"]) text += " " + cell(run[name.get<std::string>()]) + " |";
        text += "\n";
    }
    return text;
}

void print_key_poses(const Json &report)
{
    std::printf("%s\n", report["title"].get<std::string>().c_str());
    for (const Json &name : report["columns"])
        std::printf("%*s", &name == &report["columns"].front() ? -28 : 16, name.get<std::string>().c_str());
    std::printf("\n");
    for (const Json &run : report["runs"]) {
        for (const Json &name : report["columns"])
            std::printf("%*s", &name == &report["columns"].front() ? -28 : 16,
                        cell(run[name.get<std::string>()]).c_str());
        std::printf("\n");
    }
    if (report.contains("note")) std::printf("%s\n", report["note"].get<std::string>().c_str());
}

}  // namespace cli
