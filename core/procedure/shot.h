// A picture that is to be taken.
#pragma once

namespace gripscan {

enum class ShotPurpose {
    kTurn,    ///< a row of the recording
    kWarmUp,  ///< finds the axis; not recorded
};

struct Shot {
    ShotPurpose purpose = ShotPurpose::kTurn;
    int index = 0;    ///< of the capture; −1, −2, … while warming up
    int attempt = 1;  ///< at this angle
    double commanded_rad = 0.0;  ///< turn since the first capture

    friend bool operator==(const Shot&, const Shot&) = default;
};

}  // namespace gripscan
