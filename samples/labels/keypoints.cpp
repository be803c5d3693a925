#include "samples/labels/keypoints.h"

namespace labels
{

const KeypointSet &coco_keypoints()
{
    static const KeypointSet set = {"coco",
                                    {"nose", "left_eye", "right_eye", "left_ear", "right_ear", "left_shoulder",
                                     "right_shoulder", "left_elbow", "right_elbow", "left_wrist", "right_wrist",
                                     "left_hip", "right_hip", "left_knee", "right_knee", "left_ankle", "right_ankle"},
                                    {{15, 13},
                                     {13, 11},
                                     {16, 14},
                                     {14, 12},
                                     {11, 12},
                                     {5, 11},
                                     {6, 12},
                                     {5, 6},
                                     {5, 7},
                                     {6, 8},
                                     {7, 9},
                                     {8, 10},
                                     {1, 2},
                                     {0, 1},
                                     {0, 2},
                                     {1, 3},
                                     {2, 4},
                                     {3, 5},
                                     {4, 6}},
                                    {}};
    return set;
}

const KeypointSet &smpl_keypoints()
{
    static const KeypointSet set = {
        "smpl",
        {"pelvis",     "left_hip",    "right_hip",    "spine1",      "left_knee",     "right_knee",
         "spine2",     "left_ankle",  "right_ankle",  "spine3",      "left_foot",     "right_foot",
         "neck",       "left_collar", "right_collar", "head",        "left_shoulder", "right_shoulder",
         "left_elbow", "right_elbow", "left_wrist",   "right_wrist", "left_hand",     "right_hand"},
        {{0, 1},   {0, 2},   {0, 3},   {1, 4},   {2, 5},   {3, 6},   {4, 7},   {5, 8},
         {6, 9},   {7, 10},  {8, 11},  {9, 12},  {9, 13},  {9, 14},  {12, 15}, {13, 16},
         {14, 17}, {16, 18}, {17, 19}, {18, 20}, {19, 21}, {20, 22}, {21, 23}},
        {}};
    return set;
}

}  // namespace labels
