// What the cell check asks of a cell, in the units in which it is shown.
// clang-format off
//  item        value                                              limit    beyond it
//  link        longest of the round trips, ms                     <= 500   fails
//  controller  conditions that forbid a motion                    <= 0     fails (DRY: warns)
//  joints      the joint nearest the end of its range, deg        >= 0     fails
//  range       what the turn leaves of joint 6, deg               >= 0     fails
//  cable       joint 6 at its farthest from where it stands, deg  <= 370   fails
//  return      the start inside the range of joint 6, deg         >= 0     fails
//  volume      corners of the region inside both images, px       >= 0     fails (below 12: warns)
//  depth       standard deviation of depth at the far side, mm    <= 2     fails
//  exposure    saturated share of the region's image, %           <= 2     fails
//  brightness  mean level of the region's image, of 255           >= 25    fails
//  texture     median contrast of the region's image, levels      >= 3.5   fails
//  fill        textured pixels with a depth inside the region, %  >= 10    fails
//  surface     points inside the region                           >= 3000  fails
//  alone       area of what is more than 30 mm apart, mm²         <= 120   fails (8 … 30 mm: warns)
//              after the warm-up: of what stood still, mm²        <= 120   fails
//  joint       distance of the wrist from the region, mm          >= 40    fails
//              without alignment: still area at the arm, mm²      <= 120   fails
//  sweep       clearance of the turning gripper, mm               >= 20    fails
//  disk        free, MB                                           >= need  fails
//  duration    expected, min                                      <= 60    warns
// clang-format on
#pragma once

namespace gripscan {

struct CellLimits {
    double round_trip_ms = 500.0;
    double cable_deg = 370.0;        ///< the turn, the approach from below, and a little
    double volume_margin_px = 12.0;  ///< a matcher's patch; the border itself is the limit
    double depth_sd_mm = 2.0;
    double saturated_percent = 2.0;
    double least_brightness = 25.0;
    double least_contrast = 3.5;  ///< an ordinary sensor's noise alone gives 2
    double least_fill_percent = 10.0;
    double least_points = 3000.0;
    double apart_mm2 = 120.0;
    double wrist_mm = 40.0;  ///< half the thickness of a wrist
    double clearance_mm = 20.0;
    double duration_min = 60.0;
};

}  // namespace gripscan
