#include "ui/views/fault_names.h"

#include <algorithm>
#include <array>

namespace gripscan::ui {
namespace {

constexpr std::array<FaultName, 22> kNames{
    {{"ratio", "Joint 6 turns 1.05 times what its encoder says"},
     {"sign", "Joint 6 turns the other way"},
     {"backlash", "Joint 6 lags by 0.8 deg once its weight passes the top"},
     {"loose", "The gripper tilts on the flange by about 3 deg, another way at every angle"},
     {"slip", "The gripper has moved out of the flange by 2.5 mm"},
     {"object_slip", "The object has slid between the fingers by 2 mm"},
     {"object_twist", "The object has turned between the fingers by 3 deg"},
     {"bump", "The camera has shifted by 4 mm"},
     {"intruder", "A rod lies in the registration area"},
     {"tool", "A screwdriver is left in the registration area"},
     {"shift", "Table, wall and fixtures stand elsewhere by 2 mm"},
     {"defocus", "The lens blurs by 4 px"},
     {"glare", "A saturated spot on the gripper, at one angle and in the first attempt alone"},
     {"delay", "An answer of the controller comes 3 s later", true},
     {"drop", "The connection is closed instead of an answer", true},
     {"garble", "An answer arrives as other letters", true},
     {"split", "An answer arrives byte by byte", true},
     {"halfopen", "The connection stays open and nothing comes any more", true},
     {"restart", "The controller starts again in the middle of a motion", true},
     {"estop", "Emergency stop in the middle of a motion", true},
     {"servo_off", "Servos off in the middle of a motion", true},
     {"limit", "From then on joint 6 may go no further", true}}};

std::string_view name_of(std::string_view fault) {
    return fault.substr(0, fault.find_first_of("@="));
}

}  // namespace

std::span<const FaultName> fault_names() {
    return kNames;
}

bool has_fault(std::span<const std::string> faults, std::string_view name) {
    return std::any_of(faults.begin(), faults.end(),
                       [&](const std::string& fault) { return name_of(fault) == name; });
}

std::vector<std::string> toggled(std::vector<std::string> faults, std::string_view name) {
    const auto taken =
        std::erase_if(faults, [&](const std::string& fault) { return name_of(fault) == name; });
    if (taken == 0) faults.emplace_back(name);
    return faults;
}

}  // namespace gripscan::ui
