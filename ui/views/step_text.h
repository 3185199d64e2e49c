// What the step card says: heading, verdict, cause, evidence. Pure; numbers that change stand in
// back quotes where they are part of a sentence.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ui/theme/state.h"
#include "ui/views/snapshot.h"

namespace gripscan::ui {

/// The step that the card is about: the selected row of Table 1, or the last.
[[nodiscard]] std::optional<JudgedStep> shown_step(const Snapshot& snapshot);
/// Steps of the whole turn, by those taken and the size of those to come.
[[nodiscard]] int steps_planned(const ProcedureState& state);
[[nodiscard]] State state_of(Verdict verdict);

struct DialText {
    double turned_deg = 0.0;   ///< by steps that are not rejected
    double next_deg = 0.0;     ///< 0: none
    double refused_deg = 0.0;  ///< 0: none
    double robot_deg = 0.0;
    double whole_deg = 360.0;
};
[[nodiscard]] DialText dial_of(const Snapshot& snapshot);

struct HeadingLine {
    std::string_view label;  ///< "ICP sum"
    std::string value;       ///< "140.070°"
    std::string note;        ///< "+0.069°"
};
struct StepHeading {
    std::string title;  ///< "Step 14"
    std::string of;     ///< "of 36"; empty: there is no count yet
    std::vector<HeadingLine> lines;
};
[[nodiscard]] StepHeading heading_of(const Snapshot& snapshot);

struct VerdictWords {
    State state = State::kWaiting;
    std::string word;  ///< empty: the state's own
    std::string basis;
    bool basis_is_number = false;
    std::string sentence;
};
/// Of the shown step, or of what is going on, or what is waited for.
[[nodiscard]] VerdictWords verdict_of(const Snapshot& snapshot);

struct CauseText {
    std::string cause;   ///< "The step is too large for this side"
    std::string advice;  ///< one sentence; empty: none was given
};
/// Of a shown step that is not accepted; nothing for others.
[[nodiscard]] std::optional<CauseText> cause_of(const Snapshot& snapshot);

struct EvidenceText {
    std::string_view id;  ///< "evidence.overlap"
    std::string_view label;
    double value = 0.0;
    std::string_view unit;
    int decimals = 3;
    bool with_sign = false;
    double limit = 0.0;
    int limit_decimals = 3;
    bool at_least = false;
    State state = State::kAccept;
    std::string_view meaning;
    double excess = 0.0;  ///< 1: on the limit; orders rejected evidence
};
/// Worst first for a rejected step. Before the first view: the limits that steps will have, without
/// values. Empty where there is neither.
[[nodiscard]] std::vector<EvidenceText> evidence_rows(const Snapshot& snapshot);

/// Whose evidence it is, where that does not go without saying.
struct EvidenceCaption {
    std::string words;  ///< "Step 13, the one before"; empty: the shown step
    bool past = false;  ///< of the step before the one that is going on
};
[[nodiscard]] EvidenceCaption evidence_caption(const Snapshot& snapshot);

/// Joint 6 as the operator tells it, in MANUAL.
struct ToldAngle {
    std::string label;        ///< of the input
    double joint6_deg = 0.0;  ///< as told or read last; no number: neither
    std::string why_not;      ///< why it cannot be told now; empty: it can
};
[[nodiscard]] ToldAngle told_angle_of(const Snapshot& snapshot);

/// Why the turn does not go on by a step now; empty while it may.
[[nodiscard]] std::string why_step_waits(const Snapshot& snapshot);

}  // namespace gripscan::ui
