// One function for each format. Each adds rows to the reading and says what the file tells of rate and unit. All throw
// base::Error and std::bad_alloc.
#pragma once

#include "lib/asset/trajectories/trajectories.h"

namespace claque::asset
{

void read_jupedsim(const TrajectoryInput &input, const TrajectoryOptions &options, Reading &reading);
void read_petrack(const TrajectoryInput &input, const TrajectoryOptions &options, Reading &reading);
void read_jpsreport(const TrajectoryInput &input, const TrajectoryOptions &options, Reading &reading);
// The bytes may be packed.
void read_sumo(const TrajectoryInput &input, const TrajectoryOptions &options, Reading &reading);
void read_vadere(const TrajectoryInput &input, const TrajectoryOptions &options, Reading &reading);
void read_pathfinder_csv(const TrajectoryInput &input, const TrajectoryOptions &options, Reading &reading);
void read_pathfinder_json(const TrajectoryInput &input, const TrajectoryOptions &options, Reading &reading);
void read_crowdit(const TrajectoryInput &input, const TrajectoryOptions &options, Reading &reading);
void read_viswalk(const TrajectoryInput &input, const TrajectoryOptions &options, Reading &reading);
void read_obsmat(const TrajectoryInput &input, const TrajectoryOptions &options, Reading &reading);
void read_vsp(const TrajectoryInput &input, const TrajectoryOptions &options, Reading &reading);
void read_trajnet(const TrajectoryInput &input, const TrajectoryOptions &options, Reading &reading);
void read_table(const TrajectoryInput &input, const TrajectoryOptions &options, Reading &reading);

// Throws base::Error (CLQ_ARGUMENT) if the format cannot be told from name and content.
clq_trajectory_format detect(const TrajectoryInput &input, const TrajectoryOptions &options);

const char *format_name(clq_trajectory_format format);

}  // namespace claque::asset
