#include "core/procedure/remedy.h"

#include <array>

namespace gripscan {
namespace {

using enum LastResort;

constexpr int kAsPlanned = 1000;  ///< as many retakes as the plan allows

// In the order of Cause. A retake where one bad picture can look like the cause; a halving where a
// smaller step is easier, or tells causes apart.
constexpr std::array<Remedy, 17> kRemedies{{
    {1, false, kStopIfBad, "the step was not accepted", "look at both images and the two clouds"},
    {0, true, kStopIfBad, "the two views share too little surface",
     "see what hides the gripper from the cameras, or move the camera"},
    {0, false, kLockAxis, "the surface looks the same all around the axis",
     "fix a marker to the part, or tilt it"},
    {kAsPlanned, false, kStopIfBad, "the images show too little structure",
     "check focus and lens, and put more light or texture on the surface"},
    {kAsPlanned, false, kStopIfBad, "the exposure is wrong",
     "shade the reflection, or change light and exposure time"},
    {kAsPlanned, false, kStopIfBad, "the arm still moved during the exposure",
     "lengthen the settle time and see what shakes the arm"},
    {0, false, kStop, "another joint moved too",
     "bring joints 1 … 5 back to the start and find out what moved them"},
    {0, false, kStop, "the joint turns by another ratio than it reports",
     "check gear ratio, mastering and the unit of joint 6"},
    {0, false, kStop, "the joint stands beside its angle by a fixed amount",
     "check joint 6 for play, and approach every angle from the same side"},
    {1, false, kStop, "the joint turns the other way than it reports",
     "turn round the sign of joint 6, or the axis hint, in the cell settings"},
    {1, false, kStopIfBad, "the part has slipped where it is held",
     "grip the part again and start its turn anew, or tighten what the gripper is mounted with"},
    {1, false, kStopIfBad, "the gripper is loose",
     "tighten the gripper on the flange and start the turn again"},
    {1, false, kStop, "the camera has moved",
     "fix the camera, calibrate it to the robot again and start the turn again"},
    {1, true, kGatherRows, "the picture does not belong to the reported angle",
     "compare joint 6 on the pendant with the table, and leave the view out"},
    {0, false, kStop, "depths are distorted",
     "calibrate the stereo camera again and compare with a known dimension"},
    {1, true, kStopIfBad, "no alignment of the two views was found",
     "see whether both clouds show the gripper, and whether the region fits it"},
    {0, false, kStop, "the robot could not be read",
     "check the link and connect again; then take the step again"},
}};

}  // namespace

const Remedy& remedy_for(Cause cause) {
    return kRemedies[static_cast<std::size_t>(cause)];
}

}  // namespace gripscan
