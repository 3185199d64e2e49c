// What the Recognise page says: verdict, evidence, poses as a table. Pure.
#pragma once

#include <string>
#include <vector>

#include "ui/theme/theme.h"
#include "ui/views/recognition.h"
#include "ui/views/step_text.h"
#include "ui/views/table_text.h"

namespace gripscan::ui {

/// By which a found template is named in image, cloud and table: the gripper's colour, the object's
/// for the first object, weaker ones for others.
[[nodiscard]] Colour Theme::*colour_of_found(const ShownRecognition& shown, std::size_t i);

struct RecognitionVerdict {
    State state = State::kWaiting;
    std::string word;
    std::string sentence;  ///< numbers in back quotes
};
[[nodiscard]] RecognitionVerdict recognition_verdict(const Snapshot& snapshot);

/// What the score of a found template rests on.
[[nodiscard]] std::vector<EvidenceText> found_evidence(const ShownRecognition& shown,
                                                       std::size_t i);
/// Symmetry and the next best pose, as label and words.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> found_remarks(
    const FoundTemplate& found);

/// Three rows a template: in the camera's, the gripper's and the robot's frame; the grasp last.
[[nodiscard]] TableText poses_text(const ShownRecognition& shown);
/// The same for the clipboard: columns parted by tabulators, full precision, m and degrees.
[[nodiscard]] std::string poses_for_clipboard(const ShownRecognition& shown);

/// Where the robot says joint 6 stands against where the gripper shows it; empty: not both known.
struct WitnessText {
    std::string robot_deg;
    std::string gripper_deg;
    std::string difference_deg;
    State state = State::kAccept;
};
[[nodiscard]] std::optional<WitnessText> witness_of(const Snapshot& snapshot);

/// "view 3, 2 of 6 templates found"
[[nodiscard]] std::string view_words(const ShownRecognition& shown);

}  // namespace gripscan::ui
