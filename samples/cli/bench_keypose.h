// The experiments of `claque bench keypose-...` with shared key-poses (S3): one function for each figure of the paper.
#pragma once

#include "samples/cli/bench.h"

namespace cli
{

// Each returns a line chart with its table: "columns", and "runs" with a number or a word for each column.
Json key_pose_choice();                                                        // Fig. 7
Json key_poses_along_path(const BenchArguments &a, scenes::Library &library);  // Fig. 11
Json key_poses_by_script(const BenchArguments &a, scenes::Library &library);   // Fig. 12
Json key_pose_error(scenes::Library &library);                                 // against exact skinning

// A chart without series and runs.
Json chart_of_lines(const std::string &title, const std::string &x, const std::string &y);

// The multitude's clips, and the rate at which they have 200 key-poses in all (S3 5).
const std::vector<std::string> &multitude_clips();
double rate_of_200_hz(const clq_template *tmpl);

}  // namespace cli
